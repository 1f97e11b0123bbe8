# %% [markdown]
# ## Cells of a plane on which the number of fixed points and their stability are proven constant
# %%
first, second = (str(settings["settings"][name]) for name in ("first", "second"))
cells = group("cells")
proven = cells["proven"].values.astype(bool)
area = ((cells["first_high"] - cells["first_low"]) * (cells["second_high"] - cells["second_low"])).values
area = area / area.sum()
print(f"{len(proven)} cells, {proven.sum()} of them proven: {100 * area[proven].sum():.4f} % of the plane")
counts = cells[["fixed_points", "attracting", "saddles", "repelling"]].to_dataframe()[proven]
counts.assign(share=area[proven]).groupby(list(counts.columns), as_index=False).sum().sort_values("share", ascending=False)
# %%
from matplotlib.collections import PolyCollection
corners = [[(a, c), (b, c), (b, d), (a, d)] for a, b, c, d in zip(*(cells[name].values for name in ("first_low", "first_high",
                                                                                          "second_low", "second_high")))]
figure, axes = plt.subplots(figsize=(6.5, 5), layout="constrained")
values = np.ma.masked_where(~proven, cells["attracting"].values)
palette = plt.get_cmap("YlGnBu").copy()
palette.set_bad("black")
drawn = axes.add_collection(PolyCollection(corners, array=values, cmap=palette, edgecolors="none", antialiased=False, rasterized=True))
figure.colorbar(drawn, label="attracting fixed points")
axes.autoscale()
axes.set(xlabel=first, ylabel=second, title="black: not proven, holds all curves");
# %% [markdown]
# ## What is not certain of the others
# %%
doubts, many = np.unique(cells["doubt"].values[~proven], return_counts=True)
print(", ".join(f"{doubt}: {count}" for doubt, count in zip(doubts, many)) or "nothing")
# %% [markdown]
# ## Is the record consistent?
# The cells are the plane, the counts add up, and the share is the one that is stated.
# %%
plane = [settings["settings"][f"{name}_{end}"] for name in ("first", "second") for end in ("low", "high")]
whole = (plane[1] - plane[0]) * (plane[3] - plane[2])
sides = ((cells["first_high"] - cells["first_low"]) * (cells["second_high"] - cells["second_low"])).values.sum()
assert abs(sides / whole - 1) < 1e-9
assert (counts["attracting"] + counts["saddles"] + counts["repelling"] == counts["fixed_points"]).all()
assert abs(area[proven].sum() - settings["result"]["proven_area"]) < 1e-9
