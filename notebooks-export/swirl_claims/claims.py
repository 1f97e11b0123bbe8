"""The claims, each with its runs and its verdict: `holds`, `holds per impact only`, `fails`, `undecided`, or, where a floor takes
all motion away, `does not apply`; with numbers. `floor`: flags of a floor that drags, {"drag": 0.1, "floor": "dish"}; none of the
paper's."""

import dataclasses

import numpy

from .sampling import IMPACTS, NO_ATTRACTOR, RIDING, attractors, interval

#: N; the disk last.
BODIES = ("3", "4", "6", "8", "disk")

#: R_p/R_c and r_s/R_c of the runs; the paper's friction.
ALPHA, BETA, FRICTION = tuple(round(0.1 * k, 1) for k in range(1, 10)), 0.1, 0.5

#: The axes of the paper's Figure 7, in its units of 1/s; omega_s enters through the speed of the start, 1/(7 omega_s).
MU, OMEGA = tuple(round(0.1 * k, 1) for k in range(11)), tuple(range(1, 11))

HOLDS, PER_IMPACT, FAILS, UNDECIDED, VOID = "holds", "holds per impact only", "fails", "undecided", "does not apply"
VERDICTS = (HOLDS, PER_IMPACT, FAILS, UNDECIDED, VOID)

#: Means of S.
WAYS = ("time", "impact")


def _verdict(so, surely_not=True):
    """Of what is so by time and by impact, and whether it surely is not so by time."""
    return HOLDS if so["time"] else PER_IMPACT if so["impact"] else FAILS if surely_not else UNDECIDED


@dataclasses.dataclass(frozen=True)
class Point:
    """The attractor of most runs at one place of a claim; by "time" and by "impact"."""
    place: float
    kind: str
    mean: dict
    shown: dict   #: (low, high) of an interval of 95 %
    judged: dict  #: of the interval that decides; all numbers where the runs have come to no attractor


def mean_of(values):
    """Of those that there are; NaN of none: what is accelerated has no mean."""
    there = values[numpy.isfinite(values)]
    return float(there.mean()) if there.size else numpy.nan


def point_of(place, group, level):
    values = {way: group.spins(way) for way in WAYS}
    everything = (-numpy.inf, numpy.inf)
    return Point(place, group.kind,
                 {way: mean_of(v) for way, v in values.items()}, {way: interval(v) for way, v in values.items()},
                 {way: everything if group.kind in NO_ATTRACTOR else interval(v, level) for way, v in values.items()})


def _with_impacts(points):
    """Those at which the body does not ride with the floor."""
    return [point for point in points if point.kind != RIDING]


def sides_of(points, way, sign):
    """(yes, no, open) of the places with impacts: a mean of that sign, one that is surely not, neither."""
    ends = [sorted(sign * end for end in point.judged[way]) for point in _with_impacts(points)]
    yes, no = sum(low > 0 for low, _ in ends), sum(high <= 0 for _, high in ends)
    return yes, no, len(ends) - yes - no


def _nothing_to_judge(parameter):
    return VOID, f"the body rides with the floor at every {parameter}: S = 0"


def _is_so(counts):
    """Surely not so nowhere, and so at half of the places or more."""
    yes, no, undecided = counts
    return no == 0 and yes >= (yes + undecided) / 2


def _in_words(points):
    """Which places had no attractor to judge, and where the body rides with the floor."""
    said = ""
    for kinds, what in ((NO_ATTRACTOR, "still transient"), ((RIDING,), "rides with the floor")):
        places = [f"{point.place:g}" for point in points if point.kind in kinds]
        said += f"; {what} at {', '.join(places)}" if places else ""
    return said


def verdict_on_sign(points, sign):
    """(verdict, in numbers)."""
    if not _with_impacts(points):
        return _nothing_to_judge("alpha")
    counts = {way: sides_of(points, way, sign) for way in WAYS}
    verdict = _verdict({way: _is_so(counts[way]) for way in WAYS}, counts["time"][1] > 0)
    means = [point.mean["time"] for point in _with_impacts(points)]
    return verdict, "; ".join(f"by {way} {yes} yes, {no} no, {undecided} open"
                              for way, (yes, no, undecided) in counts.items()) + \
        f" (time means {min(means):+.3f} to {max(means):+.3f}{_in_words(points)})"


def verdict_on_one(points):
    """(verdict, in numbers): that the time mean is 1, as J visited evenly would have it."""
    if not _with_impacts(points):
        return _nothing_to_judge("alpha")
    judged = [point for point in _with_impacts(points) if point.kind not in NO_ATTRACTOR]
    near = [point.judged["time"][0] <= 1 <= point.judged["time"][1] for point in judged]
    means = [point.mean["time"] for point in _with_impacts(points)]
    return (UNDECIDED if not judged else HOLDS if all(near) else FAILS), (
        f"1 lies in the interval at {sum(near)} of {len(judged)} alpha; time means {min(means):+.3f} to {max(means):+.3f}"
        f"{_in_words(points)}")


def points_over_alpha(swirl, runs, mu, body, floor):
    """The intervals that decide are those of all places together (Bonferroni): one wrong in twenty such claims."""
    level = 1 - 0.05 / len(ALPHA)
    return [point_of(alpha, attractors(swirl, runs, sides=body, alpha=alpha, beta=BETA, mu=mu, restitution=1, **floor)[0], level)
            for alpha in ALPHA]


def friction_grid(swirl, runs, floor):
    """{mu: [(omega_s, runs)]} of the hexagon of Figure 7."""
    return {mu: [(omega, attractors(swirl, runs, sides=6, alpha=0.3, beta=BETA, mu=mu, restitution=1,
                                    speed=1 / (7 * omega), **floor)[0]) for omega in OMEGA] for mu in MU}


def _rides_everywhere(grid):
    return all(group.kind == RIDING for groups in grid.values() for _, group in groups)


def _share_of_step(grid, way, random=None):
    """How much the means differ over mu > 0, in parts of the step from mu = 0, and these means; of resampled runs."""
    mean = {}
    for mu, groups in grid.items():
        values = numpy.concatenate([group.spins(way) for _, group in groups])
        values = values[numpy.isfinite(values)]  # by impact none where it rides
        mean[mu] = mean_of(values if random is None else random.choice(values, len(values)))
    with_friction = [mean[mu] for mu in MU if mu > 0]
    return (max(with_friction) - min(with_friction)) / abs(mean[0.0] - numpy.mean(with_friction)), mean


def verdict_on_size(grid):
    """(verdict, in numbers): that mu > 0 matters less than a tenth of the step from mu = 0, and changes no sign."""
    if _rides_everywhere(grid):
        return _nothing_to_judge("mu")
    told, so, not_so = [], {}, {}
    for way in WAYS:
        share, mean = _share_of_step(grid, way)
        if not numpy.isfinite(share):
            so[way] = not_so[way] = False
            told.append(f"by {way} S = " + ", ".join(
                f"{f'{mean[mu]:+.3f}' if numpy.isfinite(mean[mu]) else 'none'} at mu = {mu:g}" for mu in MU))
            continue
        random = numpy.random.default_rng(1)
        shares = [_share_of_step(grid, way, random)[0] for _ in range(1000)]
        low, high = numpy.quantile(shares, [0.025, 0.975])
        with_friction = [mean[mu] for mu in MU if mu > 0]
        one_sign = min(with_friction) * max(with_friction) > 0
        so[way], not_so[way] = high < 0.1 and one_sign, low > 0.1
        told.append(f"by {way} S = {mean[0.0]:+.3f} at mu = 0, {mean[0.1]:+.3f} at 0.1, {min(with_friction):+.3f} to "
                    f"{max(with_friction):+.3f} from 0.1 to 1: {100 * share:.0f} % of the step ({100 * low:.0f} to "
                    f"{100 * high:.0f} %)")
    return _verdict(so, not_so["time"]), "; ".join(told)


def verdict_on_proportion(grid):
    """(verdict, in numbers): that S is the same at every omega_s, for each mu: the mean over omega_s lies in all intervals."""
    if _rides_everywhere(grid):
        return _nothing_to_judge("mu")
    level = 1 - 0.05 / (len(MU) * len(OMEGA))
    outside = {}
    for way in WAYS:
        outside[way] = 0
        for groups in grid.values():
            values = [group.spins(way) for _, group in groups]
            middle = mean_of(numpy.concatenate(values))
            ends = [interval(v, level) for v in values]
            outside[way] += sum(not low <= middle <= high for low, high in ends)
    return _verdict({way: count == 0 for way, count in outside.items()}), "; ".join(
        f"by {way} {count} of {len(MU) * len(OMEGA)} intervals leave out the mean over omega_s" for way, count in outside.items())


#: A chaotic, a quasi-steady (period 8) and a steady scene.
MODES = {"chaotic": dict(sides=6, alpha=0.3, beta=0.1, mu=0.1, restitution=1),
         "quasi-steady": dict(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95),
         "steady": dict(sides=6, alpha=0.4, beta=0.5, mu=0.5, restitution=0.9)}


def recurrence_by_mode(swirl, runs, floor):
    """{mode: attractor}: the scenes of MODES, named by the mode that they have without a floor."""
    return {mode: attractors(swirl, runs, **scene, **floor)[0] for mode, scene in MODES.items()}


def expected_recurrence(attractor):
    """What the paper says of RC: None of chaos (< 1e-4), 1/k of k values; NaN where it says nothing."""
    return None if attractor.kind == "chaotic" else 1 / attractor.period if attractor.period else numpy.nan


def verdict_on_recurrence(found):
    """(verdict, in numbers). With its diagonal RC is 1/n at least, which is above the paper's bound for its own runs."""
    so, told = [], []
    for mode, attractor in found.items():
        expected, values = expected_recurrence(attractor), attractor.recurrence
        if expected is None:
            so.append(values.max() < 1e-4)
            told.append(f"{mode}: {values.max():.1e} at most without the diagonal, {1 / IMPACTS:.1e} at least with it (paper: < 1e-4)")
        elif numpy.isfinite(expected):
            so.append(abs(values - expected).max() < 2 / IMPACTS)  # one period's rounding of the counts
            told.append(f"{mode}: {values.mean():.4f} for {expected:.4f}")
        else:
            told.append(f"{mode}: is {attractor.kind}")
    return (VOID if not so else HOLDS if all(so) else FAILS), "; ".join(told)
