"""All fixed points of F of one scene with a flight time up to a limit, by a search of the two equations of steady.py.

In double precision, the defect of the law of impact is scanned over chi for each tau of a grid, with the spin that
sticking needs; at a root j = N tau (1 - S) / (2 pi) is a real number, and must be whole. Each root with j near a whole
number starts Newton's method in 50 digits for both equations, and what it finds counts if F itself, with its search
over all vertices, returns to it. Two roots in one cell of the grid would be missed; `finer` divides the cells further.
"""

from mpmath import fp, mp

from section import CLOSED, STEP
from steady import confirmed, in_double, law_defect, section_point_of, spin_of, steady, sticking_spin

TAU_STEP, CHI_CELLS = 0.01, 60
NEAR_WHOLE = 0.1  # dj/dtau is of the order of N: several columns of the grid lead to each solution


def largest_chi(scene):
    """The other vertices leave no more room than this, and the branches end where sin chi = beta."""
    half = fp.pi / scene.sides
    room = half - fp.asin(scene.alpha * fp.sin(half))
    return min(room, fp.asin(scene.beta)) if scene.beta < 1 else room


def bisected(function, a, b):
    rising = function(b) > 0
    for _ in range(40):
        middle = (a + b) / 2
        a, b = (a, middle) if (function(middle) > 0) == rising else (middle, b)
    return (a + b) / 2


def roots(function, low, high, cells):
    """The roots of a function, None where it is not defined, by its changes of sign from cell to cell."""
    points = [low + (high - low) * (k + 0.5) / (cells + 1) for k in range(cells + 1)]
    values = [function(x) for x in points]
    for a, b, at_a, at_b in zip(points, points[1:], values, values[1:]):
        if at_a is not None and at_b is not None and (at_a > 0) != (at_b > 0):
            yield bisected(function, a, b)


def starts(scene, longest, branch, finer):
    """(tau, chi, j) in double precision near solutions."""
    double = in_double(scene)
    limit = largest_chi(double)
    if scene.mu < fp.tan(limit):
        raise ValueError(f"mu = {scene.mu}: must be {fp.tan(limit)} or more, or the contact of a steady mode may slide")
    for k in range(1, int(longest / TAU_STEP * finer) + 2):
        tau = k * TAU_STEP / finer

        def defect(chi):
            return law_defect(double, tau, chi, branch, sticking_spin(double, tau, chi, branch, fp), fp)

        for chi in roots(defect, -limit, limit, CHI_CELLS * finer):
            j = scene.sides * tau * (1 - sticking_spin(double, tau, chi, branch, fp)) / (2 * fp.pi)
            if abs(j - round(j)) < NEAR_WHOLE:
                yield tau, chi, round(j)


def solved(scene, branch, tau, chi, j):
    """(tau, chi) in 50 digits by Newton's method, or None where it leaves the domain of the equations."""

    def equations(at):
        spin = spin_of(scene, at[0], j, mp)
        defect = law_defect(scene, *at, branch, spin, mp) if at[0] > 0 else None
        return None if defect is None else mp.matrix([defect, steady(scene, *at, branch, spin, mp).slip_after.imag])

    at = mp.matrix([tau, chi])
    for _ in range(30):
        here = equations(at)
        aside = [equations(at + STEP * mp.matrix(unit)) for unit in ([1, 0], [0, 1])]
        if any(value is None for value in (here, *aside)):
            return None
        columns = [(there - here) / STEP for there in aside]
        step = mp.lu_solve(mp.matrix([[columns[0][i], columns[1][i]] for i in range(2)]), -here)
        at += step
        if mp.norm(step) < CLOSED:
            return tuple(at)
    return None


def all_fixed_points(scene, longest, branch, finer=1):
    """[(j, tau, z)] by rising tau."""
    found = {}
    for tau, chi, j in starts(scene, longest, branch, finer):
        solution = solved(scene, branch, tau, chi, j)
        if solution is None or not 0 < solution[0] <= longest:
            continue
        z = section_point_of(scene, *solution, branch, j)
        key = (j, mp.nstr(solution[0], 20))
        if key not in found and confirmed(scene, z, j):
            found[key] = (j, solution[0], z)
    return sorted(found.values(), key=lambda entry: entry[1])
