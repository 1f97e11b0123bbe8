# %% [markdown]
# # My own map
# What finds cycles, branches, exponents and basins of a body in a swirled dish does so for any map. Here it is Hénon's,
# x ↦ 1 − a x² + y, y ↦ 0.3 x, a Python function of the state and of a parameter; the numbers are held against published ones.
# This notebook computes: it wants the module `swirl` (docs/python.md, "Swirl from Python").
#
# In ten lines:
# %%
import numpy as np
from swirl import analysis

henon = analysis.Map(lambda z, a: (1 - a * z[0]**2 + z[1], 0.3 * z[0]),
                     jacobian=lambda z, a: [[-2 * a * z[0], 1], [0.3, 0]], dimension=2)
fixed = sorted(henon.cycles(period=1, parameter=1.4), key=lambda cycle: cycle.points[0, 0])
orbit = henon.orbit((0.1, 0.1), 160, 1.4)[40:]
counts = {k: len(henon.cycles(k, 1.4, starts=orbit)) for k in range(2, 8)}
branches = henon.continue_(henon.cycles(1, 0.1)[0], between=(-0.2, 1.06), switch=3)
exponents = henon.exponents((0.1, 0.1), 1.4, steps=6000)
basins = henon.basins(((-2.5, 2.5, 120), (-2.5, 2.5, 120)), 1.4)
# %% [markdown]
# ## Cycles
# The fixed points are the roots of 1.4 x² + 0.7 x − 1. Of cycles on the attractor there are as many as Biham and Wenzel found
# by another method (Phys. Rev. Lett. 63 (1989) 819).
# %%
roots = np.sort(np.roots([1.4, 0.7, -1]))
for cycle, root in zip(fixed, roots):
    print(f"x = {cycle.points[0, 0]:.6f}, {cycle.stability}; off the root by less than 1e-13: {bool(abs(cycle.points[0, 0] - root) < 1e-13)}")
    assert abs(cycle.points[0, 0] - root) < 1e-13
published = {2: 1, 3: 0, 4: 1, 5: 0, 6: 2, 7: 4}
print(f"cycles of minimal period 2 to 7: {list(counts.values())}; published: {list(published.values())}")
assert counts == published
# %% [markdown]
# ## Branches
# From the fixed point at a = 0.1 along a, and over to the cycle of twice the period at every flip. In closed form the fixed points
# begin in a fold at −(1 − b)²/4 and lose their stability at 3(1 − b)²/4; the cycle of two does at (1 − b)² + (1 + b)²/4. The
# next is that of B. Derrida, A. Gervois, Y. Pomeau, J. Phys. A 12 (1979) 269.
# %%
b = 0.3
flips = sorted({round(special.parameter, 9) for branch in branches for special in branch.special if special.kind == "flip"})
folds = [special.parameter for special in branches[0].special if special.kind == "fold"]
expected = [3 * (1 - b)**2 / 4, (1 - b)**2 + (1 + b)**2 / 4, 1.0258554]
print(f"fold at {folds[0]:.7f}; in closed form {-(1 - b)**2 / 4:.7f}")
print("flips at " + ", ".join(f"{flip:.7f}" for flip in flips[:3]))
print("expected " + ", ".join(f"{flip:.7f}" for flip in expected))
assert abs(folds[0] + (1 - b)**2 / 4) < 1e-8 and np.allclose(flips[:3], expected, rtol=0, atol=1e-7)
# %%
import matplotlib.pyplot as plt

figure, axes = plt.subplots(figsize=(8, 3.2), layout="constrained")
for branch in branches:
    stable = np.array([point.stability == "stable" for point in branch.points])
    for i in range(branch.period):
        x = np.array([point.points[i][0] for point in branch.points])
        for where, style in ((stable, "-"), (~stable, ":")):
            axes.plot(branch.parameter, np.where(where, x, np.nan), style, color=f"C{int(np.log2(branch.period))}", lw=1)
axes.set(xlabel="$a$", ylabel="$x$", ylim=(-1.6, 1.6));
# %% [markdown]
# ## Exponents
# J. C. Sprott, Chaos and Time-Series Analysis (2003), gives 0.41922 and −1.62319, whose sum is ln 0.3.
# %%
for value, error, known in zip(exponents.exponents, exponents.standard_errors, (0.41922, -1.62319)):
    print(f"published {known}: within four standard errors, which are below 0.01: {bool(abs(value - known) < 4 * error and error < 0.01)}")
    assert abs(value - known) < 4 * error
print(f"their sum is ln 0.3 within 1e-9: {bool(abs(exponents.exponents.sum() - np.log(0.3)) < 1e-9)}")
# %% [markdown]
# ## Basins
# Of each cell of a box: what the orbit from its centre comes to. Label 0 is the attractor, −1 stands for orbits that escape.
# %%
shares = basins.shares()
print(f"attractors: {len(basins.attractors)}; share of the box that comes to it: {shares[0]:.2f}, that escapes: {shares[-1]:.2f}")
figure, axes = plt.subplots(figsize=(4.4, 4), layout="constrained")
axes.pcolormesh(*basins.edges, basins.labels.T, cmap="Greys_r", vmin=-1, vmax=1.5)
axes.plot(*basins.attractors[0].T, ".", ms=1.5)
axes.set(xlabel="$x$", ylabel="$y$");
