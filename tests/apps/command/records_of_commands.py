"""Records by the built swirl, of every command that writes one and of all that it may hold."""

import math
from pathlib import Path

from driving import run
from impact_tables import impacts, table

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SHORT = "--transient 1000 --collisions 1000"
HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95"
BRIEF = "--transient 100 --collisions 100"
#: By name: the command that writes the record, and the kind of its notebook. `.h5` are records of those above.
RECORDS = {
    "orbit": (f"simulate {STEADY} --collisions 1000", "orbit"),
    "in-metres": ("simulate --sides 6 --container-radius 2 --swirl-rate 4 --polygon-radius 0.8 --swirl-radius 1 --mu 0.5 "
                  "--restitution 0.9 --collisions 30", "orbit"),
    "landing": ("simulate --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9 --time 40 --sample 0.1", "orbit"),
    "verdict": (f"classify {STEADY} {SHORT}", "verdict"),
    "in-contact": ("classify --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9", "verdict"),
    "runs": (f"classify {STEADY} {SHORT} --runs 3", "shares"),
    "recurrence": (f"recurrence {STEADY} {SHORT} --image 40", "recurrence"),
    "of-a-record": ("recurrence landing.h5", "recurrence"),
    "random-pairs": (f"recurrence {STEADY} {SHORT} --sample-pairs 5000", "recurrence"),
    "spectrum": (f"spectrum {HEXAGON} --alpha 0.635 --beta 0.5 {SHORT}", "spectrum"),
    "no-spectrum": (f"spectrum {STEADY} {SHORT}", "spectrum"),
    "positions": (f"spectrum {HEXAGON} --alpha 0.635 --beta 0.5 {SHORT} --observable x", "spectrum"),
    "measured": ("spectrum --series measured.csv --column S", "spectrum"),
    "camera": ("classify --series measured.csv --angle angle --swirl-rate 2", "verdict"),
    "cross": ("recurrence --series measured.csv --column S --cross-column angle", "recurrence"),
    "lyapunov": (f"lyapunov {STEADY} {SHORT}", "lyapunov"),
    "fit": ("fit --impacts impacts.csv --resamples 20", "fit"),
    "orbits": (f"orbits {STEADY} --period 1", "multipliers"),
    "branch": (f"continue {STEADY} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.38:0.46", "bifurcation"),
    "attracting": (f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.35:0.45:11", "bifurcation"),
    "coordinate": (f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.38:0.42:3 --observable psi --branches", "bifurcation"),
    "diagram": (f"bifurcate {HEXAGON} --beta 0.5 --along alpha=0.35:0.45:11 --branches", "bifurcation"),
    "ramp": (f"ramp {STEADY} --along beta=0.5:0.55 --duration 500 --windows 5", "ramp"),
    "loop": (f"ramp {STEADY} --along mu=0.5:0.45 --duration 300 --windows 5 --cycles 2 --branches", "ramp"),
    "curves": (f"boundaries {HEXAGON} --plane alpha=0.4:0.6 --plane beta=0.25:0.5 --max-period 1 --lines 2", "boundaries"),
    "cells": (f"certify {HEXAGON} --plane alpha=0.3:0.31 --plane beta=0.5:0.51 --max-time 2 --resolution 0.25", "cells"),
    "sets": ("certify --sides disk --alpha 0.3 --beta 0.5 --mu 0 --restitution 1 --near=3.1415927,-0.144,0.048,0 --chaos --link-length 4", "sets"),
    "line": (f"sweep {STEADY.replace('--alpha 0.4 ', '')} --grid alpha=0.3:0.5:3 --runs 2 {BRIEF}", "modes"),
    "map": (f"sweep {HEXAGON} --grid alpha=0.2:0.6:3 --grid beta=0.1:0.9:2 {BRIEF}", "modes"),
    "refined": (f"sweep {HEXAGON} --grid alpha=0.2:0.6:3 --grid beta=0.1:0.9:3 --refine 1 {BRIEF}", "modes"),
    "laws": (f"sweep {STEADY} --grid law=poisson,newton --runs 2 {BRIEF}", "modes"),
    "sample": (f"sweep {HEXAGON} --grid alpha=0.2:0.6 --grid beta=0.1:0.9 --sample sobol:12 {BRIEF}", "samples"),
    "table": (f"sweep --beta 0.5 --restitution 0.9 --scenes scenes.csv --runs 2 {BRIEF}", "scenes"),
    "logarithms": (f"sweep {STEADY.replace('--mu 0.5 ', '')} --grid mu=0.01:1:3:log {BRIEF}", "modes"),
    "basins": (f"sweep {HEXAGON} --alpha 0.5 --beta 0.5 --grid vx=-1:1:9 --grid vy=-1:1:9", "basins"),
    "saddles": (f"sweep {HEXAGON} --alpha 0.5 --beta 0.5 --grid vx=-1:1:9 --grid vy=-1:1:9 --saddles 2", "basins"),
    "tracks": (f"sweep {HEXAGON} --alpha 0.5 --grid beta=0.5:0.54:3 --runs 8 --track", "attractors"),
    "part-1": (f"sweep {HEXAGON} --beta 0.5 --grid alpha=0.2:0.6:3 {BRIEF} --shard 1/2", "shard"),
    "part-2": (f"sweep {HEXAGON} --beta 0.5 --grid alpha=0.2:0.6:3 {BRIEF} --shard 2/2", "shard"),
    "joined": ("join part-1.h5 part-2.h5", "modes"),
    "tradeoff": (f"tradeoff {STEADY} --budget 1", "tradeoff"),
    "describe": (f"describe {STEADY}", "steady-modes"),
    "families": ("describe --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1", "steady-modes"),
    "no-steady-mode": ("describe --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9", "steady-modes"),
    "tour": ("tour", "tour"),
}


def measured():
    """A text file of a series: times, a column S and an angle."""
    rows = ((0.1 * i, math.sin(0.5 * i) + 0.3 * math.sin(1.7 * i), (0.2 * i + 0.05 * math.sin(0.9 * i)) % 6.283) for i in range(200))
    return "t S angle\n" + "".join(f"{time:.1f} {spin:.6f} {angle:.6f}\n" for time, spin, angle in rows)


def records_in(folder):
    """(path, kind) of each, written into the folder one by one."""
    folder = Path(folder)
    (folder / "measured.csv").write_text(measured())
    (folder / "scenes.csv").write_text("sides,alpha,mu,law,speed\n6,0.4,0.5,poisson,0.1\ndisk,0.3,0.1,newton,0.2\n3,0.4,0.5,stronge,0.1\n")
    (folder / "impacts.csv").write_text(table(impacts(40, noise=0.02)))
    for name, (command, kind) in RECORDS.items():
        result = run(f"{command} --quiet -o {name}.h5", cwd=folder)
        assert result.returncode == 0, (command, result.stderr)
        yield folder / f"{name}.h5", kind
