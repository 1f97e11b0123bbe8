# %% [markdown]
# ## Exponents
# %%
data = group("lyapunov")
for value, error in zip(data["exponents"].values, data["standard_errors"].values):
    print(f"{value:12.6g}" + (f" +- {error:.2g}" if np.isfinite(error) else "") + " per impact")
# %%
figure, axes = plt.subplots(figsize=(8, 3.4), layout="constrained")
means = np.where(np.isfinite(data["convergence"].values), data["convergence"].values, np.nan)
axes.semilogx(data["checkpoint"], means)
axes.axhline(0, color="0.6", lw=0.8)
settled = means[len(means) // 2:][:, np.isfinite(means[-1])]
if settled.size:
    room = 0.3 * (np.ptp(settled) or 1)
    axes.set_ylim(settled.min() - room, settled.max() + room)
axes.set(xlabel="impacts counted", ylabel="running mean, per impact");
# %%
exponents = data["exponents"].values
print(f"their sum: {exponents.sum():.6g}")
