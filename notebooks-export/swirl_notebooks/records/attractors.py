# %% [markdown]
# ## Attractors, each followed from cell to cell
# %%
sweep, attractors = group("sweep"), group("attractors")
axis = next(name for name in sweep["mean_S"].dims if sweep.sizes[name] > 1)
at = sweep[axis].values[attractors["cell"].values]
track = attractors["track"].values
rows = []
for number in np.unique(track[track >= 0]):
    its = track == number
    kind, period = (attractors[name].values[its][0] for name in ("kind", "period"))
    rows.append((number, kind, period, its.sum(), at[its].min(), at[its].max()))
print(f"{'track':>5s}  {'kind':20s}{'period':>6s}{'cells':>7s}   {axis}")
for number, kind, period, cells, low, high in rows:
    print(f"{number:5d}  {kind:20s}{period:6d}{cells:7d}   {low:.6g} to {high:.6g}")
# %%
figure, axes = plt.subplots(2, 1, figsize=(8, 5), sharex=True, layout="constrained")
for number, kind, period, *_ in sorted(rows, key=lambda row: -row[3]):
    its = track == number
    name = f"{period}-cycle" if kind == "cycle" else kind
    line, = axes[0].plot(at[its], attractors["share"].values[its], "o-", ms=3, lw=0.8, label=f"{number}: {name}")
    axes[0].vlines(at[its], attractors["share_low"].values[its], attractors["share_high"].values[its], color=line.get_color(), lw=0.6)
    axes[1].plot(at[its], attractors["mean_S"].values[its], "o-", ms=3, lw=0.8)
if len(rows) <= 12:
    axes[0].legend(fontsize="x-small")
axes[0].set(ylabel="share of the starts", title="bars: Wilson's interval at 95 %")
axes[1].set(xlabel=axis, ylabel=r"$\langle S\rangle$");
# %% [markdown]
# The shares of a cell add up to one, but for the starts that came to no attractor.
# %%
total = np.bincount(attractors["cell"].values, attractors["share"].values, sweep.sizes[axis])
print(f"cells: {len(total)}; their shares add up to {total.min():.6g} at least, {total.max():.6g} at most")
print(f"attractors that go on in another cell: {sum(row[3] > 1 for row in rows)} of {len(rows)}")
assert total.max() < 1 + 1e-12
