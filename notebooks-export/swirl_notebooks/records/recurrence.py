# %% [markdown]
# ## Measures of recurrence
# %%
data = group("recurrence")
for name in ("RR", "RC", "DET", "L", "Lmax", "ENTR", "LAM", "TT", "MRT", "TREND"):
    print(f"{name:6s}", " ".join(f"{value:.6g}" for value in data[name].values), " ", data[name].attrs["long_name"])
# %%
has_image = "image" in data
has_lines = "diagonal_lines" in data  # an estimate from random pairs has none
figure, axes = plt.subplots(1, 1 + has_image, figsize=(5 + 4 * has_image, 3.8), layout="constrained", squeeze=False)
lines = data["diagonal_lines"].values[0] if has_lines else np.zeros(1)
lengths = np.arange(len(lines))
axes[0, -1].loglog(lengths[lines > 0], lines[lines > 0], "o-", ms=3)
axes[0, -1].set(xlabel="length of a diagonal line", ylabel="number of lines")
if has_image:
    axes[0, 0].imshow(np.sqrt(data["image"].values), cmap="Greys", origin="lower", vmin=0, vmax=1)
    axes[0, 0].set(title="Recurrence plot")
# %% [markdown]
# L again, from the numbers of lines by their length.
# %%
kept = lengths >= int(settings["settings"]["min_diagonal"])
if not has_lines:
    errors = group("standard_errors").attrs
    print("estimated from random pairs; standard errors:", *(f"{name} {error:.2g}" for name, error in errors.items()))
elif lines[kept].sum() > 0:
    mean = (lengths * lines)[kept].sum() / lines[kept].sum()
    print(f"L from the lines: {mean:.6g}; in the record: {data['L'].values[0]:.6g}")
    assert abs(mean - data["L"].values[0]) < 1e-9 * mean
