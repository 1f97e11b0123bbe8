# %% [markdown]
# ## Modes over the grid
# %%
sweep = group("sweep")
wide = [name for name in sweep["mean_S"].dims if sweep.sizes[name] > 1]
# A map needs numbers along both axes: laws, and sides with a disk, which have names, stand at one as the rest does.
axis = [name for name in wide if sweep[name].dtype.kind in "iuf"][:2] or wide[:1] or [sweep["mean_S"].dims[0]]
rest = [name for name in wide if name not in axis]
flat = sweep.isel({name: 0 for name in sweep["mean_S"].dims if name not in axis})
share = flat["share"].transpose(*axis, "mode")
figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
if rest:
    figure.suptitle(", ".join(f"{name} = {flat[name].item()}" for name in rest))
if len(axis) == 1:
    for mode in share["mode"].values:
        axes[0].plot(share[axis[0]], share.sel(mode=mode), "o-", ms=3, label=str(mode))
    axes[0].legend(); axes[0].set(xlabel=axis[0], ylabel="share of the starts")
    axes[1].errorbar(flat[axis[0]], flat["mean_S"], flat["mean_S_error"].fillna(0), fmt="o", ms=3)
    axes[1].set(xlabel=axis[0], ylabel=r"$\langle S\rangle$")
else:
    share.argmax("mode").plot(ax=axes[0], x=axis[0], y=axis[1], cmap="cividis", cbar_kwargs={"label": "place of the mode"})
    flat["mean_S"].plot(ax=axes[1], x=axis[0], y=axis[1], cmap="PuOr", center=0)
by_logarithm = {str(text).split("=")[0].replace("-", "_") for text in np.atleast_1d(settings["settings"]["grid"]) if str(text).endswith(":log")}
for panel in axes:
    if axis[0] in by_logarithm: panel.set_xscale("log")
    if len(axis) > 1 and axis[1] in by_logarithm: panel.set_yscale("log")
# %% [markdown]
# The shares of a cell add up to one.
# %%
print("modes:", ", ".join(f"{place} {name}" for place, name in enumerate(sweep["mode"].values)))
for mode in sweep["mode"].values:
    print(f"mean share of {mode}: {float(sweep['share'].sel(mode=mode).mean()):.6g}")
total = sweep["share"].sum("mode").values
print(f"cells: {total.size}; shares add up to 1 within {abs(total - 1).max():.1e}")
