# %% [markdown]
# ## The spectrum and its lines
# %%
spectrum = group("spectrum")
with h5py.File(path) as file:
    peaks = group("peaks") if "peaks" in file else None
for name in ("verdict", "line_fraction", "entropy", "variance", "segments"):
    value = spectrum.attrs.get(name)
    if value == value:  # nan: it has none, as what is constant has no entropy
        print(f"{name}: {value}")
# %%
f, power = spectrum["frequency"].values, spectrum["power"].values
figure, axes = plt.subplots(figsize=(8, 3.4), layout="constrained")
if (power > 0).any():
    axes.semilogy(f[power > 0], power[power > 0], lw=0.7)
axes.set(xlabel="frequency", ylabel="power per unit of frequency");
# %%
table = peaks[["frequency", "power", "amplitude", "spread"]].to_dataframe() if peaks is not None else None
table.sort_values("power", ascending=False).head(8) if table is not None else "no peaks"
# %% [markdown]
# The integral of the power is the variance.
# %%
total = power.sum() * float(spectrum.attrs["frequency_step"])
print(f"integral of the power: {total:.6g}; variance: {float(spectrum.attrs['variance']):.6g}")
