"""What a peer's impacts are worth against quad's."""

import math
import statistics
from dataclasses import dataclass

from scipy.stats import beta

from container_frame import jacobi


def clopper_pearson(hits, count, level=0.95):
    """The exact two-sided interval of a rate of which `hits` of `count` were seen."""
    tail = (1 - level) / 2
    low = 0.0 if hits == 0 else beta.ppf(tail, hits, count - hits + 1)
    high = 1.0 if hits == count else beta.ppf(1 - tail, hits + 1, count - hits)
    return low, high


def quantile(values, share):
    ordered = sorted(values)
    return ordered[min(len(ordered) - 1, int(share * len(ordered)))] if ordered else math.nan


def time_at_error(points, error):
    """From a solver's (error, time) at some tolerances its time at an error, on the power law between the two nearest;
    None if it never comes there.
    """
    better, worse = [p for p in points if p[0] <= error], [p for p in points if p[0] > error]
    if not better:
        return None
    if not worse:
        return min(time for _, time in better)
    (e1, t1), (e0, t0) = max(better), min(worse)
    return t0 * (t1 / t0)**(math.log(e0 / error) / math.log(e0 / e1))


def state_error(impact, truth):
    """The largest difference of cis psi, cis chi, v_n, v_t and S."""
    return max(abs(a - b) for a, b in zip(impact.after, truth.after))


@dataclass(frozen=True)
class Judgement:
    count: int
    missed: int       # none found, or a later one in its place
    misordered: int   # another vertex at that time, or a contact before the first
    late: float       # median of found - true time, of the others
    error: float      # median of the state's error, of the others
    worst: float      # its 95 % quantile
    drift: float      # mean of what an impact adds to J beyond the true change, of the others


def judge(scene, impacts, truths, slack):
    """`slack`: how late or early a contact may be and still be that contact."""
    missed = misordered = 0
    delays, errors, gains = [], [], []
    for impact, truth in zip(impacts, truths):
        delay = impact.time - truth.time
        if not impact.found or delay > slack:
            missed += 1
        elif delay < -slack or impact.vertex != truth.vertex:
            misordered += 1
        else:
            delays.append(delay)
            errors.append(state_error(impact, truth))
            gains.append(jacobi(scene, impact.after) - jacobi(scene, truth.after))
    late = statistics.median(delays) if delays else math.nan
    return Judgement(len(impacts), missed, misordered, late, quantile(errors, 0.5), quantile(errors, 0.95),
                     statistics.mean(gains) if gains else math.nan)
