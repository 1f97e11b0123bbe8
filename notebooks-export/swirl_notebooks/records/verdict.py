# %% [markdown]
# ## The verdict
# %%
mode = group("mode")
for name in ("mode", "kind", "period", "mean_S", "largest_exponent", "largest_exponent_error"):
    print(f"{name}: {mode.attrs.get(name)}")
# %%
mode[["value", "threshold", "says"]].to_dataframe() if "value" in mode else mode.attrs
# %%
with h5py.File(path) as file:
    has_orbit = "tail" in file
if has_orbit:
    tail = group("tail")
    points = tail["points"].to_series().unstack("coordinate")
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    axes[0].scatter(points["psi"], points["S"], c=np.arange(len(points)), s=4, cmap="cividis_r")
    axes[0].set(xlabel=r"$\psi$", ylabel="$S$", title="On the section")
    spin = points["S"].values[:100]
    axes[1].plot(tail.attrs["first"] + np.arange(len(spin)), spin, "o-", ms=2, lw=0.6)
    axes[1].set(xlabel="impact", ylabel=r"$S = \omega_p/\omega_s$")
# %% [markdown]
# ## Does the orbit come back?
# The distance of section points that are one period apart: where an attracting cycle is approached it falls.
# %%
period = int(mode.attrs["period"])
if has_orbit and 0 < period < len(points):
    turned = [part(points["psi"]) for part in (np.cos, np.sin)]  # psi is an angle: 3.14 is next to -3.14
    z = np.column_stack([points["vn"], points["vt"], points["S"], *turned])
    distance = abs(z[period:] - z[:-period]).max(axis=1)
    print(f"after {period} impact{'s' if period > 1 else ''}: {distance[0]:.2g} away at the tail's beginning, {distance[-1]:.2g} at its end")
else:
    print(f"period: {period or 'none'}; impacts in the record: {len(points) if has_orbit else 'none'}")
