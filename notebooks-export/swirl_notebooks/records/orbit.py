# %% [markdown]
# ## The orbit
# A row an impact: the state just after it, and what it did. In flight the centre moves uniformly and S is constant, unless
# the floor drags.
# %%
impacts = group("collisions")
impacts[["t", "psi", "vn", "vt", "spin", "flight_time"]].to_dataframe().head()
# %%
t, S, angle = impacts["t"].values, impacts["spin"].values, impacts["angle"].values
figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
axes[0].step(t[-100:], S[-100:], where="post", lw=1)
axes[0].set(xlabel=r"$\omega_s t$", ylabel=r"$S = \omega_p/\omega_s$", title=f"The last {len(t[-100:])} impacts")
dots = axes[1].scatter(impacts["psi"], S, c=t, s=4, cmap="cividis_r")
axes[1].set(xlabel=r"$\psi$", ylabel="$S$", title="On the section")
figure.colorbar(dots, label=r"$\omega_s t$");
# %% [markdown]
# The time mean of S: vertex 0's direction is $\int S\,dt$.
# %%
if len(t) > 1:
    print(f"{len(t)} impacts, t = {t[0]:.6g} to {t[-1]:.6g}")
    print(f"time mean of S over them: {(angle[-1] - angle[0]) / (t[-1] - t[0]):.9g}")
    print(f"mean of S per impact:     {S.mean():.9g}")
# %% [markdown]
# ## Is the record consistent?
# J, the energy in the swirling frame, changes only at impacts (and in contact with the wall): by restitution and by friction. A floor
# that drags takes some on every flight.
# %%
J = impacts["jacobi"].values
change = impacts["jacobi_restitution"].values + impacts["jacobi_friction"].values
dragged = settings.get("scene", {}).get("drag", 0) > 0
complete = not dragged and settings.get("settings", {}).get("every", 1) == 1 and group("contacts").sizes.get("contact", 0) == 0
if complete and len(t) > 1:
    error = abs(np.diff(J) - change[1:]).max()
    print(f"largest |change of J - its two parts|: {error:.1e}")
    assert error < 1e-12 * max(1, abs(J).max())
else:
    print("impacts were left out, there was contact with the wall, or the floor drags: the two parts are not all of the change")
