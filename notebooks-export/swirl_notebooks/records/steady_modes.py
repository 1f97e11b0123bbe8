# %% [markdown]
# ## Steady modes in closed form
# %%
facts, modes = group("facts").attrs, group("steady_modes")
for name, value in facts.items():
    print(f"{name}: {value}")
# %%
if "tau" in modes:
    print(modes[["tau", "S", "chi", "speed"]].to_dataframe().head(10).to_string())
    figure, axes = plt.subplots(figsize=(6, 3.6), layout="constrained")
    axes.plot(modes["tau"], modes["S"], "o", ms=4, mfc="none")
    axes.set(xlabel=r"flight time $\omega_s\tau$", ylabel="$S$")
# %% [markdown]
# $S = 1 - 2\pi j/(N\tau)$ for each of them.
# %%
if "tau" in modes and settings["scene"]["sides"] != "disk" and settings["scene"]["mu"] > 0:
    S = 1 - 2 * np.pi * modes["j"] / (float(settings["scene"]["sides"]) * modes["tau"])
    error = float(abs(S - modes["S"]).max())
    print(f"largest difference from that formula: {error:.1e}")
    assert error < 1e-9
