"""The claims, each with its runs and its verdict: `holds`, `holds per impact only`, `fails`, or `undecided`, with numbers."""

import dataclasses

import numpy

from .sampling import IMPACTS, NO_ATTRACTOR, attractors, interval

#: N; the disk last.
BODIES = ("3", "4", "6", "8", "disk")

#: R_p/R_c and r_s/R_c of the runs; the paper's friction.
ALPHA, BETA, FRICTION = tuple(round(0.1 * k, 1) for k in range(1, 10)), 0.1, 0.5

#: The axes of the paper's Figure 7, in its units of 1/s; omega_s enters through the speed of the start, 1/(7 omega_s).
MU, OMEGA = tuple(round(0.1 * k, 1) for k in range(11)), tuple(range(1, 11))

HOLDS, PER_IMPACT, FAILS, UNDECIDED = "holds", "holds per impact only", "fails", "undecided"

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


def sides_of(points, way, sign):
    """(yes, no, open) of the places: a mean of that sign, one that is surely not, neither."""
    ends = [sorted(sign * end for end in point.judged[way]) for point in points]
    yes, no = sum(low > 0 for low, _ in ends), sum(high <= 0 for _, high in ends)
    return yes, no, len(points) - yes - no


def _is_so(counts):
    """Surely not so nowhere, and so at half of the places or more."""
    yes, no, undecided = counts
    return no == 0 and yes >= (yes + undecided) / 2


def _in_words(points):
    """Which places had no attractor to judge."""
    unsettled = [f"{point.place:g}" for point in points if point.kind in NO_ATTRACTOR]
    return f"; still transient at {', '.join(unsettled)}" if unsettled else ""


def verdict_on_sign(points, sign):
    """(verdict, in numbers)."""
    counts = {way: sides_of(points, way, sign) for way in WAYS}
    verdict = _verdict({way: _is_so(counts[way]) for way in WAYS}, counts["time"][1] > 0)
    means = [point.mean["time"] for point in points]
    return verdict, "; ".join(f"by {way} {yes} yes, {no} no, {undecided} open"
                              for way, (yes, no, undecided) in counts.items()) + \
        f" (time means {min(means):+.3f} to {max(means):+.3f}{_in_words(points)})"


def verdict_on_one(points):
    """(verdict, in numbers): that the time mean is 1, as J visited evenly would have it."""
    near = [point.judged["time"][0] <= 1 <= point.judged["time"][1] for point in points]
    means = [point.mean["time"] for point in points]
    return HOLDS if all(near) else FAILS, (
        f"1 lies in the interval at {sum(near)} of {len(points)} alpha; time means {min(means):+.3f} to {max(means):+.3f}")


def points_over_alpha(swirl, runs, mu, body):
    """The intervals that decide are those of all places together (Bonferroni): one wrong in twenty such claims."""
    level = 1 - 0.05 / len(ALPHA)
    return [point_of(alpha, attractors(swirl, runs, sides=body, alpha=alpha, beta=BETA, mu=mu, restitution=1)[0], level)
            for alpha in ALPHA]


def friction_grid(swirl, runs):
    """{mu: [(omega_s, runs)]} of the hexagon of Figure 7."""
    return {mu: [(omega, attractors(swirl, runs, sides=6, alpha=0.3, beta=BETA, mu=mu, restitution=1,
                                    speed=1 / (7 * omega))[0]) for omega in OMEGA] for mu in MU}


def _share_of_step(grid, way, random=None):
    """How much the means differ over mu > 0, in parts of the step from mu = 0, and these means; of resampled runs."""
    mean = {}
    for mu, groups in grid.items():
        values = numpy.concatenate([group.spins(way) for _, group in groups])
        mean[mu] = (values if random is None else random.choice(values, len(values))).mean()
    with_friction = [mean[mu] for mu in MU if mu > 0]
    return (max(with_friction) - min(with_friction)) / abs(mean[0.0] - numpy.mean(with_friction)), mean


def verdict_on_size(grid):
    """(verdict, in numbers): that mu > 0 matters less than a tenth of the step from mu = 0, and changes no sign."""
    told, so, not_so = [], {}, {}
    for way in WAYS:
        share, mean = _share_of_step(grid, way)
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
    level = 1 - 0.05 / (len(MU) * len(OMEGA))
    outside = {}
    for way in WAYS:
        outside[way] = 0
        for groups in grid.values():
            values = [group.spins(way) for _, group in groups]
            middle = numpy.concatenate(values).mean()
            ends = [interval(v, level) for v in values]
            outside[way] += sum(not low <= middle <= high for low, high in ends)
    return _verdict({way: count == 0 for way, count in outside.items()}), "; ".join(f"by {way} {count} of {len(MU) * len(OMEGA)} intervals leave out the mean over omega_s"
                              for way, count in outside.items())


#: A chaotic, a quasi-steady and a steady scene, and the RC that the paper expects of each (k values: 1/k).
MODES = {"chaotic": (dict(sides=6, alpha=0.3, beta=0.1, mu=0.1, restitution=1), None),
         "quasi-steady": (dict(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95), 1 / 8),
         "steady": (dict(sides=6, alpha=0.4, beta=0.5, mu=0.5, restitution=0.9), 1.0)}


def recurrence_by_mode(swirl, runs):
    """{mode: (RC without its diagonal of each run, RC that is expected or None)}."""
    return {mode: (attractors(swirl, runs, **scene)[0].recurrence, expected) for mode, (scene, expected) in MODES.items()}


def verdict_on_recurrence(found):
    """(verdict, in numbers). With its diagonal RC is 1/n at least, which is above the paper's bound for its own runs."""
    chaotic, so = found["chaotic"][0].max(), True
    told = [f"chaotic: {chaotic:.1e} at most without the diagonal, {1 / IMPACTS:.1e} at least with it (paper: < 1e-4)"]
    so = so and chaotic < 1e-4
    for mode in ("quasi-steady", "steady"):
        values, expected = found[mode]
        error = float(abs(values - expected).max())
        so = so and error < 2 / IMPACTS  # one period's rounding of the counts
        told.append(f"{mode}: {values.mean():.4f} for {expected:.4f}")
    return HOLDS if so else FAILS, "; ".join(told)
