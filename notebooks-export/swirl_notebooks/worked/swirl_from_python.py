# %% [markdown]
# # Swirl from Python
# Each command of `swirl` is a function, each flag a keyword, each key of its document an attribute. This notebook computes: it wants
# the module `swirl` (docs/python.md).
#
# A hexagon with α = R_p/R_c = 0.635 in a dish that is swirled on a circle of β = r_s/R_c = 0.5; friction μ = 0.5, restitution
# e = 0.95:
# %%
import numpy as np
import swirl

scene = swirl.Scene(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95)
found = swirl.classify(scene)
print(f"{found.mode}, {found.kind} of period {found.period}, mean S {found.mean_S:.6f}")
assert found.period == 8
# %% [markdown]
# ## Orbits as arrays
# A result's record is an xarray Dataset, with units and meanings.
# %%
orbit = swirl.simulate(scene, collisions=2000)
impacts = orbit.to_xarray()
print(f"{impacts.sizes['collision']} impacts; S of the last eight: {np.round(impacts['spin'].values[-8:], 4)}")
print(f"the last S is that of eight impacts before within 1e-6: {bool(abs(impacts['spin'].values[-1] - impacts['spin'].values[-9]) < 1e-6)}")
orbit.plot("spin", width=6)
# %% [markdown]
# ## The map itself
# Just after an impact the state is z = (ψ, χ, v_n, v_t, S); `scene.map(z)` is the state after the next. Eight of them, applied to
# the cycle's first point, are the identity; the multipliers are the eigenvalues of the product of the derivatives.
# %%
point = np.array(found.point)
cycle = [point]
for _ in range(7):
    cycle.append(scene.map(cycle[-1]))
error = abs(scene.map(cycle[-1]) - point).max()
turn = np.linalg.multi_dot(scene.derivative(np.array(cycle))[::-1])
largest = abs(np.linalg.eigvals(turn)).max()
print(f"F applied eight times leads back within 1e-9: {bool(error < 1e-9)}; largest |multiplier| {largest:.4f}")
assert error < 1e-9 and largest < 1
# %% [markdown]
# Arrays of states go through it together, one in each lane of the processor's vectors, with the same bits as alone.
# %%
states = point + 1e-3 * np.random.default_rng(1).standard_normal((1000, 5))
after, outcome = scene.map(states, steps=400, outcomes=True)
distance = abs(after[:, None, :] - np.array(cycle)[None]).max(axis=2).min(axis=1)
print(f"of 1000 states beside the cycle {int((distance < 1e-4).sum())} are on it after 400 impacts")
assert np.array_equal(scene.map(states[7], steps=400), after[7], equal_nan=True)
# %% [markdown]
# ## A diagram and a map
# A range is (from, to, count), a list the values themselves. Where it takes long, Ctrl-C keeps what is finished.
# %%
diagram = swirl.bifurcate(scene, along={"alpha": (0.55, 0.7, 61)}, starts=2, transient=2000, collisions=500)
shares = {}
for column in diagram.columns:
    shares[column.mode] = shares.get(column.mode, 0) + 1
print("columns by mode: " + ", ".join(f"{mode} {count}" for mode, count in sorted(shares.items())))
diagram.plot(width=6)
# %%
modes = swirl.sweep(scene, grid={"alpha": (0.3, 0.8, 11), "mu": [0.1, 0.3, 0.5, 0.9]}, runs=2, transient=1000, collisions=500)
steady = sum(cell.modes.to_dict().get("steady", 0) for cell in modes.cells) / len(modes.cells)
print(f"{len(modes.cells)} cells; share of steady runs {steady:.2f}")
modes.plot(width=6)
# %% [markdown]
# ## What a measured series says
# NumPy, pandas and xarray go in as they are: here the angle of the body every tenth of a turn of the swirl.
# %%
sampled = swirl.simulate(scene, time=600, sample=0.6283185307179586).to_xarray("samples")
verdict = swirl.spectrum(series=np.diff(sampled["angle"].values[400:]), spacing=0.1)
print(f"strongest line at {max(verdict.peaks, key=lambda peak: peak.power).frequency:.2f} a turn of the swirl")
# %% [markdown]
# ## Wrong input
# is a ValueError, with the line that the command says.
# %%
try:
    scene.with_(alpha=1.5)
except ValueError as error:
    print(error)
