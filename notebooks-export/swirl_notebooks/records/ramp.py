# %% [markdown]
# ## The loop
# %%
along = settings.get("settings", {}).get("along", "parameter")
windows = group("windows")
figure, axes = plt.subplots(figsize=(8.5, 4.2), layout="constrained")
for way in np.unique(windows["way"]):
    rows = windows.isel(window=(windows["way"] == way).values)
    rises = float(rows["parameter"][-1]) >= float(rows["parameter"][0])
    axes.plot(rows["parameter"], rows["mean_S"], lw=1.2, color="C0" if rises else "C1", label=f"way {int(way)}, {'up' if rises else 'down'}")
axes.legend()
axes.set(xlabel=along, ylabel=r"mean $S$ of a window");
# %% [markdown]
# ## Modes that were kept, and where they were left
# %%
with h5py.File(path) as file:
    kept = "modes" in file
columns = ["way", "period", "kept_from", "left_at", "mean_S", "end", "end_at", "delay", "predicted_delay"]
modes = group("modes") if kept else None
modes[[name for name in columns if name in modes]].to_dataframe() if kept else "none"
