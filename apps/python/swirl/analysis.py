"""Cycles, branches, Lyapunov exponents and basins of a map of one's own: a Python function of a state and a parameter.

    >>> import numpy as np
    >>> from swirl import analysis
    >>> henon = analysis.Map(lambda z, a: (1 - a * z[0]**2 + z[1], 0.3 * z[0]), dimension=2)
    >>> [cycle.points[0] for cycle in henon.cycles(period=1, parameter=1.4)]
    >>> branches = henon.continue_(henon.cycles(1, 0.1)[0], between=(0, 1.2))
    >>> henon.exponents((0.1, 0.1), 1.4).exponents
    >>> henon.basins(((-2.5, 2.5, 100), (-2.5, 2.5, 100)), 1.4).shares()

What computes is `analysis/` of Swirl, the same as for its scenes: multiple shooting with Newton's method, pseudo-arclength
continuation with special points located to rounding, QR of the derivatives.
"""

import dataclasses
import inspect
import operator

import numpy as np

from . import _swirl

__all__ = ["Basins", "Branch", "BranchPoint", "Cycle", "Exponents", "Map", "SpecialPoint"]


@dataclasses.dataclass(frozen=True, eq=False)
class Cycle:
    """k points that the map leads to each other."""
    points: np.ndarray       #: shape (k, d)
    parameter: float
    multipliers: np.ndarray  #: complex, shape (d,), of the derivative of F^k, by falling modulus
    stability: str           #: "stable", "unstable" or "neutral"
    residual: float = 0.0    #: largest coordinate of F(z_i) - z_(i+1)

    @property
    def period(self):
        return len(self.points)


class BranchPoint(Cycle):
    """A cycle of a branch."""


@dataclasses.dataclass(frozen=True, eq=False)
class SpecialPoint(BranchPoint):
    """Where a branch turns or changes its stability."""
    kind: str = ""  #: "fold", "flip", "neimark-sacker", "branch-point", or "border" where the map ends


@dataclasses.dataclass(frozen=True, eq=False)
class Branch:
    """A curve of cycles over the parameter."""
    period: int
    points: list   #: of BranchPoint, in order
    special: list  #: of SpecialPoint
    parent: int    #: place in the list of the branch it was switched from; -1: none

    @property
    def parameter(self):
        """ndarray, one a point."""
        return np.array([point.parameter for point in self.points])

    def coordinate(self, i):
        """ndarray: coordinate i of each cycle's first point."""
        return np.array([point.points[0][i] for point in self.points])


@dataclasses.dataclass(frozen=True, eq=False)
class Exponents:
    """Lyapunov exponents per step, by falling size."""
    outcome: str                    #: "completed", or how the map ended
    steps: int                      #: that counted
    exponents: np.ndarray           #: shape (d,)
    standard_errors: np.ndarray     #: of their means
    weighted_exponents: np.ndarray  #: converge faster than any power of the steps on regular orbits


ESCAPES, UNRESOLVED = -1, -2  #: labels of `Basins` that are no attractor
UNKNOWN = -3
#: In a row: steps outside, cells of one attractor, of one basin, of the orbit's own; and steps that make an attractor.
LOST, MET, IN_BASIN, RETURNED, ON_ATTRACTOR = 100, 2, 10, 100, 1000


@dataclasses.dataclass(frozen=True, eq=False)
class Basins:
    """What the cells of a box lead to."""
    labels: np.ndarray  #: of each cell its attractor's place in the list, or ESCAPES, UNRESOLVED
    attractors: list    #: of ndarray, shape (n, d): centres of the cells that each visits
    edges: list         #: of ndarray, those of the cells along each coordinate

    def shares(self):
        """Share of the box by label."""
        labels, counts = np.unique(self.labels, return_counts=True)
        return {int(label): float(count) / self.labels.size for label, count in zip(labels, counts)}


class _Cells:
    """The cells of a box."""

    def __init__(self, box, dimension):
        if len(box) != dimension or any(len(side) != 3 for side in box):
            raise ValueError(f"box has {len(box)} sides; (from, to, cells) of each of {dimension} coordinates is wanted")
        self.counts = tuple(_whole("cells", side[2], 1) for side in box)
        for low, high, _ in box:
            if not (np.isfinite(low) and np.isfinite(high) and low < high):
                raise ValueError(f"box = {low:g} to {high:g} is outside its range: two finite numbers, the first below the second")
        self.edges = [np.linspace(low, high, count + 1) for low, high, count in box]
        self.low, self.size = (np.array(numbers) for numbers in zip(*((low, (high - low) / count) for low, high, count in box)))

    def centre(self, cell):
        return self.low + (np.array(cell) + 0.5) * self.size

    def cell_of(self, z):
        """None outside."""
        places = np.floor((z - self.low) / self.size)
        return tuple(places.astype(int)) if (places >= 0).all() and (places < self.counts).all() else None


class _Basins:
    """Labels as far as they are known."""

    def __init__(self, counts):
        self.labels = np.full(counts, UNKNOWN)
        self.attractors, self.attractor_of = [], {}

    def label(self, cells, label):
        for cell in cells:
            self.labels[cell] = label

    def new_attractor(self, cells):
        cells.discard(None)
        self.attractors.append(sorted(cells))
        self.attractor_of.update(dict.fromkeys(cells, len(self.attractors) - 1))
        self.label(cells, len(self.attractors) - 1)
        return len(self.attractors) - 1


class Map:
    """z -> F(z, p), by a Python function.

    Parameters
    ----------
    function : callable
        `function(z, p)` gives F; z is an ndarray of shape (d,), p a float. One of z alone has no parameter. NaN, or
        None: the map ends there.
    jacobian : callable, optional
        `jacobian(z, p)`, shape (d, d): dF_i/dz_j. Without it: central differences, whose error is some 1e-10.
    dimension : int
        d. Exponents want 1 to 6.
    parameter_jacobian : callable, optional
        `parameter_jacobian(z, p)`, shape (d,): dF_i/dp, for continuation.
    angles : dict of int: float, optional
        Periods of those coordinates that are angles, {0: 2 * pi}.
    """

    def __init__(self, function, jacobian=None, *, dimension, parameter_jacobian=None, angles=None):
        self.dimension = _whole("dimension", dimension, 1)
        self.has_parameter = _takes_two(function)
        self._function, self._jacobian, self._by_parameter = (
            one if one is None or _takes_two(one) else (lambda z, p, one=one: one(z)) for one in (function, jacobian, parameter_jacobian))
        periods = [0.0] * self.dimension
        for place, period in (angles or {}).items():
            periods[place] = float(period)
        self._own = _swirl.OwnMap(self._step, self.dimension, periods)

    def __call__(self, z, parameter=0.0):
        """F(z, p), an ndarray."""
        image = self._function(np.asarray(z, dtype=float), parameter)
        if image is None:
            return np.full(self.dimension, np.nan)
        return np.asarray(image, dtype=float).reshape(self.dimension)

    def derivative(self, z, parameter=0.0):
        """dF/dz, shape (d, d)."""
        z = np.asarray(z, dtype=float)
        if self._jacobian is not None:
            return np.asarray(self._jacobian(z, parameter), dtype=float).reshape(self.dimension, self.dimension)
        steps = np.cbrt(np.finfo(float).eps) * np.maximum(1, np.abs(z))
        columns = [(self(z + h * e, parameter) - self(z - h * e, parameter)) / (2 * h) for h, e in zip(steps, np.eye(self.dimension))]
        return np.column_stack(columns)

    def _slope(self, z, p):
        if not self.has_parameter:
            return np.zeros((self.dimension, 1))
        if self._by_parameter is not None:
            return np.asarray(self._by_parameter(z, p), dtype=float).reshape(self.dimension, 1)
        h = np.cbrt(np.finfo(float).eps) * max(1, abs(p))
        return ((self(z, p + h) - self(z, p - h)) / (2 * h)).reshape(self.dimension, 1)

    def basins(self, box, parameter=0.0, most_steps=10_000):
        """Which attractor each cell of a box leads to, from its centre.

        Parameters
        ----------
        box : sequence of (float, float, int), one a coordinate
            From, to and into how many cells: ((-2.5, 2.5, 100), (-2.5, 2.5, 100)).
        parameter : float
            p.
        most_steps : int
            Of one orbit.

        Returns
        -------
        Basins

        Notes
        -----
        An orbit that comes back to cells of its own 100 times in a row is on an attractor, which are the cells of 1000
        further steps; one that meets an attractor twice in a row, or 10 cells of one basin in a row, belongs to that; one that
        the map ends, or that is outside for 100 steps in a row, escapes. So cells are to be small beside the attractors'
        distances, some cells on a boundary have a neighbour's label, and an orbit that stays long near a chaotic saddle is
        taken for one on an attractor. Source: G. Datseris, A. Wagemakers, Chaos 32 (2022) 023104. Cost: some ten calls of the
        function a cell.
        """
        grid = _Cells(box, self.dimension)
        most_steps = _whole("most_steps", most_steps, 1)
        seen = _Basins(grid.counts)
        with np.errstate(all="ignore"):
            for start in np.ndindex(*grid.counts):
                if seen.labels[start] == UNKNOWN:
                    self._follow_to_basin(start, grid, seen, parameter, most_steps)
        points = [np.array([grid.centre(cell) for cell in cells]) for cells in seen.attractors]
        return Basins(seen.labels, points, grid.edges)

    def _follow_to_basin(self, start, grid, seen, parameter, most_steps):
        z, path = grid.centre(start), {start}
        returned = outside = met = in_basin = 0
        last = None
        for _ in range(most_steps):
            z = self(z, parameter)
            cell = grid.cell_of(z)
            outside = outside + 1 if cell is None else 0
            if outside >= LOST or not np.isfinite(z).all():
                return seen.label(path, ESCAPES)
            if cell is None:
                continue
            label = seen.attractor_of.get(cell, seen.labels[cell])
            met = met + 1 if cell in seen.attractor_of and label == last else int(cell in seen.attractor_of)
            in_basin = in_basin + 1 if label == last and label != UNKNOWN else int(label != UNKNOWN)
            last = label
            if met >= MET or in_basin >= IN_BASIN:
                return seen.label(path, label)
            returned = returned + 1 if cell in path else 0
            path.add(cell)
            if returned >= RETURNED:
                return seen.label(path, seen.new_attractor({grid.cell_of(one) for one in self.orbit(z, ON_ATTRACTOR, parameter)}))
        return seen.label(path, UNRESOLVED)

    def _state(self, name, z):
        """A state that the user gives; a number is one of a map of one coordinate."""
        state = np.atleast_1d(np.asarray(z, dtype=float))
        if state.shape != (self.dimension,):
            raise ValueError(f"{name} has the shape {np.shape(z)}; ({self.dimension},) is wanted")
        return state

    def _states(self, name, z):
        """States that the user gives, shape (n, d); one state is a row."""
        states = np.atleast_2d(np.asarray(z, dtype=float))
        if states.ndim != 2 or states.shape[1] != self.dimension:
            raise ValueError(f"{name} has the shape {np.shape(z)}; (n, {self.dimension}) is wanted")
        return states

    def _step(self, z, p):
        z = np.ravel(z)
        return self(z, p), self.derivative(z, p), self._slope(z, p)

    def orbit(self, z, steps, parameter=0.0):
        """z, F(z), …: ndarray of shape (steps + 1, d); NaN once the map has ended."""
        steps = _whole("steps", steps, 0)
        orbit = np.full((steps + 1, self.dimension), np.nan)
        orbit[0] = self._state("z", z)
        with np.errstate(all="ignore"):
            for i in range(steps):
                orbit[i + 1] = self(orbit[i], parameter)
                if not np.isfinite(orbit[i + 1]).all():
                    break
        return orbit

    def cycles(self, period=1, parameter=0.0, starts=None, accept=1e-10, seed=1):
        """The cycles of this minimal period that Newton's method finds from the starts, stable and unstable, each once.

        Parameters
        ----------
        period : int
            k.
        parameter : float
            p.
        starts : array_like, shape (n, d), optional
            Guesses of a point. By default 200 states, normally distributed about 0 (seed `seed`).
        accept : float
            Largest residual of a cycle.

        Returns
        -------
        list of Cycle

        Notes
        -----
        There may be others. Source: analysis/cycles/README.md.
        """
        period = _whole("period", period, 1)
        if not accept > 0:
            raise ValueError(f"accept = {accept} is outside its range: above 0")
        if starts is None:
            starts = np.random.default_rng(seed).normal(size=(200, self.dimension))
        candidates = []
        for start in self._states("starts", starts):
            points = self.orbit(start, period - 1, parameter)
            if np.isfinite(points).all():
                candidates.append(list(points))
        found = self._own.cycles(candidates, float(parameter), period, float(accept))
        return [Cycle(_points(one), float(parameter), np.array(one["multipliers"]), one["stability"], one["residual"]) for one in found]

    def continue_(self, cycle, between, parameter=None, longest_step=0.02, switch=0):
        """The branch of a cycle over the parameter, both ways, with its special points, and the branches that begin there.

        Parameters
        ----------
        cycle : Cycle or array_like, shape (k, d)
        between : (float, float)
            The parameter's range.
        parameter : float, optional
            Of the cycle, where it is given by its points.
        longest_step : float
            Along the branch, in the arclength s^2 = |dZ|^2 / k + dp^2.
        switch : int
            At flips and branch points go over to the other branch, and so often again from there.

        Returns
        -------
        list of Branch
            Empty where no cycle is there.

        Notes
        -----
        Source: analysis/continuation/README.md.
        """
        if not self.has_parameter:
            raise ValueError("the map has no parameter: give a function of (z, p)")
        points = cycle.points if isinstance(cycle, Cycle) else self._states("cycle", cycle)
        p = cycle.parameter if parameter is None and isinstance(cycle, Cycle) else parameter
        if p is None:
            raise ValueError("parameter is missing: that of the cycle")
        low, high = map(float, between)
        if not low <= p <= high:
            raise ValueError(f"parameter = {p:g} is outside `between`: {low:g} to {high:g}")
        if not longest_step > 0:
            raise ValueError(f"longest_step = {longest_step} is outside its range: above 0")
        found = self._own.branches(list(points), float(p), low, high, float(longest_step), _whole("switch", switch, 0))
        return [Branch(one["period"], [_of(BranchPoint, point) for point in one["points"]],
                       [_of(SpecialPoint, point, kind=point["kind"]) for point in one["special"]], one["parent"]) for one in found]

    def exponents(self, z, parameter=0.0, steps=10_000, transient=1_000):
        """All d Lyapunov exponents of the orbit from z, per step, in natural logarithms.

        Source: G. Benettin et al., Meccanica 15 (1980) 9; analysis/lyapunov/README.md.
        """
        found = self._own.exponents(self._state("z", z), float(parameter), _whole("steps", steps, 1), _whole("transient", transient, 0))
        return Exponents(found["outcome"], found["steps"],
                         *(np.array(found[name]) for name in ("exponents", "standard_errors", "weighted_exponents")))


def _whole(name, value, least):
    """A whole number, `least` or more."""
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{name} = {value!r} is no whole number") from None
    if number < least:
        raise ValueError(f"{name} = {number} is outside its range: {least} or more")
    return number


def _points(found):
    return np.array([np.ravel(point) for point in found["points"]])


def _of(point, found, **more):
    return point(_points(found), found["parameter"], np.array(found["multipliers"]), found["stability"], **more)


def _takes_two(function):
    """Of a state and a parameter, or of a state alone?"""
    try:
        parameters = inspect.signature(function).parameters.values()
    except (TypeError, ValueError):
        return True
    places = [p for p in parameters if p.kind in (p.POSITIONAL_ONLY, p.POSITIONAL_OR_KEYWORD)]
    return len(places) >= 2 or any(p.kind == p.VAR_POSITIONAL for p in parameters)
