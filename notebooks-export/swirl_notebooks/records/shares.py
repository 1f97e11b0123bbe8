# %% [markdown]
# ## Attractors, and the share of the starts that come to each
# %%
attractors, runs = group("attractors"), group("runs")
attractors[["share", "mode", "kind", "period", "mean_S"]].to_dataframe()
# %%
figure, axes = plt.subplots(1, 2, figsize=(9, 3), layout="constrained")
names = [f"{place}: {kind} {period or ''}"
         for place, (kind, period) in enumerate(zip(attractors["kind"].values, attractors["period"].values))]
axes[0].barh(names, attractors["share"])
axes[0].set(xlabel="share of the starts", xlim=(0, 1))
axes[1].plot(runs["mean_S"], "o", ms=4)
axes[1].set(xlabel="run", ylabel=r"$\langle S\rangle$");
# %%
count = runs.sizes["run"]
for place, share in enumerate(attractors["share"].values):
    found = (runs["attractor"].values == place).mean()
    print(f"attractor {place}: share {share:.6g}, counted from the runs {found:.6g}")
    assert abs(found - share) < 1e-12
