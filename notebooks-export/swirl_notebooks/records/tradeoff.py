# %% [markdown]
# ## Accuracy against cost
# Errors and missed contacts are told by comparison with the last rung, which has none of its own (nan).
# %%
rungs = group("rungs")
for name, seconds, error, missed in zip(rungs["name"].values, rungs["seconds_per_collision"].values, rungs["error"].values,
                                        rungs["missed_contacts"].values):
    print(f"{name}: {1e9 * seconds:.0f} ns a collision, error of one step {error:.2g}, contacts missed {missed:.0f}")
# %%
figure, axes = plt.subplots(figsize=(6, 3.4), layout="constrained")
compared = rungs["error"].values > 0
axes.loglog(rungs["seconds_per_collision"].values[compared], rungs["error"].values[compared], "o")
for name, x, y in zip(rungs["name"].values[compared], rungs["seconds_per_collision"].values[compared],
                      rungs["error"].values[compared]):
    axes.annotate(str(name), (x, y), xytext=(6, 0), textcoords="offset points", va="center")
axes.set(xlabel="seconds per collision", ylabel="error of one step");
# %% [markdown]
# ## How many impacts a verdict needs
# %%
with h5py.File(path) as file:
    evidence = group("evidence") if "evidence" in file else None
for row in range(evidence.sizes.get("rung", 0) if evidence is not None else 0):
    at = {name: evidence[name].values[row] for name in ("collisions", "mode", "mean_S", "changed", "runs", "seconds")}
    print(f"{at['collisions']} impacts: {at['mode']}, mean S {at['mean_S']:.6g}; {at['changed']} of {at['runs']} starts "
          f"have another mode on the most; {at['seconds']:.2g} s")
