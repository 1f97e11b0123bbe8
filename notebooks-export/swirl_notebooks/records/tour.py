# %% [markdown]
# ## The modes of the built-in scenes
# %%
with h5py.File(path) as file:
    rows = {name: dict(file[name].attrs) for name in file if "mode" in file[name].attrs}
for name, row in rows.items():
    print(f"{name:24s}{row['mode']:14s}{row['kind']:20s}mean S {row['mean_S']:10.6g}   exponent {row['largest_exponent']:.3g}")
# %%
figure, axes = plt.subplots(figsize=(7, 2.8), layout="constrained")
axes.barh(list(rows), [row["mean_S"] for row in rows.values()])
axes.set(xlabel=r"$\langle S\rangle$");
