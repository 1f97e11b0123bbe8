# %% [markdown]
# ## Modes of the scenes of a table
# Each cell is a row of the table, a scene of its own.
# %%
sweep = group("sweep")
parameters = [name for name in sweep.data_vars if sweep[name].attrs.get("long_name") == f"parameter {name.replace('_', '-')}"]
share = sweep["share"].transpose("cell", "mode")
most = sweep["mode"].values[share.argmax("mode").values]
sweep[[*parameters, "mean_S", "mean_S_error", "largest_exponent"]].to_dataframe().assign(mode=most).head(30)
# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
scene, below = 1 + np.arange(sweep.sizes["cell"]), np.zeros(sweep.sizes["cell"])
for mode in share["mode"].values:
    axes[0].bar(scene, share.sel(mode=mode), bottom=below, label=str(mode))
    below += share.sel(mode=mode).values
axes[0].legend(fontsize="x-small")
axes[0].set(xlabel="scene, by row", ylabel="share of the starts")
axes[1].errorbar(scene, sweep["mean_S"], sweep["mean_S_error"].fillna(0), fmt="o", ms=4)
axes[1].set(xlabel="scene, by row", ylabel=r"$\langle S\rangle$")
for panel in axes:
    panel.xaxis.get_major_locator().set_params(integer=True)
# %% [markdown]
# The shares of a scene add up to one.
# %%
total = share.sum("mode").values
print(f"scenes: {total.size}; shares add up to 1 within {abs(total - 1).max():.1e}")
