"""Spectra of series beside SciPy's on the same rows: spectra_of_scipy.py SWIRL [ROWS]

First that they are equal: Welch's estimate (its segments' length, Hann's window, half a segment of overlap) and Lomb and
Scargle's periodogram of uneven times, to 1e-9 of the largest power. With ROWS also times, of whole processes that read the
same file, three each in turn: of the clock and, which other work on the machine hardly changes, of the cores. SciPy's reads it
by numpy.loadtxt; of Lomb and Scargle's, whose time grows with their number, SciPy has 200 frequencies and Swirl all of them. Exit
code 77: SciPy is missing, and the test skipped."""

import json
import resource
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    from scipy import signal
except ImportError:
    print("skipped: python3-scipy is not installed (packages.txt)")
    sys.exit(77)
import numpy

SWIRL = str(Path(sys.argv[1]).resolve())
#: Of powers of a series of 20,000 rows in double: the sums' roundings, √n ε = 3e-14, times what near cancellation leaves.
LARGEST_DIFFERENCE = 1e-9
FEW = 200

SCIPY = """import sys, numpy
from scipy import signal
file, length = sys.argv[1], int(sys.argv[2])
rows = numpy.loadtxt(file, delimiter=",", skiprows=1)
t, x = rows[:, 0], rows[:, 1] - rows[:, 1].mean()
if length:
    signal.welch(x, nperseg=length, noverlap=length // 2, window="hann", detrend=False)
else:
    signal.lombscargle(t, x, 2 * numpy.pi * numpy.linspace(1e-3, 0.4, 200))
"""


def written(path, times):
    """Two lines in noise with a memory."""
    random = numpy.random.default_rng(20261127)
    noise = signal.lfilter([1], [1, -0.9], random.normal(size=len(times)))
    values = numpy.sin(2 * numpy.pi * 0.1 * times) + 0.3 * numpy.sin(2 * numpy.pi * 0.2345 * times) + 0.2 * noise
    numpy.savetxt(path, numpy.c_[times, values], fmt="%.17g", delimiter=",", header="t,S", comments="")
    return values - values.mean()


def times_of(rows, even):
    random = numpy.random.default_rng(1)
    return numpy.arange(float(rows)) if even else numpy.cumsum(random.uniform(0.2, 1.8, rows))


def of_swirl(path):
    result = subprocess.run([SWIRL, "spectrum", "--series", path, "--json", "--quiet"], capture_output=True, text=True, check=True)
    return json.loads(result.stdout)


def largest_difference(rows, even, folder):
    times = times_of(rows, even)
    values = written(folder / "series.csv", times)
    found = of_swirl(folder / "series.csv")
    frequency, power = (numpy.array(found[name]) for name in ("frequency", "power"))
    assert found["method"] == ("welch" if even else "lomb-scargle"), found["method"]
    if even:
        length = found["settings"]["segment_length"]
        _, expected = signal.welch(values, nperseg=length, noverlap=length // 2, window="hann", detrend=False)
        expected, power = expected[:len(power)] * found["variance_scale"], power
    else:
        few = numpy.unique(numpy.linspace(0, len(frequency) - 1, FEW).astype(int))
        expected = signal.lombscargle(times, values, 2 * numpy.pi * frequency[few])
        expected *= found["variance_scale"] * 2 / (rows * found["frequency_step"])
        power = power[few]
    return abs(power - expected).max() / power.max(), len(power)


def seconds(words):
    """Of the clock, and of the cores."""
    begin, used = time.perf_counter(), resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL)
    now = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.perf_counter() - begin, now.ru_utime + now.ru_stime - used.ru_utime - used.ru_stime


def print_times(rows, folder):
    for even in (True, False):
        path = folder / "long.csv"
        written(path, times_of(rows, even))
        ours = [SWIRL, "spectrum", "--series", path, "--json", "--quiet"]
        length = of_swirl(path)["settings"]["segment_length"] if even else 0
        theirs = [sys.executable, "-c", SCIPY, path, str(length)]
        pairs = [seconds(ours) + seconds(theirs) for _ in range(3)]
        clock, core, their_clock, their_core = (statistics.median(column) for column in zip(*pairs))
        what = "Welch" if even else f"Lomb-Scargle (SciPy: {FEW} of {rows // 2:,} frequencies)"
        print(f"{what}, {rows:,} rows: swirl {clock:.2f} s ({core:.2f} s of a core), SciPy {their_clock:.2f} s "
              f"({their_core:.2f} s), {their_clock / clock:.1f} times ({their_core / core:.1f} times)")


def main():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for even in (True, False):
            difference, count = largest_difference(20_000, even, folder)
            print(f"{'Welch' if even else 'Lomb-Scargle'}: {count} powers differ from SciPy's by {difference:.1e} of the largest at most")
            if not difference < LARGEST_DIFFERENCE:
                sys.exit(f"more than {LARGEST_DIFFERENCE:g}")
        if len(sys.argv) > 2:
            print_times(int(float(sys.argv[2])), folder)


if __name__ == "__main__":
    main()
