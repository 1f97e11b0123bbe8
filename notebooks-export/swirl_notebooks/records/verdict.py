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
    axes[0].set(xlabel=r"$\psi$", ylabel="$S$", title="On the section, after the transient")
    axes[1].plot(points["S"].values[:100], "o-", ms=2, lw=0.6)
    axes[1].set(xlabel="impact", ylabel=r"$S = \omega_p/\omega_s$")
# %% [markdown]
# ## The period, from the impacts themselves
# The smallest k after which the section point is the same again, to 1e-9.
# %%
if has_orbit:
    z = points.values
    period = next((k for k in range(1, len(z) // 2) if abs(z[k:] - z[:-k]).max() < 1e-9), 0)
    print(f"period from the impacts: {period or 'none'}; in the record: {mode.attrs['period'] or 'none'}")
