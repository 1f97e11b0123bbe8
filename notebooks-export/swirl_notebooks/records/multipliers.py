# %% [markdown]
# ## Fixed points and cycles
# %%
orbits = group("orbits")
table = orbits[["period", "mean_S", "return_time", "stability", "residual"]].to_dataframe()
table["largest |multiplier|"] = np.hypot(orbits["multiplier_re"], orbits["multiplier_im"]).max("multiplier_index")
table.sort_values("largest |multiplier|").head(12)
# %%
figure, axes = plt.subplots(figsize=(4.6, 4.2), layout="constrained")
multipliers = orbits["multiplier_re"].values + 1j * orbits["multiplier_im"].values
near = abs(multipliers) < 3
axes.add_patch(plt.Circle((0, 0), 1, fill=False))
axes.plot(multipliers[near].real, multipliers[near].imag, "o", ms=4, mfc="none")
axes.set(aspect="equal", xlabel=r"Re $\lambda$", ylabel=r"Im $\lambda$", xlim=(-3, 3), ylim=(-3, 3),
         title=r"Multipliers with $|\lambda| < 3$");
# %% [markdown]
# Stable is what has all its multipliers inside the unit circle.
# %%
largest = np.nanmax(abs(multipliers), axis=1)
stable = orbits["stability"].values == "stable"
print(f"{len(largest)} orbits, {stable.sum()} stable")
assert (largest[stable] < 1).all()
