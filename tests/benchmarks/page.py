#!/usr/bin/env python3
"""The page docs/benchmarks.md: page.py SWIRL OLDER [options]

Runs of SWIRL against the same runs of OLDER, an earlier binary, in turn, so that what else the machine does meets both: of each
pair the ratio of processor times (of process and children, one thread), and of all pairs its median with the least and the largest; the
peak of memory of both. Then the unit in which an impact is measured elsewhere (--impact-benchmark, a dependent sincos of libm), SciPy's
spectra on the same rows, and the peers of tests/benchmarks/peers where they are built (--peers). What is not there is named and left out.
"""

import argparse
import datetime
import json
import os
import platform
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95"
PLANE = f"{HEXAGON} --grid alpha=0.1:0.9:{{points}} --grid beta=0.05:1.05:{{points}}"
#: What a run is, and its arguments; {points} of a map, {series} a file.
RUNS = {
    "start-up": ("`--version`", "--version"),
    "100 impacts": ("an orbit of a hexagon", f"simulate {HEXAGON} --alpha 0.3 --beta 0.5 --collisions 100 --json"),
    "verdict": ("chaos followed to its limits", f"classify {HEXAGON} --alpha 0.3 --beta 0.5 --json"),
    "map": ("{points} x {points} cells of 8 runs", f"sweep {PLANE} --runs 8 --json"),
    "diagram": ("400 columns", f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.1:0.9:400 --starts 2 --json"),
    "diagram with branches": ("400 columns",
                              f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.1:0.9:400 --starts 2 --branches --json"),
    "recurrence": ("Rössler, {rows} rows, m = 3, τ = 6",
                   "recurrence --series {series} --dimension 3 --delay 6 --threshold 1.2 --json"),
    "boundaries": ("a part of a plane, periods 1 to 3",
                   f"boundaries {HEXAGON} --plane alpha=0.3:0.6 --plane beta=0.3:0.6 --max-period 3 --json"),
}
#: Runs that OLDER may not know: of SWIRL alone.
NEW_RUNS = {
    "map at a risk of 0.05": ("the map above", f"sweep {PLANE} --runs 8 --risk 0.05 --json"),
    "recurrence by pairs": ("10^6 random pairs of the series above",
                            "recurrence --series {series} --dimension 3 --delay 6 --threshold 1.2 --sample-pairs 1000000 --json"),
}


def rossler(path, rows):
    """x of a = b = 0.2, c = 5.7, 0.2 apart, by the classical Runge-Kutta method in four steps each."""
    def slope(s):
        x, y, z = s
        return (-y - z, x + 0.2 * y, 0.2 + z * (x - 5.7))

    def step(s, h):
        a = slope(s)
        b = slope([u + h / 2 * v for u, v in zip(s, a)])
        c = slope([u + h / 2 * v for u, v in zip(s, b)])
        d = slope([u + h * v for u, v in zip(s, c)])
        return [u + h / 6 * (p + 2 * q + 2 * r + t) for u, p, q, r, t in zip(s, a, b, c, d)]
    state, lines = [1.0, 1.0, 1.0], ["x"]
    for i in range(rows + 500):
        for _ in range(4):
            state = step(state, 0.05)
        if i >= 500:
            lines.append(repr(state[0]))
    path.write_text("\n".join(lines) + "\n")


def measured(command, folder):
    """Processor time in seconds, and the peak of memory in MiB. Exit codes other than 0 end the script."""
    with open(os.devnull, "w") as nothing:
        process = subprocess.Popen(command, stdout=nothing, stderr=subprocess.PIPE, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        error = process.stderr.read().decode()
        process.returncode = os.waitstatus_to_exitcode(status)
        process.stderr.close()
    if process.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {process.returncode}\n{error}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def compared(new, old, arguments, pairs, repeats, folder):
    """Pairs in turn, the first of which is the older's and the newer's by turns; a repeat is a run of a pair that is short."""
    def of(binary):
        found = [measured([binary, *arguments], folder) for _ in range(repeats)]
        return sum(seconds for seconds, _ in found) / repeats, max(peak for _, peak in found)
    both = []
    for i in range(pairs):
        first = of(old if i % 2 == 0 else new)
        second = of(new if i % 2 == 0 else old)
        both.append((second, first) if i % 2 == 0 else (first, second))
    return both


def seconds_in_words(seconds):
    return f"{1000 * seconds:.3g} ms" if seconds < 0.1 else f"{seconds:.3g} s"


def row_of(name, what, both):
    new, old = ([pair[k][0] for pair in both] for k in (0, 1))
    ratios = [a / b for a, b in zip(new, old)]
    peak, peak_old = (max(pair[k][1] for pair in both) for k in (0, 1))
    memory = peak / peak_old
    return (f"| {name} | {what} | {seconds_in_words(statistics.median(new))} | {seconds_in_words(statistics.median(old))} | "
            f"{statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f}) | {peak:.0f} | {peak_old:.0f} | "
            f"{memory:.2f}{' above a tenth more' if memory > 1.1 else ''} |"), memory


def processor():
    for line in Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("model name"):
            return line.split(":", 1)[1].strip()
    return platform.machine()


def instructions():
    flags = next((line for line in Path("/proc/cpuinfo").read_text().splitlines() if line.startswith("flags")), "").split()
    return "AVX-512" if "avx512f" in flags else "AVX2" if "avx2" in flags else "SSE4"


def unit(benchmark):
    """A dependent sincos in nanoseconds, and impacts in it, by impact_benchmark."""
    if not benchmark:
        return "Not measured: `impact_benchmark` was not given (`--impact-benchmark`).\n"
    text = subprocess.run([benchmark, "--benchmark_format=json", "--benchmark_min_time=0.2"], capture_output=True, text=True,
                          check=True).stdout
    rows = [row for row in json.loads(text)["benchmarks"] if "sincos" in row]
    lines = [f"A dependent `sincos` of libm takes {rows[0]['sincos_ns']:.3g} ns.\n" if "sincos_ns" in rows[0] else "",
             "| benchmark | `sincos` an impact |", "| --- | --- |"]
    return "\n".join(lines + [f"| `{row['name']}` | {row['sincos']:.3g} |" for row in rows]) + "\n"


def peers(program, swirl):
    parts = []
    spectra = subprocess.run([sys.executable, "-B", HERE / "peers/spectra_of_scipy.py", swirl, "100000"], capture_output=True,
                             text=True)
    if spectra.returncode == 77:
        parts.append("SciPy: not there (python3-scipy), left out.\n")
    elif spectra.returncode != 0:
        sys.exit(spectra.stdout + spectra.stderr)
    else:
        parts.append("Spectra of SciPy on the same rows (`tests/benchmarks/peers/spectra_of_scipy.py SWIRL 100000`):\n\n```text\n"
                     + spectra.stdout.strip() + "\n```\n")
    if program:
        table = subprocess.run([sys.executable, "-B", HERE / "peers/compare.py", program], capture_output=True, text=True,
                               check=True).stdout
        parts.append("Misses, then times, on the same flights (`tests/benchmarks/peers/compare.py`):\n\n```text\n" + table.strip()
                     + "\n```\n")
    else:
        parts.append("SUNDIALS, Box2D, Siconos and SciPy's integrators on the same flights: left out, the peers were not built "
                     "(`-DSWIRL_PEERS=ON`, `--peers`); [earlier figures](../tests/benchmarks/peers/README.md#measured).\n")
    parts.append("heyoka: left out, it is in no Debian release.\n")
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("swirl")
    parser.add_argument("older")
    parser.add_argument("--called", default="an earlier build", help="what the older binary is, in words")
    parser.add_argument("--pairs", type=int, default=9)
    parser.add_argument("--points", type=int, default=41, help="of the map along each axis")
    parser.add_argument("--rows", type=int, default=100_247, help="of the series")
    parser.add_argument("--only", nargs="*", help="names of runs; unit, peers")
    parser.add_argument("--impact-benchmark")
    parser.add_argument("--peers", help="the program of tests/benchmarks/peers")
    parser.add_argument("-o", "--output", default="docs/benchmarks.md")
    options = parser.parse_args()
    swirl, older = (str(Path(shutil.which(name) or name).resolve()) for name in (options.swirl, options.older))
    begin, load = datetime.datetime.now(datetime.timezone.utc), os.getloadavg()[0]
    rows, alone, above = [], [], []
    with tempfile.TemporaryDirectory() as folder:
        series = Path(folder) / "rossler.csv"
        words = {"points": options.points, "rows": f"{options.rows:,}", "series": str(series)}
        chosen = {**RUNS, **NEW_RUNS}
        chosen = {name: run for name, run in chosen.items() if not options.only or name in options.only}
        if any("{series}" in arguments for _, arguments in chosen.values()):
            rossler(series, options.rows)
        for name, (what, arguments) in chosen.items():
            command = arguments.format(**words).split() + ([] if name == "start-up" else ["--threads", "1"])
            print(name, flush=True)
            if name in RUNS:
                short = 10 if name in ("start-up", "100 impacts") else 1
                row, memory = row_of(name, what.format(**words), compared(swirl, older, command, options.pairs, short, folder))
                rows.append(row)
                if memory > 1.1:
                    above.append(name)
            else:
                found = [measured([swirl, *command], folder) for _ in range(options.pairs)]
                alone.append(f"| {name} | {what.format(**words)} | {seconds_in_words(statistics.median(s for s, _ in found))} | "
                             f"{seconds_in_words(min(s for s, _ in found))} to {seconds_in_words(max(s for s, _ in found))} | "
                             f"{max(m for _, m in found):.0f} |")
    version = subprocess.run([swirl, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    text = f"""# Benchmarks

Made by `tests/benchmarks/page.py`, {begin:%d %B %Y, %H:%M} UTC, on {os.cpu_count()} cores of {processor()} ({instructions()}), load
{load:.1f} as it began and {os.getloadavg()[0]:.1f} as it ended; {version} against {options.called}. What is measured with other work beside it
has the spread that is shown: processor times of {options.pairs} pairs in turn, one thread, medians (the least to the largest ratio of a
pair). Peak: resident memory in MiB.

| run | | time | before | ratio | peak | before | ratio |
| --- | --- | --- | --- | --- | --- | --- | --- |
""" + "\n".join(rows) + "\n\n"
    text += f"Memory above the earlier build's by more than a tenth: {', '.join(above) if above else 'none of these'}.\n"
    if alone:
        text += ("\nWhat the earlier build does not have:\n\n| run | | time | from, to | peak |\n| --- | --- | --- | --- | --- |\n"
                 + "\n".join(alone) + "\n")
    if not options.only or "unit" in options.only:
        text += "\n## The unit\n\n" + unit(options.impact_benchmark)
    if not options.only or "peers" in options.only:
        text += "\n## Peers\n\n" + peers(options.peers, swirl)
    Path(options.output).write_text(text)
    print(text)


if __name__ == "__main__":
    sys.exit(main())
