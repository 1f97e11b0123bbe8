#!/usr/bin/env python3
"""Chaos that is called at a risk against the limits, on planes drawn at random: risk_planes.py SWIRL [options]

For each plane, in turn: the time of `swirl sweep` at the limits and at the risk (CPU seconds of the process), and how many of all runs
have another verdict (mode, kind or period). The first plane is that of the hexagon, alpha 0.1 to 0.9, beta 0.05 to 1.05.

With --check it fails where more than twice the risk of a plane's runs have another verdict, or, of all planes together, a share
of those called early that is above the risk.
"""

import argparse
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

import h5py
import numpy as np

CHAOTIC = 2  # its number among a record's modes
HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95", ("alpha", 0.1, 0.9), ("beta", 0.05, 1.05)


def plane(draw):
    """A scene, and two of its parameters with their ranges. What the plane does not vary is drawn, too."""
    ranges = {"alpha": (0.1, 0.9), "beta": (0.05, 1.05), "mu": (0.05, 1.0), "restitution": (0.6, 1.0)}
    axes = sorted(draw.sample(sorted(ranges), 2))
    fixed = {name: round(draw.uniform(*ranges[name]), 3) for name in ranges if name not in axes}
    scene = f"--sides {draw.choice(['3', '4', '5', '6', '8', '12', 'disk'])} --law {draw.choice(['poisson', 'newton', 'stronge'])} "
    return (scene + " ".join(f"--{name} {value}" for name, value in fixed.items()), *((name, *ranges[name]) for name in axes))


def swept(swirl, command, path):
    """CPU seconds, and the record's verdicts."""
    before = os.times()
    subprocess.run([swirl, *command.split(), "--quiet", "-o", path], check=True)
    after = os.times()
    seconds = after.children_user + after.children_system - before.children_user - before.children_system
    with h5py.File(path) as record:
        verdicts = np.stack([record["sweep"][f"run_{name}"][()].ravel().astype(np.int64) for name in ("mode", "kind", "period")])
        impacts = record["sweep"]["run_impacts"][()].ravel()
        evidence = record.get("risk_evidence")
        evidence = {name: evidence[name][0] for name in evidence} if evidence else None
    return seconds, verdicts, evidence, impacts


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("swirl")
    parser.add_argument("--planes", type=int, default=20)
    parser.add_argument("--points", type=int, default=41, help="along each axis")
    parser.add_argument("--runs", type=int, default=8)
    parser.add_argument("--risk", type=float, default=0.01)
    parser.add_argument("--seed", type=int, default=1, help="of the planes")
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    draw = random.Random(options.seed)
    planes = [HEXAGON] + [plane(draw) for _ in range(options.planes - 1)]
    broken, all_called, all_wrong = [], 0, 0
    print("other verdicts / runs      share   called  impacts  sample   changed  bound     seconds        ratio  plane")
    for scene, *axes in planes:
        grid = " ".join(f"--grid {name}={low}:{high}:{options.points}" for name, low, high in axes)
        command = f"sweep {scene} {grid} --runs {options.runs} --threads {options.threads}"
        with tempfile.TemporaryDirectory() as folder:
            limits, expected, _, at_limits = swept(options.swirl, command, Path(folder) / "limits.h5")
            risk, found, evidence, impacts = swept(options.swirl, f"{command} --risk {options.risk}", Path(folder) / "risk.h5")
        other = int(np.any(found != expected, axis=0).sum())
        called = (found[0] == CHAOTIC) & (impacts < at_limits) & (evidence["impacts"] > 0)
        wrong = int(np.any(found != expected, axis=0)[called].sum())
        chaotic = int(called.sum())
        all_called, all_wrong = all_called + chaotic, all_wrong + wrong
        if other > 2 * options.risk * found.shape[1]:
            broken.append(scene)
        print(f"{other:6} / {found.shape[1]:<10} {other / found.shape[1]:10.5f} {chaotic:8} {evidence['impacts']:8} {evidence['judged']:7} "
              f"{evidence['changed']:9}  {evidence['bound']:.5f}  {limits:7.2f} {risk:7.2f}  {risk / limits:6.3f}  {scene} {grid}",
              flush=True)
    print(f"of {all_called} runs that were called early {all_wrong} have another verdict at the limits")
    if options.check and (broken or all_called == 0 or all_wrong > options.risk * all_called):
        sys.exit(f"the risk of {options.risk} is not kept: {broken}")


if __name__ == "__main__":
    sys.exit(main())
