"""Runs of `swirl classify --runs`, by attractor, and what they say of a mean: by time and by impact, with bootstrap
intervals over the runs of one attractor."""

import dataclasses
import json
import subprocess

import numpy

#: As in the paper: 4,000 impacts of each run; those of a transient are left out first.
TRANSIENT, IMPACTS = 1000, 4000

#: Of an interval; so many that the tails of one at a level of 0.05 % are resolved.
RESAMPLES = 20_000

#: Fewer runs than that say nothing of a mean: the interval is all numbers.
LEAST_RUNS = 12

#: Kinds of a run that has come to no attractor yet.
NO_ATTRACTOR = ("transient", "none", "")

#: The kind of a body that goes along with the floor and meets the wall no more: S = 0, and no impacts.
RIDING = "riding"


@dataclasses.dataclass(frozen=True)
class Attractor:
    """Runs that came to one attractor: means of S, a value each."""
    kind: str
    share: float
    period: int | None  #: of a cycle
    by_time: numpy.ndarray
    by_impact: numpy.ndarray
    recurrence: numpy.ndarray  #: RC without its diagonal

    def spins(self, way):
        """By "time" or by "impact"."""
        return self.by_time if way == "time" else self.by_impact


def attractors(swirl, runs, seed=1, **scene):
    """Of `runs` random starts, that of the largest share first. `scene`: flags of classify, `sides=6, mu=0.5, …`."""
    flags = [word for name, value in scene.items() for word in (f"--{name.replace('_', '-')}", str(value))]
    command = [swirl, "classify", *flags, "--runs", str(runs), "--seed", str(seed), "--transient", str(TRANSIENT),
               "--collisions", str(IMPACTS), "--json", "--quiet"]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{' '.join(command)}: {done.stderr.strip()}")
    found = json.loads(done.stdout)
    groups = []
    for place, attractor in enumerate(found["attractors"]):
        own = [run for run in found["runs"] if run["attractor"] == place]
        of = {key: numpy.array([numpy.nan if run[key] is None else run[key] for run in own])
              for key in ("mean_S", "mean_S_per_impact", "recurrence_rate")}
        groups.append(Attractor(str(attractor["kind"]), attractor["share"], attractor["period"], of["mean_S"], of["mean_S_per_impact"],
                                (of["recurrence_rate"] * IMPACTS - 1) / (IMPACTS - 1)))
    return groups


def _resampled(values, seed):
    """(means, standard errors) of samples of the values, drawn with replacement."""
    random = numpy.random.default_rng(seed)
    drawn = values[random.integers(len(values), size=(RESAMPLES, len(values)))]
    return drawn.mean(axis=1), drawn.std(axis=1, ddof=1) / len(values) ** 0.5


def interval(values, level=0.95, seed=1):
    """(low, high) of the mean by the studentised bootstrap (Efron and Tibshirani 1993, 12.5): the quantiles of
    t = (mean of a resample - mean) / its standard error. Percentiles of the means would be too narrow in the tails."""
    values = values[numpy.isfinite(values)]
    if len(values) < LEAST_RUNS:
        return -numpy.inf, numpy.inf
    mean, error = values.mean(), values.std(ddof=1) / len(values) ** 0.5
    if error == 0:
        return float(mean), float(mean)
    means, errors = _resampled(values, seed)
    t = (means - mean) / numpy.maximum(errors, 1e-3 * error)
    low, high = numpy.quantile(t, [(1 - level) / 2, (1 + level) / 2])
    return float(mean - high * error), float(mean - low * error)
