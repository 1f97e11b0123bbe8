# %% [markdown]
# # First orbit
# A hexagon with α = R_p/R_c = 0.4 in a container that is swirled on a circle of β = r_s/R_c = 0.5; friction μ = 0.5,
# restitution e = 0.9. Lengths are in units of the container's radius, times in 1/ω_s, and S = ω_p/ω_s is the spin.
#
# The record of its first 400 impacts was made by
# %% [commands]
# swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 400 -o orbit.h5
# %% [files]
# orbit.h5
# %%
import matplotlib.pyplot as plt, numpy as np, xarray as xr

impacts = xr.open_dataset(folder / "orbit.h5", group="collisions", engine="h5netcdf")
scene = xr.open_dataset(folder / "orbit.h5", group="scene", engine="h5netcdf").attrs
print(", ".join(f"{name} = {value}" for name, value in scene.items()))
# %% [markdown]
# ## It settles
# S changes at impacts and at no other time. Then each flight is like the one before.
# %%
t, S = impacts["t"].values, impacts["spin"].values
figure, axes = plt.subplots(figsize=(8, 3), layout="constrained")
axes.step(t, S, where="post", lw=1)
axes.set(xlabel=r"$\omega_s t$", ylabel=r"$S = \omega_p/\omega_s$");
# %% [markdown]
# Just after an impact the state is z = (ψ, χ, v_n, v_t, S), in axes that turn with the swirl; from one impact to the next
# z becomes F(z). A *steady* mode is a fixed point, F(z) = z.
# %%
names = ["psi", "chi", "vn", "vt", "spin"]
z = np.column_stack([impacts[name] for name in names])
step = abs(np.diff(z, axis=0)).max(axis=1)
figure, axes = plt.subplots(figsize=(8, 2.6), layout="constrained")
axes.semilogy(np.maximum(step, 1e-17), lw=1)
axes.set(xlabel="impact", ylabel=r"$|z_{n+1} - z_n|$")
for name, value in zip(names, z[-1]):
    print(f"{name:5s}{value:10.6f}")
# %%
print(f"largest |F(z) - z| of the last 10 impacts: below 1e-3: {bool(step[-10:].max() < 1e-3)}")
rate = (step[-20:].max() / step[-220:-200].max()) ** (1 / 200)
print(f"the distance falls by a factor {rate:.2f} an impact")
assert step[-10:].max() < 1e-3 and rate < 1
# %% [markdown]
# ## What the steady mode says of itself
# From one impact to the next the hexagon turns by j vertices less than the swirl: S = 1 − 2πj/(Nτ), with τ the flight time.
# And all that the impact gives points through the body's centre, β sin(ψ + χ) = −sin χ.
# %%
tau = impacts["flight_time"].values[-1]
j = (1 - S[-1]) * 6 * tau / (2 * np.pi)
psi, chi = z[-1, 0], z[-1, 1]
print(f"S = {S[-1]:.4f}, flight time {tau:.4f}, vertices j = {j:.3f}")
through = scene["beta"] * np.sin(psi + chi) + np.sin(chi)
print(f"beta sin(psi + chi) = -sin chi within 1e-3: {bool(abs(through) < 1e-3)}")
assert abs(j - 2) < 1e-3 and abs(through) < 1e-3
# %% [markdown]
# ## The energy in the swirling frame
# J = E − ω_s L changes by two parts at each impact, restitution and friction; the record lists both.
# %%
J = impacts["jacobi"].values
parts = impacts["jacobi_restitution"].values + impacts["jacobi_friction"].values
error = abs(np.diff(J) - parts[1:]).max()
print(f"J adds up to rounding: {bool(error < 1e-14)}")
print(f"in the steady mode: restitution {impacts['jacobi_restitution'].values[-1]:.3f}, "
      f"friction {impacts['jacobi_friction'].values[-1]:.3f}")
assert error < 1e-14
