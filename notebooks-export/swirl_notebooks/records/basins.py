# %% [markdown]
# ## Basins of attraction
# One start in each cell: what it came to.
# %%
sweep, basins = group("sweep"), group("basins")
basins[["mode", "kind", "period", "mean_S", "starts", "share", "share_low", "share_high"]].to_dataframe()
# %%
from matplotlib.colors import BoundaryNorm

place = sweep["basin"]
wide = [name for name in place.dims if sweep.sizes[name] > 1]
axis = [name for name in wide if sweep[name].dtype.kind in "iuf"][:2] or [place.dims[0]]
flat = place.isel({name: 0 for name in place.dims if name not in axis})
at = ", ".join(f"{name} = {flat[name].item()}" for name in place.dims if name not in axis)
with h5py.File(path) as file:
    boundary = group("boundary") if "boundary" in file else None
    saddles = group("saddles") if "saddles" in file else None
figure, axes = plt.subplots(figsize=(6, 4.4), layout="constrained")
count = basins.sizes["basin"]
if len(axis) == 2:
    norm = BoundaryNorm(np.arange(count + 1) - 0.5, 256)
    cells = axes.pcolormesh(flat[axis[0]], flat[axis[1]], flat.where(flat >= 0).transpose(*reversed(axis)), cmap="cividis", norm=norm)
    figure.colorbar(cells, ticks=range(count), label="basin")
    if boundary is not None and not at:
        axes.plot(boundary[axis[0]], boundary[axis[1]], "o", ms=5, mec="k", mfc="w")
else:
    axes.plot(flat[axis[0]], flat.where(flat >= 0), "o", ms=4)
axes.set(xlabel=axis[0], ylabel=axis[1] if len(axis) == 2 else "basin", title=at);
# %% [markdown]
# ## What lies on the boundaries
# %%
columns = ["kind", "period", "mean_S", "index", "multiplier", "places", "share"]
saddles[columns].to_dataframe() if saddles is not None else "no saddles were looked for, or none was found"
# %% [markdown]
# The shares are those of the cells.
# %%
for basin, share in enumerate(basins["share"].values):
    counted = float((place == basin).mean())
    print(f"basin {basin}: share {share:.6g}, counted from the cells {counted:.6g}")
    assert abs(counted - share) < 1e-12
print(f"without a verdict: {float((place < 0).mean()):.6g}")
