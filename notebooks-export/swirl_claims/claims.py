"""The claims, each with its runs and its verdict: `holds`, `holds per impact only`, or `fails`, with numbers."""

import dataclasses

import numpy

from .sampling import IMPACTS, attractors, interval

#: N; the disk last.
BODIES = ("3", "4", "6", "8", "disk")

#: R_p/R_c and r_s/R_c of the runs; the paper's friction.
ALPHA, BETA, FRICTION = tuple(round(0.1 * k, 1) for k in range(1, 10)), 0.1, 0.5

#: The axes of the paper's Figure 7, in its units of 1/s; omega_s enters through the speed of the start, 1/(7 omega_s).
MU, OMEGA = tuple(round(0.1 * k, 1) for k in range(11)), tuple(range(1, 11))

HOLDS, PER_IMPACT, FAILS = "holds", "holds per impact only", "fails"


@dataclasses.dataclass(frozen=True)
class Point:
    """The attractor of most runs at one place of a claim."""
    place: float
    kind: str
    share: float
    mean: dict      #: by "time" and "impact"
    low: dict       #: of an interval of 95 %
    high: dict
    side: dict      #: +1 or -1 where an interval at `level` lies on one side of 0, else 0


def point_of(place, group, level):
    values = {"time": group.by_time, "impact": group.by_impact}
    shown = {way: interval(v) for way, v in values.items()}
    judged = {way: interval(v, level) for way, v in values.items()}
    return Point(place, group.kind, group.share, {way: float(numpy.nanmean(v)) for way, v in values.items()},
                 {way: float(pair[0]) for way, pair in shown.items()}, {way: float(pair[1]) for way, pair in shown.items()},
                 {way: int(low > 0) - int(high < 0) for way, (low, high) in judged.items()})


def sides_of(points, way, sign):
    """(yes, no, open) of the places."""
    side = [sign * point.side[way] for point in points]
    return side.count(1), side.count(-1), side.count(0)


def _is_so(counts):
    """On the other side nowhere, and on this one at half of the places or more."""
    yes, no, undecided = counts
    return no == 0 and yes >= (yes + undecided) / 2


def verdict_on_sign(points, sign):
    """(verdict, in numbers)."""
    counts = {way: sides_of(points, way, sign) for way in ("time", "impact")}
    verdict = HOLDS if _is_so(counts["time"]) else PER_IMPACT if _is_so(counts["impact"]) else FAILS
    means = [point.mean["time"] for point in points]
    return verdict, "; ".join(f"by {way} {yes} yes, {no} no, {undecided} open"
                              for way, (yes, no, undecided) in counts.items()) + \
        f" (time means {min(means):+.3f} to {max(means):+.3f})"


def verdict_on_one(points):
    """(verdict, in numbers): that the time mean is 1, as J visited evenly would have it."""
    near = [point.place for point in points if point.low["time"] <= 1 <= point.high["time"]]
    means = [point.mean["time"] for point in points]
    return HOLDS if len(near) == len(points) else FAILS, (
        f"1 lies in the interval (95 %) at {len(near)} of {len(points)} alpha; time means {min(means):+.3f} to {max(means):+.3f}")


def points_over_alpha(swirl, runs, mu, body):
    """The intervals that decide are those of all places together (Bonferroni): one wrong in twenty such claims."""
    level = 1 - 0.05 / len(ALPHA)
    return [point_of(alpha, attractors(swirl, runs, sides=body, alpha=alpha, beta=BETA, mu=mu, restitution=1)[0], level)
            for alpha in ALPHA]


def friction_grid(swirl, runs):
    """{mu: [Point at each omega_s]} of the hexagon of Figure 7."""
    level = 1 - 0.05 / (len(MU) * len(OMEGA))
    return {mu: [point_of(omega, attractors(swirl, runs, sides=6, alpha=0.3, beta=BETA, mu=mu, restitution=1,
                                            speed=1 / (7 * omega))[0], level) for omega in OMEGA] for mu in MU}


def verdict_on_size(grid):
    """(verdict, in numbers): that mu > 0 matters less than a tenth of the step from mu = 0, and changes no sign."""
    told, so = [], {}
    for way in ("time", "impact"):
        mean = {mu: numpy.mean([point.mean[way] for point in points]) for mu, points in grid.items()}
        with_friction = [mean[mu] for mu in MU if mu > 0]
        spread, step = max(with_friction) - min(with_friction), mean[0.0] - numpy.mean(with_friction)
        so[way] = spread < 0.1 * abs(step) and min(with_friction) * max(with_friction) > 0
        told.append(f"by {way} S = {mean[0.0]:+.3f} at mu = 0, {mean[0.1]:+.3f} at 0.1, {min(with_friction):+.3f} to "
                    f"{max(with_friction):+.3f} from 0.1 to 1: {100 * spread / abs(step):.0f} % of the step")
    return HOLDS if so["time"] else PER_IMPACT if so["impact"] else FAILS, "; ".join(told)


def verdict_on_proportion(grid):
    """(verdict, in numbers): that omega_p is proportional to omega_s, S the same at every omega_s, for each mu."""
    worst = {}
    for way in ("time", "impact"):
        deviations = []
        for points in grid.values():
            error = numpy.array([(point.high[way] - point.low[way]) / (2 * 1.96) for point in points])
            mean = numpy.array([point.mean[way] for point in points])
            middle = numpy.average(mean, weights=1 / error ** 2)
            deviations.append(float(max(abs(mean - middle) / error)))
        worst[way] = max(deviations)
    limit = 4.0  # of 110 values a normal one exceeds that once in 140 claims
    verdict = HOLDS if worst["time"] < limit else PER_IMPACT if worst["impact"] < limit else FAILS
    return verdict, "; ".join(f"by {way} {value:.1f} standard errors at most from the mean over omega_s"
                              for way, value in worst.items())


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
