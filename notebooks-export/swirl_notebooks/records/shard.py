# %% [markdown]
# ## A part of a sweep
# `swirl join` makes the record of the whole of it from all its parts.
# %%
shard = group("shard")
print(f"part {shard.attrs['number']} of {shard.attrs['of']}: {shard.sizes.get('cell', 0)} cells")
# %%
if "run_mode" in shard:
    names = np.array(shard["run_mode"].attrs["flag_meanings"].split())[shard["run_mode"].values]
    figure, axes = plt.subplots(figsize=(7, 3.2), layout="constrained")
    for mode in np.unique(names):
        cell, run = np.nonzero(names == mode)
        axes.plot(shard["cell"].values[cell], shard["run_mean_S"].values[cell, run], "o", ms=4, label=mode)
        print(f"{mode}: {len(cell)} of {names.size} runs")
    axes.legend(fontsize="x-small")
    axes.set(xlabel="number of the cell in the whole sweep", ylabel=r"$\langle S\rangle$")
# %% [markdown]
# The cells of part i of n are i - 1, i - 1 + n, ...
# %%
if "run_mode" in shard:
    left = shard["cell"].values % shard.attrs["of"]
    print(f"cell numbers modulo {shard.attrs['of']}: {np.unique(left)}")
    assert (left == shard.attrs["number"] - 1).all()
