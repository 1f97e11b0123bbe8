"""Records of every kind that there is a figure of, for the tests of the figures: imported by TEST.py SWIRL ROOT [--all]"""

import sys
from math import cos
from pathlib import Path

from driving import made_records, with_records

ALL = "--all" in sys.argv and not sys.argv.remove("--all")
ROOT = str(Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(Path(ROOT) / "notebooks-export"))

import figure_records
import impact_tables

HEXAGON = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
SHORT = "--transient 1000 --collisions 2000"
COMMANDS = {
    "orbit": f"simulate {CHAOTIC} --collisions 500",
    "wall": "simulate --sides disk --alpha 0.1 --beta 0.05 --mu 0.4 --restitution 0.3 --time 60 --sample 0.02",
    "verdict": f"classify {HEXAGON} {SHORT} --exhaustive",
    "settled": "classify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9",
    "chaos": f"classify {CHAOTIC}",
    "runs": f"classify {HEXAGON} {SHORT} --runs 4",
    "recurrence": f"recurrence {CHAOTIC} {SHORT} --image 60",
    "thresholds": f"recurrence {CHAOTIC} {SHORT} --threshold 0.1,0.2,0.3",
    "spectrum": f"spectrum {HEXAGON} {SHORT}",
    "lyapunov": f"lyapunov {CHAOTIC} {SHORT}",
    "ramp": "ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.374:0.384 --rate 1e-6 --down --windows 40 --branches",
    "describe": "describe --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9",
    "families": "describe --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1",
    "basins": f"sweep {CHAOTIC.replace('restitution 1', 'restitution 0.95')} --grid vx=-0.4:0.4:5 --grid spin=-1:1:4 --transient 100 "
              "--collisions 100",
    "tracks": "sweep --sides 6 --alpha 0.5 --mu 0.5 --restitution 0.95 --grid beta=0.48:0.54:4 --runs 3 --track",
    "three-axes": "sweep --mu 0.5 --beta 0.5 --grid alpha=0.2:0.6:3 --grid restitution=0.8:1:2 --grid sides=3:10:8 --transient 100 "
            "--collisions 100",
    "sweep": f"sweep --sides 6 --beta 0.5 --restitution 0.9 --alpha 0.4 --grid mu=0.1:0.9:3 --transient 100 --collisions 100",
}
#: Of seconds each: with --all alone.
SLOW = {"tour": "tour", "tradeoff": f"tradeoff {HEXAGON} --budget 2"}
KINDS_OF = {"points1": ["modes"], "points2": ["modes"], "points3": ["modes"], "tradeoff": ["tradeoff"], "wall": ["orbit", "spin", "path", "section", "balance", "energy", "contacts"], "verdict": ["verdict"], "measured": ["verdict"], "settled": ["verdict"], "chaos": ["verdict"],
            "runs": ["shares"],
            "recurrence": ["recurrence"], "thresholds": ["recurrence"], "spectrum": ["spectrum"], "lyapunov": ["lyapunov"],
            "basins": ["basins", "modes", "means", "map"], "tracks": ["attractors", "modes", "means"], "describe": ["steady-modes"], "families": ["steady-modes"], "three-axes": ["modes", "means", "map"], "sweep": ["modes", "means"], "tour": ["tour"],
            "fit": ["fit"], "film": ["arcs"], "diagram": ["bifurcation"], "ramp": ["ramp"], "cycles": ["multipliers"], "few-cycles": ["multipliers"], "ladders": ["tradeoff"], "curves": ["boundaries"], "cells": ["cells"], "sets": ["sets"]}


def measured_series():
    """A short stretch, a gap, and a longer one: the one that is judged."""
    waves = [0.3 * cos(0.7 * row) + 0.2 * cos(0.7 * 2 ** 0.5 * row) for row in range(700)]
    return "t,S\n" + "".join(f"{row / 10:.1f},{'' if row == 100 else f'{wave:.6f}'}\n" for row, wave in enumerate(waves))


def labels_of(figure):
    """Of the legends below the panels."""
    return [text.get_text() for part in figure.subfigs for legend in part.legends for text in legend.get_texts()]


class WithRecords(with_records({**COMMANDS, **(SLOW if ALL else {})})):
    @classmethod
    def add_records(cls, folder):
        measured = folder / "measured.csv"
        measured.write_text(measured_series())
        cls.records.update(made_records({"measured": f"classify --series {measured} --rows samples"}, folder))
        impacts = folder / "impacts.csv"
        impacts.write_text(impact_tables.table(impact_tables.impacts(60, noise=0.02)))
        cls.records.update(made_records({"fit": f"fit --impacts {impacts} --resamples 20"}, folder))
        for name in ("diagram", "cycles", "few-cycles", "curves", "cells", "sets", "ladders", "film"):
            cls.records[name] = folder / f"{name}.h5"
        for count in (1, 2, 3):
            cls.records[f"points{count}"] = folder / f"points{count}.h5"
            figure_records.write_sampled_sweep(cls.records[f"points{count}"], ["alpha", "beta", "mu"][:count], 150)
        figure_records.write_bifurcation(cls.records["diagram"])
        figure_records.write_orbits(cls.records["cycles"], 30, 100.0)
        figure_records.write_orbits(cls.records["few-cycles"], 4, 1.3)
        figure_records.write_tradeoff(cls.records["ladders"])
        figure_records.write_boundaries(cls.records["curves"])
        figure_records.write_cells(cls.records["cells"])
        figure_records.write_sets(cls.records["sets"])
        figure_records.write_film(cls.records["film"])
