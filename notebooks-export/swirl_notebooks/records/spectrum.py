# %% [markdown]
# ## The spectrum and its lines
# %%
spectrum, peaks = group("spectrum"), group("peaks")
for name in ("verdict", "line_fraction", "entropy", "variance", "segments"):
    print(f"{name}: {spectrum.attrs.get(name)}")
# %%
f, power = spectrum["frequency"].values, spectrum["power"].values
figure, axes = plt.subplots(figsize=(8, 3.4), layout="constrained")
axes.semilogy(f[power > 0], power[power > 0], lw=0.7)
axes.set(xlabel="frequency", ylabel="power per unit of frequency");
# %%
table = peaks[["frequency", "power", "amplitude", "spread"]].to_dataframe() if "frequency" in peaks else None
table.sort_values("power", ascending=False).head(8) if table is not None else "no peaks"
# %% [markdown]
# The integral of the power is the variance.
# %%
total = power.sum() * float(spectrum.attrs["frequency_step"])
print(f"integral of the power: {total:.6g}; variance: {float(spectrum.attrs['variance']):.6g}")
