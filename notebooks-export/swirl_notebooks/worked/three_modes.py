# %% [markdown]
# # Three modes, side by side
# The same hexagon settles to one state, to a cycle of states, or to none. Each record lists 160 impacts after 10,000 that
# were left out; each verdict is that of `swirl classify`.
# %% [commands]
# swirl simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --skip 10000 --collisions 10160 -o steady.h5
# swirl simulate --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 --skip 10000 --collisions 10160 -o quasi-steady.h5
# swirl simulate --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1 --skip 10000 --collisions 10160 -o chaotic.h5
# swirl classify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 -o steady-verdict.h5
# swirl classify --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 -o quasi-steady-verdict.h5
# swirl classify --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1 -o chaotic-verdict.h5
# %% [made]
# # What of these records the notebook needs: a smaller one.
# import h5py
# with h5py.File("three.h5", "w") as three:
#     for mode in ("steady", "quasi-steady", "chaotic"):
#         with h5py.File(f"{mode}.h5") as orbit, h5py.File(f"{mode}-verdict.h5") as verdict:
#             group = three.create_group(mode)
#             for name in ("t", "psi", "spin", "x", "y", "vx", "vy"):
#                 group.create_dataset(name, data=orbit["collisions"][name][:])
#             group.attrs.update(dict(orbit["scene"].attrs))
#             group.attrs.update(dict(verdict["mode"].attrs))
# %% [files]
# three.h5
# %%
import h5py, matplotlib.pyplot as plt, numpy as np

modes = {}
with h5py.File(folder / "three.h5") as file:
    for name in ("steady", "quasi-steady", "chaotic"):
        modes[name] = {key: data[:] for key, data in file[name].items()}, dict(file[name].attrs)
for name, (_, verdict) in modes.items():
    exponent = verdict["largest_exponent"]
    said = "negative" if exponent < -5 * verdict["largest_exponent_error"] else "positive" if exponent > 0 else "zero"
    print(f"{name}: {verdict['mode']}, {verdict['kind']}, period {verdict['period'] or 'none'}; exponent {said}")
    assert verdict["mode"] == name
# %% [markdown]
# ## Spin, section, and path
# Above: S impact by impact. Middle: ψ and S just after the impacts, one point, eight, or a cloud. Below: the centre's places
# at the impacts in axes that turn with the swirl.
# %%
figure, axes = plt.subplots(3, 3, figsize=(9, 7.5), layout="constrained")
for column, (name, (orbit, _)) in enumerate(modes.items()):
    turned = (orbit["x"] + 1j * orbit["y"]) * np.exp(-1j * orbit["t"])
    axes[0, column].plot(orbit["spin"][:60], "o-", ms=2, lw=0.5)
    axes[0, column].set(title=name, xlabel="impact", ylabel="$S$")
    axes[1, column].plot(orbit["psi"], orbit["spin"], "o", ms=2)
    axes[1, column].set(xlabel=r"$\psi$", ylabel="$S$", xlim=(-np.pi, np.pi))
    if np.ptp(orbit["spin"]) < 1e-6:  # one value: no axis of rounding errors
        for panel in axes[:2, column]:
            panel.set_ylim(orbit["spin"][0] - 1, orbit["spin"][0] + 1)
    axes[2, column].plot(turned.real, turned.imag, "o", ms=2)
    axes[2, column].set(aspect="equal", xlabel="$x/R_c$", ylabel="$y/R_c$", xlim=(-1.2, 1.2), ylim=(-1.2, 1.2))
# %% [markdown]
# ## The recurrence rate reads the period
# RC = (1/n²) Σ [|S_i − S_j| ≤ δ]: k values that are visited equally often give 1/k.
# %%
for name, (orbit, verdict) in modes.items():
    S = orbit["spin"]
    near = abs(S[:, None] - S) <= 1e-6
    n = len(S)
    print(f"{name}: RC = {near.mean():.4f}, without its diagonal {(near.sum() - n) / (n * (n - 1)):.4f}")
    if verdict["period"]:
        assert abs(near.mean() - 1 / verdict["period"]) < 1e-12
# %% [markdown]
# With the diagonal RC cannot fall below 1/n, which is why the rule "chaotic if RC < 10⁻⁴" needs more than 10,000 impacts, or
# the diagonal left out.
