# %% [markdown]
# ## The diagram
# %%
with h5py.File(path) as file:
    groups = set(file)
along = settings.get("settings", {}).get("along", "parameter")
figure, axes = plt.subplots(figsize=(8.5, 4.2), layout="constrained")
if "samples" in groups:
    samples = group("samples")
    axes.plot(samples["parameter"], samples["S"], ".", ms=1, color="0.5")
if "branches" in groups and group("branches").sizes.get("point", 0):
    branches = group("branches")
    for branch in np.unique(branches["branch"]):
        rows = branches.isel(point=(branches["branch"] == branch).values)
        stable = rows["stable"].values != 0
        for phase in rows["S"].values.T:
            line, = axes.plot(rows["parameter"], phase, lw=0.7, ls="--", alpha=0.7)
            axes.plot(rows["parameter"], np.where(stable, phase, np.nan), lw=1.8, color=line.get_color())
axes.set(xlabel=along, ylabel=r"$S$ just after each impact", title="full: stable, dashed: unstable");
# %% [markdown]
# ## Where branches change
# %%
special = group("special") if "special" in groups else None
special[["kind", "parameter", "period", "largest_multiplier"]].to_dataframe() if special is not None else "none"
# %% [markdown]
# At a flip or Neimark-Sacker point a multiplier lies on the unit circle.
# %%
if special is not None and special.sizes.get("special_point", 0):
    critical = np.isin(special["kind"].values, ["flip", "neimark-sacker"])
    if "located" in special:
        critical &= special["located"].values != 0
    for kind, at in zip(special["kind"].values[critical], special["parameter"].values[critical]):
        print(f"{kind} at {along} = {at:.9g}")
