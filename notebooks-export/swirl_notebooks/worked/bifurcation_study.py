# %% [markdown]
# # A bifurcation study
# The steady mode of the hexagon (β = 0.5, μ = 0.5, e = 0.9), followed over its size α as a fixed point of the collision map,
# where it is stable and where it is not, beside what orbits settle on.
# %% [commands]
# swirl continue --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 \
#     --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.3:0.5 -o branches.h5
# swirl bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --along alpha=0.34:0.44:26 --starts 2 \
#     --transient 2000 --collisions 100 -o diagram.h5
# %% [files]
# branches.h5 diagram.h5
# %%
import matplotlib.pyplot as plt, numpy as np, xarray as xr

def group(file, name):
    return xr.open_dataset(folder / file, group=name, engine="h5netcdf")

branches, special = group("branches.h5", "branches"), group("branches.h5", "special")
samples = group("diagram.h5", "samples")
print(f"{branches.sizes['point']} points on {len(np.unique(branches['branch']))} branches, "
      f"{special.sizes['special_point']} special points")
# %%
figure, axes = plt.subplots(2, 1, figsize=(8, 5.6), sharex=True, layout="constrained", height_ratios=(3, 1))
axes[0].plot(samples["parameter"], samples["S"], ".", ms=1.5, color="0.6")
for branch in np.unique(branches["branch"]):
    on = branches.isel(point=(branches["branch"] == branch).values)
    stable = on["stable"].values != 0
    for S in on["S"].values.T:
        line, = axes[0].plot(on["parameter"], S, "--", lw=0.9)
        axes[0].plot(on["parameter"], np.where(stable, S, np.nan), lw=2, color=line.get_color())
    axes[1].plot(on["parameter"], on["largest_multiplier"], lw=1)
axes[0].set(ylabel="$S$ just after each impact", title="full: stable; dashed: unstable; grey: what orbits settle on")
axes[1].axhline(1, color="0.6", lw=0.8)
axes[1].set(xlabel=r"$\alpha = R_p/R_c$", ylabel=r"largest $|\lambda|$", ylim=(0, 3));
# %% [markdown]
# ## Where the steady mode is born and lost
# At a flip a multiplier passes through −1, and a cycle of period 2 branches off; at a Neimark–Sacker point a pair passes
# through the unit circle, and a torus begins.
# %%
found = {}
for kind, alpha, period in zip(special["kind"].values, special["parameter"].values, special["period"].values):
    if period == 1:
        found.setdefault(str(kind), []).append(float(alpha))
for kind, places in sorted(found.items()):
    print(f"{kind} of the fixed point at alpha = {', '.join(f'{place:.6f}' for place in sorted(places))}")
flip, torus = found["flip"][0], min(found["neimark-sacker"])
assert 0.36 < flip < 0.37 < torus < 0.45
# %% [markdown]
# ## Do orbits agree?
# Between the two the fixed point attracts; outside, no orbit stays there.
# %%
columns = group("diagram.h5", "attractors")
alpha, period = columns["parameter"].values, columns["period"].values
between = (alpha > flip) & (alpha < torus)
print(f"orbits between them: {between.sum()}, of which {np.sum(period[between] == 1)} are steady")
print(f"orbits outside: {np.sum(~between)}, of which {np.sum(period[~between] == 1)} are steady")
assert np.sum(period[between] == 1) > 0
fixed = branches.isel(point=((branches["period"] == 1) & (branches["stable"] != 0)).values).sortby("parameter")
steady = (period == 1) & between
expected = np.interp(alpha[steady], fixed["parameter"], fixed["mean_S"])
near = abs(expected - columns["mean_S"].values[steady])
print(f"mean S of the steady orbits is that of the branch within 1e-3: {bool(near.max() < 1e-3)}")
