"""Small records for the tests of the figures, in the layout of the commands that take long to make them.

The numbers are those of maps whose branches are known in closed form, so that a figure can also be judged by eye."""

import h5py
import numpy

SCENE = {"sides": 6, "beta": 0.5, "mu": 0.5, "restitution": 0.95, "law": "poisson", "inertia_factor": 2.5 / 6}


def _dimension(group, name, size):
    group.create_dataset(name, data=numpy.zeros(size, dtype="f4")).make_scale(
        f"This is a netCDF dimension but not a netCDF variable. {size:10d}")


def _write(group, name, dimensions, values):
    text = isinstance(values[0], str) if len(values) else False
    data = group.create_dataset(name, data=values, dtype=h5py.string_dtype() if text else None)
    for axis, dimension in enumerate(dimensions):
        data.dims[axis].attach_scale(group[dimension])


def _record(path, settings, scene):
    file = h5py.File(path, "w")
    file.attrs["schema_version"] = 1
    file.create_group("settings").attrs.update(settings)
    file.create_group("scene").attrs.update(scene)
    return file


def _padded(rows, width):
    return numpy.array([[*row, *[numpy.nan] * (width - len(row))] for row in rows])


def _samples(file):
    rows = []
    for column, r in enumerate(numpy.linspace(2.6, 4, 181)):
        for start in range(3):
            x = 0.2 + 0.25 * start
            for impact in range(260):
                x = r * x * (1 - x)
                if impact >= 200:
                    rows.append((r, -x, column, start, start))
    group = file.create_group("samples")
    _dimension(group, "sample", len(rows))
    for name, values in zip(("parameter", "S", "column", "start", "origin"), zip(*rows)):
        _write(group, name, ["sample"], numpy.array(values, dtype="f8" if name in ("parameter", "S") else "i8"))


def _branches(file):
    rows = []
    for r in numpy.linspace(2.6, 4, 57):
        rows.append((0, 1, r, [1 - 1 / r], abs(2 - r)))
    for r in numpy.linspace(3, 4, 41):
        root = numpy.sqrt((r - 3) * (r + 1))
        rows.append((1, 2, r, [(r + 1 - root) / (2 * r), (r + 1 + root) / (2 * r)], abs(4 + 2 * r - r * r)))
    group = file.create_group("branches")
    _dimension(group, "point", len(rows))
    _dimension(group, "phase", 3)
    for index, name, kind in ((0, "branch", "i8"), (1, "period", "i8"), (2, "parameter", "f8")):
        _write(group, name, ["point"], numpy.array([row[index] for row in rows], dtype=kind))
    _write(group, "mean_S", ["point"], numpy.array([-numpy.mean(row[3]) for row in rows]))
    _write(group, "stable", ["point"], numpy.array([row[4] < 1 for row in rows], dtype="i8"))
    _write(group, "largest_multiplier", ["point"], numpy.array([row[4] for row in rows]))
    _write(group, "S", ["point", "phase"], -_padded([row[3] for row in rows], 3))


def _special(file):
    fold = 1 + numpy.sqrt(8)
    flip = 1 + numpy.sqrt(6)
    root = numpy.sqrt((flip - 3) * (flip + 1))
    rows = [("flip", 0, 3.0, [2 / 3]),
            ("flip", 1, flip, [(flip + 1 - root) / (2 * flip), (flip + 1 + root) / (2 * flip)]),
            ("fold", 2, fold, [0.159929, 0.514355, 0.956318]),
            ("border", 0, 4.0, [0.75])]
    group = file.create_group("special")
    _dimension(group, "special_point", len(rows))
    _dimension(group, "phase", 3)
    _write(group, "kind", ["special_point"], [row[0] for row in rows])
    _write(group, "branch", ["special_point"], numpy.array([row[1] for row in rows]))
    _write(group, "parameter", ["special_point"], numpy.array([row[2] for row in rows]))
    grids = {0: numpy.linspace(2.6, 4, 57), 1: numpy.linspace(3, 4, 41), 2: numpy.array([])}
    after = [max((grids[row[1]] < row[2]).sum() - 1, 0) for row in rows]
    _write(group, "after", ["special_point"], numpy.array(after, dtype="i8"))
    _write(group, "largest_multiplier", ["special_point"], numpy.ones(len(rows)))
    _write(group, "mean_S", ["special_point"], numpy.array([-numpy.mean(row[3]) for row in rows]))
    _write(group, "S", ["special_point", "phase"], -_padded([row[3] for row in rows], 3))


def write_bifurcation(path, groups=("samples", "branches", "special")):
    """The logistic map's diagram in the layout of `swirl bifurcate` and `swirl continue`: alpha is r, S is −x."""
    with _record(path, {"along": "alpha"}, SCENE) as file:
        for name, write in (("samples", _samples), ("branches", _branches), ("special", _special)):
            if name in groups:
                write(file)


def write_crowded_special(path, count, phases=1):
    """A branch with `count` flips that all but lie on one another, from r = 3.2 to 3.4, at so many phases each."""
    with _record(path, {"along": "alpha"}, SCENE) as file:
        _branches(file)
        group = file.create_group("special")
        _dimension(group, "special_point", count)
        _dimension(group, "phase", 3)
        r = numpy.linspace(3.2, 3.4, count)
        _write(group, "kind", ["special_point"], ["flip"] * count)
        _write(group, "branch", ["special_point"], numpy.zeros(count, dtype="i8"))
        _write(group, "parameter", ["special_point"], r)
        values = [[1 - 1 / value - 0.2 * phase for phase in range(phases)] for value in r]
        _write(group, "S", ["special_point", "phase"], -_padded(values, 3))


def write_orbits(path, count, largest):
    """`count` orbits in the layout of `swirl orbits`, their largest multipliers up to `largest`."""
    periods = 1 + numpy.arange(count) % 5
    moduli = numpy.geomspace(0.4, largest, count)
    angles = numpy.linspace(0, 2.6, count)
    real = _padded(numpy.column_stack([moduli * numpy.cos(angles)] * 2 + [0.3 * numpy.cos(periods), 1e-17 * moduli]), 5)
    imaginary = _padded(numpy.column_stack([moduli * numpy.sin(angles), -moduli * numpy.sin(angles), 0 * moduli,
                                            0 * moduli]), 5)
    with _record(path, {"max_period": 5}, {**SCENE, "alpha": 0.4}) as file:
        group = file.create_group("orbits")
        _dimension(group, "orbit", count)
        _dimension(group, "multiplier_index", 5)
        _write(group, "period", ["orbit"], periods)
        _write(group, "mean_S", ["orbit"], -0.98 + 0.4 * numpy.sin(1.0 * numpy.arange(count)))
        _write(group, "return_time", ["orbit"], 1.4 * periods)
        _write(group, "residual", ["orbit"], numpy.full(count, 1e-15))
        _write(group, "multiplier_re", ["orbit", "multiplier_index"], real)
        _write(group, "multiplier_im", ["orbit", "multiplier_index"], imaginary)
        stability = ["stable" if modulus < 1 else "unstable" for modulus in moduli[:-1]] + ["neutral"]
        _write(group, "stability", ["orbit"], stability)


def write_boundaries(path):
    """Fold, flip and Neimark–Sacker curves of the Hénon map in the layout of `swirl boundaries`: alpha is a, beta is b."""
    b = numpy.linspace(-1, 1, 41)
    curves = [("fold", 1, -(1 - b) ** 2 / 4, b, numpy.ones(41)), ("flip", 1, 3 * (1 - b) ** 2 / 4, b, numpy.ones(41)),
              ("flip", 2, (1 - b) ** 2 + (1 + b) ** 2 / 4, b, numpy.ones(41)),
              ("neimark-sacker", 1, numpy.linspace(-1, 3, 41), numpy.full(41, -1.0), numpy.full(41, 1.5))]
    settings = {"first": "alpha", "first_low": -1.5, "first_high": 4.5, "second": "beta", "second_low": -1.1,
                "second_high": 1.1}
    with _record(path, settings, {name: value for name, value in SCENE.items() if name != "beta"}) as file:
        group = file.create_group("curves")
        _dimension(group, "point", 41 * len(curves))
        _write(group, "curve", ["point"], numpy.repeat(numpy.arange(len(curves)), 41))
        for name, index in (("first", 2), ("second", 3), ("largest_multiplier", 4)):
            _write(group, name, ["point"], numpy.concatenate([curve[index] for curve in curves]))
        group = file.create_group("curve_ends")
        _dimension(group, "curve", len(curves))
        _write(group, "kind", ["curve"], [curve[0] for curve in curves])
        _write(group, "period", ["curve"], numpy.array([curve[1] for curve in curves]))
        group = file.create_group("special")
        _dimension(group, "special_point", 4)
        _write(group, "kind", ["special_point"], ["1:1", "1:4", "1:3", "1:2"])
        _write(group, "first", ["special_point"], numpy.array([-1, 0, 1.25, 3]))
        _write(group, "second", ["special_point"], numpy.full(4, -1.0))


def write_cells(path):
    """Cells in the layout of `swirl certify --plane`: how many of r x (1 - x)'s two fixed points attract, alpha r, beta nothing;
    cells that a bifurcation (r = 1, r = 3) crosses are not proven."""
    settings = {"first": "alpha", "first_low": 0.0, "first_high": 4.0, "second": "beta", "second_low": 0.0, "second_high": 1.0,
                "max_time": 6.0, "resolution": 1 / 16}
    low = numpy.arange(16) * 0.25
    first, second = (axis.ravel() for axis in numpy.meshgrid(low - 0.1 * (low > 0), numpy.arange(4) * 0.25))
    high = numpy.append(low[1:] - 0.1, 4.0)[numpy.tile(numpy.arange(16), 4)]
    proven = ~((first < 1) & (high > 1)) & ~((first < 3) & (high > 3))
    with _record(path, settings, {name: value for name, value in SCENE.items() if name != "beta"}) as file:
        file.create_group("result").attrs.update({"proven_area": float(proven.mean()), "outcome": "completed"})
        group = file.create_group("cells")
        _dimension(group, "cell", len(first))
        for name, values in (("first_low", first), ("first_high", high), ("second_low", second), ("second_high", second + 0.25),
                             ("proven", proven.astype("i8")), ("attracting", (proven & (high < 3)).astype("i8"))):
            _write(group, name, ["cell"], values)
        _write(group, "doubt", ["cell"], ["none" if is_proven else "stability" for is_proven in proven])


def write_sets(path):
    """Sets in the layout of `swirl certify --chaos`: a horseshoe, whose set about a saddle is carried over itself and over a
    second one, and that over the first: stretched by 5, squeezed by 1/5."""
    coverings = ((1, 1, 0.0), (1, 2, 0.0), (2, 1, 0.6))
    with _record(path, {"link_length": 12}, SCENE) as file:
        file.create_group("result").attrs["outcome"] = "completed"
        file.create_group("chaos").attrs.update({"proven": 1, "entropy": 0.481, "growth": 1.618, "exponent": 0.5})
        group = file.create_group("sets")
        _dimension(group, "set", 2)
        for name, values in (("centre_psi", [3.1, 2.9]), ("centre_vt", [0.05, 0.2]), ("edge1_psi", [0.01, 0.002]), ("edge1_vt", [0, 0]),
                             ("edge2_psi", [0, 0]), ("edge2_vt", [0.02, 0.01]), ("weight", [1, 0.6])):
            _write(group, name, ["set"], numpy.array(values, dtype="f8"))
        group = file.create_group("coverings")
        _dimension(group, "covering", len(coverings))
        for k, name in enumerate(("from", "to")):
            _write(group, name, ["covering"], numpy.array([covering[k] for covering in coverings]))
        q = numpy.linspace(-1, 1, 41)
        points = [(number + 1, one, side, 5 * one, shift + 0.2 * side) for number, (_, _, shift) in enumerate(coverings)
                  for side in (-1, 0, 1) for one in q]
        group = file.create_group("carried")
        _dimension(group, "carried_point", len(points))
        for name, values in zip(("covering", "q", "side", "carried_q", "carried_side"), zip(*points)):
            _write(group, name, ["carried_point"], numpy.array(values))


RUNGS = [("double", 2.3e-7, 4e-16, 6e-14, 3e-10, 1e4, 0), ("extended", 1.9e-6, 2e-19, 3e-17, 2e-13, 1e4, 0),
         ("paper", 4.4e-6, 3e-14, 9e-14, 4e-9, 1e4, 37), ("fixed-step", 3.2e-5, 2e-3, 2e-2, 4e-1, 1e4, 412),
         ("quad", 6.1e-5, *[numpy.nan] * 5)]
PIECES = [("flight and impact", 231, numpy.nan, "every command"), ("friction", 231, 224, "every command"),
          ("watch for contact", 236, 231, "nothing: e = 1"), ("derivative", 1400, 260, "classify, lyapunov"),
          ("laboratory frame", 330, 240, "simulate")]


def _columns(group, dimension, columns):
    _dimension(group, dimension, len(columns["name" if "name" in columns else "collisions"]))
    for name, values in columns.items():
        _write(group, name, [dimension], values if isinstance(values[0], str) else numpy.array(values, dtype="f8"))


def write_tradeoff(path):
    """What `swirl tradeoff` writes, of made-up times: one rung of each kind."""
    names, seconds, error, most_of, largest, flights, missed = (list(column) for column in zip(*RUNGS))
    with _record(path, {"budget": 10.0}, {**SCENE, "alpha": 0.3}) as file:
        file.create_group("result").attrs.update({"recommended": "double", "reason": "double missed 0 of 10000"})
        _columns(file.create_group("rungs"), "rung", {
            "name": names, "seconds_per_collision": seconds, "error": error, "error_99": most_of,
            "error_largest": largest,
            "seconds_per_collision_lower": [0.95 * t for t in seconds], "flights": flights, "missed_contacts": missed,
            "seconds_per_collision_upper": [1.1 * t for t in seconds], "missed_rate_most": [3e-4] * len(names)})
        _columns(file.create_group("evidence"), "rung", {
            "collisions": [100, 300, 1000, 3000, 10000], "mean_S": [-0.2, -0.31, -0.28, -0.291, -0.2902],
            "mode": ["undecided", "chaotic", "chaotic", "chaotic", "quasi-steady"], "changed": [8, 5, 5, 2, 0],
            "mean_S_error": [0.09, 0.05, 0.02, 0.01, 0.0], "runs": [8] * 5})
        names, with_it, without, paid_by = (list(column) for column in zip(*PIECES))
        _columns(file.create_group("model"), "rung", {
            "name": names, "seconds_per_collision": [1e-9 * t for t in with_it],
            "seconds_without": [1e-9 * t for t in without], "paid_by": paid_by})


def write_sampled_sweep(path, names, count):
    """A sweep over `count` random points of these parameters, in the layout of `swirl sweep --sample`."""
    chance = numpy.random.default_rng(1)
    with _record(path, {}, {name: value for name, value in {**SCENE, "alpha": 0.4}.items() if name not in names}) as file:
        group = file.create_group("sweep")
        _dimension(group, "cell", count)
        group.create_dataset("run", data=[0, 1]).make_scale("run")
        group.create_dataset("mode", data=["steady", "quasi-steady", "chaotic", "undecided"], dtype=h5py.string_dtype())
        group["mode"].make_scale("mode")
        points = {name: chance.uniform(0.1, 0.9, count) for name in names}
        for name, values in points.items():
            _write(group, name, ["cell"], values)
        steady = points[names[0]] < 0.5
        _write(group, "share", ["cell", "mode"], numpy.column_stack([steady, 0 * steady, ~steady, 0 * steady]).astype("f8"))
        _write(group, "mean_S", ["cell"], points[names[0]] - 1)
        _write(group, "mean_S_error", ["cell"], 0 * points[names[0]])


def write_grid(path, shape):
    """A sweep over alpha, or alpha and beta, in the layout of `swirl sweep`: chaos everywhere, mean S = 1."""
    names = ["alpha", "beta"][:len(shape)]
    with _record(path, {}, {name: value for name, value in {**SCENE, "alpha": 0.4}.items() if name not in names}) as file:
        group = file.create_group("sweep")
        for name, count in zip(names, shape):
            group.create_dataset(name, data=numpy.linspace(0.2, 0.6, count)).make_scale(name)
        group.create_dataset("run", data=[0, 1]).make_scale("run")
        group.create_dataset("mode", data=["steady", "quasi-steady", "chaotic", "undecided"], dtype=h5py.string_dtype())
        group["mode"].make_scale("mode")
        _write(group, "share", [*names, "mode"], numpy.broadcast_to([0.0, 0, 1, 0], (*shape, 4)))
        _write(group, "mean_S", names, numpy.ones(shape))
        _write(group, "mean_S_error", names, numpy.full(shape, 0.1))


def write_columns(path, count, empty=(), spin=numpy.linspace(0, 1, 500)):
    """Attractors with these S, from 0 to 1, in each of so many columns of alpha, but for those that are empty."""
    places = numpy.linspace(0.1, 0.9, count)
    kept = numpy.setdiff1d(numpy.arange(count), empty)
    with _record(path, {"along": "alpha"}, SCENE) as file:
        group = file.create_group("samples")
        _dimension(group, "sample", len(kept) * len(spin))
        _write(group, "parameter", ["sample"], numpy.repeat(places[kept], len(spin)))
        _write(group, "S", ["sample"], numpy.tile(spin, len(kept)))
        for name in ("start", "origin"):
            _write(group, name, ["sample"], numpy.zeros(len(kept) * len(spin), dtype="i8"))


#: Of three cells: (cell, track, kind, period, share, mean S); two have a share each that the verdicts of their runs leave open.
TRACKS = [(0, 0, "chaotic", 0, 1 / 6, -0.2), (0, 1, "quasi-periodic", 0, 1 / 6, -0.29), (0, -1, "transient", 0, 2 / 3, -0.26),
          (1, 0, "chaotic", 0, 1, -0.25), (1, 2, "fixed-point", 1, 0, -0.9),
          (2, 2, "fixed-point", 1, 1 / 2, -0.9), (2, -1, "transient", 0, 1 / 4, numpy.nan), (2, -1, "none", 0, 1 / 4, -0.1)]


def write_tracks(path):
    """A sweep over beta in the layout of `swirl sweep --track`."""
    cell, track, kind, period, share, spin = (list(column) for column in zip(*TRACKS))
    with _record(path, {}, {name: value for name, value in SCENE.items() if name != "beta"}) as file:
        group = file.create_group("sweep")
        group.create_dataset("beta", data=[0.4, 0.45, 0.5]).make_scale("beta")
        group.create_dataset("run", data=numpy.arange(6)).make_scale("run")
        group.create_dataset("mode", data=["steady", "chaotic", "undecided"], dtype=h5py.string_dtype())
        group["mode"].make_scale("mode")
        _write(group, "share", ["beta", "mode"], numpy.full((3, 3), 1 / 3))
        for name in ("mean_S", "mean_S_error"):
            _write(group, name, ["beta"], numpy.zeros(3))
        columns = {"cell": cell, "track": track, "period": period, "share": share, "mean_S": spin,
                   "share_low": [0.5 * value for value in share], "share_high": [0.5 + 0.5 * value for value in share]}
        group = file.create_group("attractors")
        _dimension(group, "attractor", len(TRACKS))
        _write(group, "kind", ["attractor"], kind)
        for name, values in columns.items():
            _write(group, name, ["attractor"], numpy.array(values))


def write_film(path):
    """A body that goes to and fro on a line and turns at random, filmed, in the layout of `swirl fit --series`."""
    arcs, frames = 80, 12
    start = frames * 0.2 * numpy.arange(arcs)
    end, middle = start + 0.2 * (frames - 1), start + 0.1 * (frames - 1)
    turning = numpy.random.default_rng(1)
    spin, velocity = turning.normal(size=arcs), 0.2 * (-1.0) ** numpy.arange(arcs)
    time = 0.2 * numpy.arange(arcs * frames)
    on = numpy.repeat(numpy.arange(arcs), frames)
    place = velocity[on] * (time - middle[on])
    noise = 0.01 * turning.normal(size=(2, len(time)))
    with _record(path, {}, {}) as file:
        file.create_group("film").attrs.update({"frames": len(time), "arcs": arcs, "kinks": arcs - 1, "place_noise": 0.01,
                                                "angle_noise": 0.03})
        file.create_group("fit").attrs.update({"impacts": arcs - 3})
        groups = {"frames": ("frame", {"time": time, "x": place + noise[0], "y": 0.4 * place + noise[1]}),
                  "arcs": ("arc", {"start": start, "end": end, "time": middle, "x": 0 * start, "y": 0 * start, "vx": velocity,
                                   "vy": 0.4 * velocity, "S": spin}),
                  "kinks": ("kink", {"time": end[:-1] + 0.1, "use": ["used"] * (arcs - 3) + ["off the wall"] * 2}),
                  "simulated": ("step", {"time": numpy.append(middle[1], end[1:-1] + 0.1), "S": spin[1:] + 0.1})}
        for name, (dimension, columns) in groups.items():
            group = file.create_group(name)
            _dimension(group, dimension, len(columns["time"]))
            for column, values in columns.items():
                _write(group, column, [dimension], values)


def write_without_results(path):
    """A record of a scene, and of nothing that was found about it."""
    with _record(path, {}, SCENE):
        pass
