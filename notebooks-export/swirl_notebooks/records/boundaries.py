# %% [markdown]
# ## Curves on which cycles bifurcate, or meet a border of the map
# %%
first, second = (str(settings["settings"][name]) for name in ("first", "second"))
ends, curves = group("curve_ends"), group("curves")
table = ends[["kind", "period", "begins_at", "ends_at"]].to_dataframe()
table["points"] = np.bincount(curves["curve"].values, minlength=len(table))
table
# %%
with h5py.File(path) as file:
    special = group("special") if "special" in file else None
figure, axes = plt.subplots(figsize=(6.5, 5), layout="constrained")
colours = {kind: f"C{place}" for place, kind in enumerate(np.unique(ends["kind"]))}
for curve, (kind, period) in enumerate(zip(ends["kind"].values, ends["period"].values)):
    rows = curves.isel(point=curves["curve"].values == curve)
    unstable = rows["largest_multiplier"].values > 1 + 1e-6  # on both sides
    look = {"color": colours[kind], "ls": ("-", "--", "-.", ":")[min(period, 4) - 1]}
    axes.plot(rows["first"], rows["second"], lw=0.7, **look)
    axes.plot(rows["first"], np.where(unstable, np.nan, rows["second"]), lw=1.8, label=f"{kind}, period {period}", **look)
if special is not None:
    axes.plot(special["first"], special["second"], "ko", ms=4, mfc="white")
    for kind, x, y in zip(special["kind"].values, special["first"].values, special["second"].values):
        axes.annotate(str(kind), (x, y), xytext=(4, 3), textcoords="offset points", size="x-small")
handles, labels = axes.get_legend_handles_labels()
axes.legend(*zip(*dict(zip(labels, zip(handles, labels))).values()), fontsize="x-small")
axes.set(xlabel=first, ylabel=second, title="thin: the cycle is unstable on both sides");
# %% [markdown]
# ## Points of codimension 2
# %%
special[["kind", "curve", "period", "first", "second"]].to_dataframe() if special is not None else "none"
# %% [markdown]
# ## Is the record consistent?
# On a fold a multiplier is 1, on a flip -1, on a Neimark-Sacker curve exp(i theta): the largest |multiplier| is 1 at least.
# %%
kinds = ends["kind"].values[curves["curve"].values]
critical = np.isin(kinds, ["fold", "flip", "neimark-sacker"])
for kind, theta in (("fold", 0), ("flip", np.pi)):
    assert (curves["angle"].values[kinds == kind] == theta).all()
if critical.any():
    least = curves["largest_multiplier"].values[critical].min()
    print(f"{critical.sum()} points with a multiplier on the unit circle; largest |multiplier|: {least:.9f} at least")
    assert least > 1 - 1e-6
inside = all(low <= values.min() and values.max() <= high for values, (low, high) in (
    (curves[name].values, [settings["settings"][f"{name}_{end}"] for end in ("low", "high")]) for name in ("first", "second")))
print(f"curves: {len(table)}, points: {len(kinds)}; all within the plane that was asked for: {inside}")
