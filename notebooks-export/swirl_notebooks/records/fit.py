# %% [markdown]
# ## Restitution and friction
# %%
with h5py.File(path) as file:
    for name in ("restitution", "friction", "inertia"):
        found = file[f"fit/{name}"].attrs
        print(f"{name}: {found['value']:.5g} [{found['low']:.5g}, {found['high']:.5g}]")
fit = group("fit")
for name in ("law", "law_decided", "sign_of_spin", "sign_of_tangent", "impacts", "scatter", "predicted"):
    print(f"{name}: {fit.attrs[name]}")
# %%
group("laws").to_dataframe()
# %%
group("constancy").to_dataframe()
# %% [markdown]
# ## The profiles
# %%
figure, panels = plt.subplots(1, 2, figsize=(8, 3.2), layout="constrained")
for axes, name in zip(panels, ("restitution", "friction")):
    profile = group(f"{name}_profile")
    axes.plot(profile["value"], profile["deviance"])
    axes.axhline(3.84, color="0.6", lw=0.8)
    axes.set(xlabel=name, ylabel="deviance")
# %% [markdown]
# ## What single impacts ask for
# %%
impacts = group("impacts")
figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
told = impacts["weight"].values > 0
axes.scatter(impacts["approach_speed"].values[told], impacts["restitution"].values[told], s=6)
axes.axhline(0, color="0.6", lw=0.8)
axes.set(xlabel="speed of approach", ylabel="restitution, less the fit's");
