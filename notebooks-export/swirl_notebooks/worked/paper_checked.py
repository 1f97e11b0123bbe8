# %% [markdown]
# # The paper, checked
# What G. Sun, *The Dynamics of a Polygon in a Swirling System* (research report, 2019), says of a swirled hexagon at e = 1,
# looked at with exact orbits. Each heading is a statement of the report; below it is what is found. The numbers here are
# from runs of seconds; the report's own were 50 starts of 2,000 to 4,000 impacts for each set of parameters.
# %% [commands]
# swirl simulate --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1 --collisions 4000 -o chaotic.h5
# swirl simulate --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 --skip 10000 --collisions 14000 -o cycle.h5
# swirl simulate --sides 6 --alpha 0.3 --beta 0.1 --mu 0 --restitution 1 --collisions 4000 -o frictionless.h5
# swirl sweep --sides 6 --alpha 0.3 --beta 0.1 --restitution 1 --grid mu=0:1:6 --runs 8 \
#     --transient 1000 --collisions 4000 -o friction.h5
# %% [made]
# # What of these records the notebook needs: a smaller one.
# import h5py, xarray
# with h5py.File("paper.h5", "w") as paper:
#     for name in ("chaotic", "cycle", "frictionless"):
#         with h5py.File(f"{name}.h5") as orbit:
#             group = paper.create_group(name)
#             for column in ("spin", "jacobi"):
#                 group.create_dataset(column, data=orbit["collisions"][column][:1500], compression=9, shuffle=True)
#     with xarray.open_dataset("friction.h5", group="sweep", engine="h5netcdf") as sweep:
#         for name in ("mu", "mean_S", "mean_S_error", "mean_S_per_impact"):
#             paper[f"friction/{name}"] = sweep[name].values
# %% [files]
# paper.h5
# %%
import h5py, matplotlib.pyplot as plt, numpy as np

with h5py.File(folder / "paper.h5") as file:
    spin = {name: file[name]["spin"][:] for name in ("chaotic", "cycle", "frictionless")}
    J = file["frictionless/jacobi"][:]
    mu, mean, error, per_impact = (file["friction"][name][:] for name in ("mu", "mean_S", "mean_S_error", "mean_S_per_impact"))

def recurrence_rate(S, delta=1e-6):
    """RC, with its diagonal and without."""
    near, n = (abs(S[:, None] - S) <= delta).sum(), len(S)
    return near / n**2, (near - n) / (n * (n - 1))
# %% [markdown]
# ## RC of two values that are visited equally often is 1/4
# By the report's own formula it is 1/2; k values visited equally often give 1/k. The cycle of eight impacts:
# %%
two = recurrence_rate(np.array([0.0, 1.0] * 500))[0]
eight = recurrence_rate(spin["cycle"][:1496])[0]
print(f"two values: RC = {two:.3f}; the cycle of eight: RC = {eight:.4f}")
assert two == 0.5 and abs(eight - 1 / 8) < 1e-12
# %% [markdown]
# ## In the chaotic mode RC < 10⁻⁴
# With the diagonal, as the formula has it, RC is 1/n at least: 2.5·10⁻⁴ for the 4,000 impacts of the report. Without it the
# statement holds.
# %%
rate = recurrence_rate(spin["chaotic"])
n = len(spin["chaotic"])
print(f"n = {n}: RC >= 1/n: {bool(rate[0] >= 1 / n)}; RC < 1e-4: {bool(rate[0] < 1e-4)}; "
      f"without the diagonal < 1e-4: {bool(rate[1] < 1e-4)}")
assert rate[0] >= 1 / n and rate[1] < 1e-4
# %% [markdown]
# ## The energy is constant in the steady mode: what is conserved at all
# Without friction and at e = 1 J, the energy in the swirling frame, is conserved at every impact: a test of impact, flight
# and frames at once. Written as J = ½|V − ẑ×X|² − ½|X|² + ½I(S − 1)² − ½I it says that S is 1 in the mean, if the orbit
# visits all that J allows.
# %%
change = abs(J - J[0]).max()
print(f"J changes by less than 1e-12 in {len(J)} impacts: {bool(change < 1e-12)}")
assert change < 1e-12
# %% [markdown]
# ## Without friction the rotation is positive in the mean, with friction negative and hardly dependent on μ (β = 0.1)
# %%
figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
axes.errorbar(mu, mean, error, fmt="o", capsize=3, label=r"time mean $\int S\,dt/T$")
axes.plot(mu, per_impact, "s", mfc="none", label="mean over the impacts")
axes.axhline(0, color="0.6", lw=0.8)
axes.set(xlabel=r"$\mu$", ylabel=r"$\langle S\rangle$")
axes.legend();
# %%
print(f"mu = 0: the time mean is positive: {bool(mean[0] > 0)}, and 1 within 5 standard errors: "
      f"{bool(abs(mean[0] - 1) < 5 * error[0] + 0.05)}")
print(f"mu > 0: mean over the impacts below that of mu = 0: {bool((per_impact[1:] < per_impact[0]).all())}")
print(f"time mean negative by two standard errors at the largest mu: {bool(mean[-1] < -2 * error[-1])}; "
      f"at the smallest, {mu[1]:.1f}: {bool(mean[1] < -2 * error[1])}")
for m, time_mean, e, impact_mean in zip(mu, mean, error, per_impact):
    print(f"~ mu = {m:.1f}: time mean {time_mean:+.3f} +- {e:.3f}, over the impacts {impact_mean:+.3f}")
# %% [markdown]
# With little friction the statement fails: at μ = 0.2 the time mean is not negative, and the sign can depend on which mean is
# taken. `notebooks-export/paper_claims.py` runs this again over α and for N = 3, 4, 6, 8 and the disk, with a verdict on
# each statement. What is **not** shown here: the report's figures over α and β (its parameters are not all stated), and the
# shares of its modes over them, which take sweeps of minutes (`swirl sweep`).
