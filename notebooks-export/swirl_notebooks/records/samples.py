# %% [markdown]
# ## Modes at points that fill the box
# The cells are a sample, not a grid: each has its own parameters.
# %%
sweep = group("sweep")
parameters = [name for name in sweep.data_vars if sweep[name].attrs.get("long_name") == f"parameter {name.replace('_', '-')}"]
share = sweep["share"].transpose("cell", "mode")
most = sweep["mode"].values[share.argmax("mode").values]
sweep[[*parameters, "mean_S", "mean_S_error", "largest_exponent"]].to_dataframe().assign(mode=most).head(12)
# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
x, y = parameters[0], parameters[1] if len(parameters) > 1 else None
for mode in np.unique(most):
    of_mode = most == mode
    height = sweep[y].values[of_mode] if y else share.sel(mode=mode).values[of_mode]
    axes[0].plot(sweep[x].values[of_mode], height, "o", ms=4, label=f"{mode} ({of_mode.sum()})")
axes[0].legend(fontsize="x-small")
axes[0].set(xlabel=x, ylabel=y or "share of the starts", title="the mode that most starts came to")
if y:
    dots = axes[1].scatter(sweep[x], sweep[y], c=sweep["mean_S"], s=18, cmap="PuOr")
    figure.colorbar(dots, label=r"$\langle S\rangle$")
else:
    axes[1].plot(sweep[x], sweep["mean_S"], "o", ms=4)
axes[1].set(xlabel=x, ylabel=y or r"$\langle S\rangle$");
# %% [markdown]
# As the sample fills the box evenly, a mode's mean share estimates its part of the box.
# %%
for mode in sweep["mode"].values:
    mean = float(share.sel(mode=mode).mean())
    print(f"{mode}: {mean:.4f} of the box, to about {np.sqrt(mean * (1 - mean) / sweep.sizes['cell']):.2g}")
total = share.sum("mode").values
print(f"points: {total.size}; shares add up to 1 within {abs(total - 1).max():.1e}")
