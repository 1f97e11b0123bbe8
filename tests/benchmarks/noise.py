#!/usr/bin/env python3
"""What noise at impacts leaves of attracting cycles and of a map of modes: noise.py SWIRL [--runs R] [--cells N] [--impacts K]

Escape: orbits that start on a cycle, followed with noise until they have gone over to the attractor beside it (mean S of 32 impacts
nearer to the other's); the mean number of impacts to that, with its interval at 95 % where all have left (of R exponential times
2 sum / chi^2), else the bound that the impacts without an escape give.

Cells: the period of an orbit's last half, with noise and without, over a plane of two parameters: the smallest k up to 16 after which
the median distance of a point of the section from that k impacts before is 0.05 at most; none of what has no such k. Alike are cells
with the same.
"""

import argparse
import math
import os
import subprocess
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import h5py
import numpy as np

SCENE = "--sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --beta 0.379"
KINDS = ("restitution", "mu", "wall")


def orbit(swirl, command, names):
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "orbit.h5"
        done = subprocess.run([swirl, "simulate", *command.split(), "--quiet", "-o", path], capture_output=True, text=True)
        assert done.returncode in (0, 3), (command, done.stderr)
        with h5py.File(path) as record:
            group = record["collisions"]
            return np.column_stack([group[name][()] for name in names if name in group])


def noise(kind, sigma):
    return f"--noise-{kind} {sigma}" if sigma else ""


def start_on(swirl, mode):
    """A point of the mode's cycle: the last impact of an orbit that settled there."""
    for seed in range(1, 40):
        z = orbit(swirl, f"{SCENE} --seed {seed} --collisions 4000 --skip 3990", ("psi", "chi", "vn", "vt", "spin"))
        if (abs(z[-1] - z[-2]).max() < 1e-6) == (mode == 1):
            return z[-1], z[-2:, -1].mean()
    raise SystemExit("no such mode")


def escape(swirl, start, own, other, kind, sigma, seed, impacts):
    """Impacts to the escape; None: none in so many."""
    point = ",".join(repr(float(x)) for x in start)
    spin = orbit(swirl, f"{SCENE} --point={point} --seed {seed} --collisions {impacts} {noise(kind, sigma)}", ("spin",))[:, 0]
    mean = np.convolve(spin, np.ones(32) / 32, "valid")
    gone = np.flatnonzero(abs(mean - other) < abs(mean - own))
    return int(gone[0]) + 32 if len(gone) else None


def chi_squared_quantile(p, pairs):
    """Of 2 pairs degrees of freedom: x is exceeded with the chance that a Poisson variable of mean x/2 is below pairs."""
    low, high = 0.0, 10.0 * pairs + 100
    for _ in range(80):
        x = (low + high) / 2
        log_terms = [i * math.log(x / 2) - x / 2 - math.lgamma(i + 1) for i in range(pairs)]
        low, high = (x, high) if 1 - math.fsum(map(math.exp, log_terms)) < p else (low, x)
    return (low + high) / 2


def escapes(swirl, pool, runs, impacts):
    starts = {mode: start_on(swirl, mode) for mode in (1, 2)}
    print(f"escape, of {runs} runs of at most {impacts} impacts\n")
    print("| noise | σ | of the steady mode | of the cycle of two |\n| --- | --- | --- | --- |")
    for kind, sigmas in (("restitution", (0.001, 0.002, 0.003, 0.005, 0.01, 0.02)), ("mu", (0.005, 0.01, 0.02, 0.05, 0.1)),
                         ("wall", (0.0005, 0.001, 0.002, 0.003, 0.005, 0.01))):
        for sigma in sigmas:
            row = []
            for mode in (1, 2):
                (start, own), (_, other) = starts[mode], starts[3 - mode]
                times = list(pool.map(lambda seed: escape(swirl, start, own, other, kind, sigma, seed, impacts), range(1, runs + 1)))
                left = [time for time in times if time is not None]
                total = sum(left) + impacts * (len(times) - len(left))
                if not left:
                    row.append(f"none: > {2 * total / chi_squared_quantile(0.95, 1):.2g}")
                    continue
                low, high = (2 * total / chi_squared_quantile(p, len(left)) for p in (0.975, 0.025))
                row.append(f"{total / len(left):.3g} ({low:.2g} to {high:.2g}), {len(left)} left")
            print(f"| {kind} | {sigma} | {row[0]} | {row[1]} |", flush=True)


def period(z):
    z = z[len(z) // 2:]
    for k in range(1, 17):
        away = abs(z[k:] - z[:-k])
        away[:, :2] = np.minimum(away[:, :2], 2 * np.pi - away[:, :2])
        if np.median(away.max(axis=1)) <= 0.05:
            return k
    return 0


def cells(swirl, pool, count):
    places = [(alpha, beta) for alpha in np.linspace(0.1, 0.9, count) for beta in np.linspace(0.05, 1.05, count)]

    def of(place, kind, sigma):
        z = orbit(swirl, f"--sides 6 --mu 0.5 --restitution 0.95 --alpha {place[0]:.4f} --beta {place[1]:.4f} --collisions 4000 "
                  f"{noise(kind, sigma)}", ("psi", "chi", "vn", "vt", "spin"))
        return period(z) if len(z) == 4000 else -1

    plain = list(pool.map(lambda place: of(place, "mu", 0), places))
    print(f"\n{len(places)} cells without noise: {sum(k == 1 for k in plain)} of period 1, {sum(k > 1 for k in plain)} of others to 16, "
          f"{sum(k == 0 for k in plain)} of none, {sum(k < 0 for k in plain)} orbits ended\n")
    print("| noise | σ | alike | of period 1 | of others | of none |\n| --- | --- | --- | --- | --- | --- |")
    for kind in KINDS:
        for sigma in (1e-12, 1e-4, 1e-3, 1e-2, 1e-1):
            noisy = list(pool.map(lambda place: of(place, kind, sigma), places))
            alike = np.array([a == b for a, b in zip(plain, noisy)])
            shares = [f"{alike[np.array(which)].sum()} of {sum(which)}" for which in
                      ([k == 1 for k in plain], [k > 1 for k in plain], [k == 0 for k in plain])]
            print(f"| {kind} | {sigma:g} | {100 * alike.mean():.1f} % | {' | '.join(shares)} |", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("swirl")
    parser.add_argument("--runs", type=int, default=16)
    parser.add_argument("--impacts", type=int, default=50_000)
    parser.add_argument("--cells", type=int, default=12, help="along each axis of the plane")
    options = parser.parse_args()
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        escapes(options.swirl, pool, options.runs, options.impacts)
        cells(options.swirl, pool, options.cells)


if __name__ == "__main__":
    main()
