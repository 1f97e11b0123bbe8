"""Recurrence and spectra of random series beside an implementation of its own: random_series_test.py SWIRL [SERIES [SEED]]

Of each series, of 20 to 3,000 rows, noise, walks, maps, few whole numbers, rounded sines or a constant, with gaps, lost rows
or uneven times: recurrence under random conventions, and the spectrum. Everything is written out here from the definitions
(analysis/recurrence/README.md, analysis/spectrum/README.md) in NumPy: whole matrices, lines one by one, sums without a
transform where times are uneven."""

import json
import random
import sys
import unittest

import numpy

SEED = int(sys.argv.pop(3)) if len(sys.argv) > 3 and sys.argv[3].isdigit() else 1
SERIES = int(sys.argv.pop(2)) if len(sys.argv) > 2 and sys.argv[2].isdigit() else 160

from driving import InFolder, run

#: Sums of up to 1e7 integers are exact; logarithms and divisions round a few hundred times.
SUMS = 1e-12
#: Of the largest power: transforms of 3,000 samples round by some 1e-14 of it, the nonuniform one by 1e-12.
POWERS = 1e-10

KINDS = {
    "noise": lambda draw, n: draw.normal(size=n),
    "walk": lambda draw, n: numpy.cumsum(draw.normal(size=n)),
    "logistic": lambda draw, n: logistic(draw.uniform(0.1, 0.9), n),
    "few numbers": lambda draw, n: draw.integers(0, 4, size=n).astype(float),
    "rounded sine": lambda draw, n: numpy.round(numpy.sin(draw.uniform(0.05, 2) * numpy.arange(n)), 1),
    "sines": lambda draw, n: numpy.sin(0.3 * numpy.arange(n)) + 0.5 * numpy.sin(1.17 * numpy.arange(n)) +
             0.1 * draw.normal(size=n),
    "constant": lambda draw, n: numpy.full(n, draw.integers(-3, 4) / 4),
}


def logistic(x, n):
    values = []
    for _ in range(n):
        x = 3.9 * x * (1 - x)
        values.append(x)
    return numpy.array(values)


class Case:
    """A random series and the options with which it is analysed."""

    def __init__(self, seed):
        self.choose, self.draw = random.Random(seed), numpy.random.default_rng(seed)
        choose = self.choose
        self.count = int(20 * 150 ** choose.random())
        self.kind = list(KINDS)[seed % len(KINDS)]
        self.values = KINDS[self.kind](self.draw, self.count)
        self.times = numpy.arange(float(self.count)) * choose.choice((1, 0.25))
        self.missing = choose.choice(("", "", "gaps", "lost rows", "uneven"))
        if self.missing == "gaps":
            self.values[self.draw.random(self.count) < choose.choice((0.002, 0.02, 0.1))] = numpy.nan
        if self.missing == "uneven":
            self.times = numpy.cumsum(self.draw.uniform(0.3, 1.7, self.count))
        there = numpy.ones(self.count, bool)
        if self.missing == "lost rows":
            there[1:-1] = self.draw.random(self.count - 2) > 0.01
        self.rows = [(t, v) for t, v, kept in zip(self.times, self.values, there) if kept]
        self.values[~there] = numpy.nan
        # Steps of two rows that are no seldom exception may be long flights: samples they are if so it is said.
        self.reading = "--rows samples" if self.missing == "lost rows" else ""
        # Missing ends are no rows.
        known = numpy.flatnonzero(~numpy.isnan(self.values))
        self.values, self.times = (x[known[0]:known[-1] + 1] for x in (self.values, self.times))

    def write(self, path):
        path.write_text("t,S\n" + "".join(f"{t!r},{'' if numpy.isnan(v) else repr(float(v))}\n" for t, v in self.rows))

    def __str__(self):
        return f"{self.kind}, {self.count} rows, {self.missing or 'whole'}"


def runs(line):
    """(first, length) of the runs of true."""
    edges = numpy.diff(numpy.concatenate(([0], line.astype(numpy.int8), [0])))
    first = numpy.flatnonzero(edges == 1)
    return zip(first.tolist(), (numpy.flatnonzero(edges == -1) - first).tolist())


class Recurrence:
    """The matrix of a series and its measures, under options that are drawn."""

    def __init__(self, case):
        choose = case.choose
        longest = max(1, len(case.values) // 20)
        self.dimension, self.delay = choose.randint(1, 4), choose.randint(1, min(7, longest))
        self.norm = choose.choice(("euclidean", "maximum", "manhattan"))
        self.theiler = choose.choice((0, 1, 1, 2, 5, 10))
        self.strict = choose.random() < 0.3
        self.least_diagonal, self.least_vertical = choose.choice((2, 2, 1, 3, 5)), choose.choice((2, 2, 1, 4))
        self.discards = choose.random() < 0.25
        self.one_triangle = choose.random() < 0.25
        self.all_pairs = choose.random() < 0.25
        self.time = choose.choice(("midpoints", "midpoints", "white-lines", "line-starts"))
        self.logarithm = choose.choice(("natural", "natural", "binary", "decimal"))
        self.threshold = choose.choice((("threshold", 0.0), ("threshold", 1.0), ("threshold", 0.3), ("threshold-std", 0.1),
                                        ("threshold-std", 0.5), ("recurrence-rate", 0.02), ("recurrence-rate", 0.2)))
        shifts = [case.values[k * self.delay:len(case.values) - (self.dimension - 1 - k) * self.delay]
                  for k in range(self.dimension)]
        known = numpy.flatnonzero(~numpy.isnan(shifts).any(axis=0))
        shifts = [x[known[0]:known[-1] + 1] for x in shifts]  # as of the series: missing ends are no rows
        self.there = ~numpy.isnan(shifts).any(axis=0)
        self.rows = len(self.there)
        self.distance = None
        for x in shifts:
            apart = abs(x[:, None] - x[None, :])
            if self.norm == "euclidean":
                apart = apart * apart
            if self.distance is None:
                self.distance = apart
            else:
                self.distance = numpy.maximum(self.distance, apart) if self.norm == "maximum" else self.distance + apart
        if self.norm == "euclidean":
            self.distance = numpy.sqrt(self.distance)
        self.pairs = self.there[:, None] & self.there[None, :]
        self.lag = abs(numpy.arange(self.rows)[:, None] - numpy.arange(self.rows)[None, :])

    def flags(self):
        return (f"--dimension {self.dimension} --delay {self.delay} --norm {self.norm} --theiler {self.theiler} "
                f"--min-diagonal {self.least_diagonal} --min-vertical {self.least_vertical} --{self.threshold[0]} "
                f"{self.threshold[1]} --logarithm {self.logarithm} --recurrence-time {self.time}"
                + " --strict" * self.strict + " --border-lines discarded" * self.discards
                + " --triangles one" * self.one_triangle + " --rate-pairs all" * self.all_pairs)

    def expected_threshold(self, case):
        """None where a recurrence rate was asked for: see holds_rate()."""
        name, number = self.threshold
        if name == "threshold":
            return number
        if name == "threshold-std":
            return number * numpy.std(case.values[~numpy.isnan(case.values)], ddof=1)
        return None

    def holds_rate(self, delta):
        """delta is the least distance at which as many of the pairs outside the window are recurrent as were asked for."""
        distances = self.distance[self.pairs & (self.lag >= max(self.theiler, 0))]
        wanted = self.threshold[1] * distances.size
        below, within = (distances < delta).sum(), (distances <= delta).sum()
        if self.strict:
            before = distances[distances < delta].max(initial=-1)
            return below >= wanted and (distances < before).sum() < wanted
        return within >= wanted and below < wanted

    def recurs(self, delta):
        with numpy.errstate(invalid="ignore"):
            return self.pairs & (self.distance < delta if self.strict else self.distance <= delta)

    def entropy(self, lengths):
        if not lengths:
            return None
        share = numpy.unique(lengths, return_counts=True)[1] / len(lengths)
        base = {"natural": 1, "binary": numpy.log(2), "decimal": numpy.log(10)}[self.logarithm]
        return float(-(share * numpy.log(share)).sum() / base)

    def diagonals(self, matrix):
        lengths = []
        for lag in range(0 if self.theiler == 0 else self.theiler, self.rows):
            of_lag = []
            line, there = numpy.diagonal(matrix, lag), numpy.diagonal(self.pairs, lag)
            for first, length in runs(line):
                edge = first == 0 or first + length == len(line) or not there[first - 1] or not there[first + length]
                if not (self.discards and edge):
                    of_lag.append(length)
            lengths += of_lag * (1 if lag == 0 or self.one_triangle else 2)
        return lengths

    def verticals(self, matrix):
        """Lengths of lines, and the times between them."""
        lengths, times = [], []
        for column in range(self.rows):
            before = None
            for first, length in runs(matrix[:, column]):
                end = first + length
                edge = (first == 0 or end == self.rows or not self.there[first - 1] or not self.there[end])
                if not (self.discards and edge):
                    lengths.append(length)
                if before and self.there[before[0]:first].all():
                    white = first - before[0] - before[1]
                    times.append({"white-lines": white, "line-starts": first - before[0],
                                  "midpoints": white + length // 2 + before[1] // 2}[self.time])
                before = (first, length)
        return lengths, times

    def trend(self, matrix):
        last = self.rows - 10  # of the border
        rates, weights = [], []
        for d in range(1 + self.theiler, last + 1):
            pairs = numpy.diagonal(self.pairs, d - 1).sum()
            if pairs:
                rates.append(numpy.diagonal(matrix, d - 1).sum() / pairs)
                weights.append(d - (self.theiler + last) / 2)
        rates, weights = numpy.array(rates), numpy.array(weights)
        squares = (weights ** 2).sum()
        return 1000 * (weights * (rates - rates.mean())).sum() / squares if squares > 0 else None

    def measures(self, delta):
        inside = self.lag < self.theiler
        whole = self.recurs(delta)
        matrix = whole & ~inside
        points, there = int(matrix.sum()), int(self.there.sum())
        pairs = there ** 2 if self.all_pairs else int((self.pairs & ~inside).sum())
        lengths = self.diagonals(matrix)
        long = [length for length in lengths if length >= self.least_diagonal]
        vertical, times = self.verticals(matrix)
        tall = [length for length in vertical if length >= self.least_vertical]
        with numpy.errstate(invalid="ignore"):
            rc = int((self.pairs & (self.distance <= delta)).sum()) / there ** 2
        mean = lambda lengths: sum(lengths) / len(lengths) if lengths else 0
        return {"RR": points / pairs if pairs else 0, "DET": sum(long) / sum(lengths) if lengths else 0, "L": mean(long),
                "Lmax": max(long, default=0), "DIV": 1 / max(long) if long else None, "ENTR": self.entropy(long),
                "LAM": sum(tall) / sum(vertical) if vertical else 0, "TT": mean(tall), "Vmax": max(tall, default=0),
                "VENTR": self.entropy(tall), "MRT": mean(times), "RTE": self.entropy(times), "TREND": self.trend(matrix),
                "RC": rc}


WINDOWS = {"rectangular": (1,), "hann": (0.5, 0.5), "hamming": (0.54, 0.46), "blackman-harris": (0.35875, 0.48829, 0.14128, 0.01168)}


def window(name, length):
    angle = 2 * numpy.pi * numpy.arange(length) / length
    return sum((-1) ** k * a * numpy.cos(k * angle) for k, a in enumerate(WINDOWS[name]))


def detrended(values, detrend):
    there = ~numpy.isnan(values)
    row = numpy.arange(len(values))
    if detrend == "mean":
        return values - values[there].mean()
    return values - numpy.polyval(numpy.polyfit(row[there], values[there], 1), row) if detrend == "linear" else values


def welch(values, settings):
    """Powers at the frequencies of its segments, scaled so that they add up to the variance."""
    values = detrended(values, settings["detrend"])
    length = settings["segment_length"]
    hop = max(1, int(length * (1 - settings["overlap"]) + 0.5))
    weights = window(settings["window"], length)
    powers = []
    for first, samples in runs(~numpy.isnan(values)):
        for start in range(first, first + samples - length + 1, hop):
            powers.append(abs(numpy.fft.rfft(weights * values[start:start + length])) ** 2)
    mean = numpy.mean(powers, axis=0)
    mean[1:length // 2 if length % 2 == 0 else None] *= 2
    return mean / mean.sum() * numpy.nanmean(values ** 2), len(powers)


def lomb_scargle(times, values, frequencies):
    powers = []
    for omega in 2 * numpy.pi * frequencies:
        angle = omega * times
        tau = numpy.arctan2(numpy.sin(2 * angle).sum(), numpy.cos(2 * angle).sum()) / 2
        c, s = numpy.cos(angle - tau), numpy.sin(angle - tau)
        powers.append((values @ c) ** 2 / (c @ c) + ((values @ s) ** 2 / (s @ s) if s @ s > 1e-9 else 0))
    return numpy.array(powers) / 2


class RandomSeries(InFolder):
    def analysed(self, command):
        result = run(f"{command} --threads 1 --json --quiet")
        self.assertIn(result.returncode, (0, 3), (command, result.stderr))
        return json.loads(result.stdout)

    def same(self, found, expected, within, what):
        if expected is None:
            self.assertIsNone(found, what)
        else:
            self.assertIsNotNone(found, what)
            self.assertLessEqual(abs(found - expected), within * max(1, abs(expected)), (what, found, expected))

    def check_recurrence(self, case, path):
        matrix = Recurrence(case)
        command = f"recurrence --series {path} {case.reading} {matrix.flags()}"
        found = self.analysed(command)
        what = (str(case), command)
        delta = found["settings"]["threshold"]
        expected = matrix.expected_threshold(case)
        if found["settings"].get("threshold_is_rounding_floor"):  # of a constant: everything recurs
            self.assertEqual(case.kind, "constant", what)
        elif expected is None:
            self.assertTrue(matrix.holds_rate(delta), what)
        else:
            self.same(delta, expected, 1e-13, what)
        for name, value in matrix.measures(delta).items():
            self.same(found[name], value, SUMS, (*what, name))

    def check_spectrum(self, case, path):
        choose = case.choose
        flags = f"--detrend {choose.choice(('none', 'mean', 'mean', 'linear'))}"
        if case.missing != "uneven" and case.missing != "gaps":
            flags += f" --window {choose.choice(list(WINDOWS))} --overlap {choose.choice((0.5, 0.5, 0, 0.75))}"
        command = f"spectrum --series {path} {case.reading} {flags}"
        found = self.analysed(command)
        what = (str(case), command)
        settings, power = found["settings"], numpy.array(found["power"])
        if found["spectrum_outcome"] == "constant":
            self.assertEqual(case.kind, "constant", what)
            return
        self.assertEqual(found["spectrum_outcome"], "completed", what)
        self.assertNotEqual((case.kind, settings["detrend"] != "none"), ("constant", True), what)
        step = found["frequency_step"]
        if found["method"] == "welch":
            self.assertNotEqual(case.missing, "uneven", what)
            expected, segments = welch(case.values, settings)
            self.assertEqual(found["segments"], segments, what)
            self.same(step, 1 / (settings["segment_length"] * (case.times[1] - case.times[0])), 1e-12, what)
        else:
            there = ~numpy.isnan(case.values)
            times, values = case.times[there], detrended(case.values, settings["detrend"])[there]
            if case.missing == "uneven" and settings["detrend"] == "linear":
                values = case.values - numpy.polyval(numpy.polyfit(case.times, case.values, 1), case.times)
            expected = lomb_scargle(times, values, numpy.array(found["frequency"]))
            expected *= (values ** 2).mean() / expected.sum()
        self.assertEqual(len(power), len(expected), what)
        self.assertLessEqual(abs(power * step - expected).max(), POWERS * expected.max(), what)
        share = expected[1:] if found["frequency"][0] == 0 else expected
        share = share / share.sum()
        if case.kind == "constant":  # all of it at frequency 0
            return
        self.same(found["entropy"], -(share[share > 0] * numpy.log(share[share > 0])).sum() / numpy.log(len(share)), 1e-9, what)

    def test_measures_and_powers_are_those_of_another_implementation(self):
        for seed in range(SEED, SEED + SERIES):
            case = Case(seed)
            path = self.folder / "series.csv"
            case.write(path)
            for check in (self.check_recurrence, self.check_spectrum):
                with self.subTest(seed=seed, of=check.__name__):
                    check(case, path)


if __name__ == "__main__":
    unittest.main()
