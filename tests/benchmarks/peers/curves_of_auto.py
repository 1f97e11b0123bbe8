"""Branches of cycles by `swirl continue` beside AUTO-07p's on the same map: curves_of_auto.py SWIRL CURVES_OF_AUTO

CURVES_OF_AUTO is AUTO with the map linked in (auto_map.cpp, auto_equation.f90). From cycles that `swirl orbits` finds both follow the
branch over one parameter. Each fold, flip and Neimark-Sacker point of AUTO's must be one of Swirl's, the parameter equal within
TOLERANCE, S within the root of it, or be refuted: `swirl certify` proves a cycle there whose multipliers are all away from where they
would have to be. Points of Swirl's that AUTO does not report are counted, and must be few; so are ways that AUTO did not end. Exit code
1 if a point of AUTO's is neither, if fewer than 20 branches or 20 points were compared, or if more than a tenth were passed over."""

import json
import math
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

#: AUTO's EPSS, 1e-9 of a step, times what a branch that turns back can make of it.
TOLERANCE = 1e-7
#: AUTO takes some 0.02 s of a branch; where it walks along a border of the map it does not end.
LIMIT = 5
KINDS = {2: "fold", 5: "fold", 7: "flip", 8: "neimark-sacker"}  # AUTO's numbers of types
NUMBERS = ("alpha", "beta", "mu", "restitution")
HEXAGON = {"sides": 6, "alpha": 0.4, "beta": 0.5, "mu": 0.5, "restitution": 0.9}
CASES = (  # scene, period, parameter, from, to
    (HEXAGON, 1, "alpha", 0.25, 0.6),
    (HEXAGON, 1, "beta", 0.2, 0.9),
    (HEXAGON, 1, "mu", 0.2, 0.9),
    ({**HEXAGON, "alpha": 0.38, "restitution": 0.95}, 2, "alpha", 0.34, 0.42),
    ({**HEXAGON, "alpha": 0.38, "restitution": 0.95}, 3, "alpha", 0.36, 0.4),
    ({"sides": 3, "alpha": 0.5, "beta": 0.6, "mu": 0.3, "restitution": 0.9}, 1, "alpha", 0.4, 0.6),
    ({"sides": 4, "alpha": 0.45, "beta": 0.4, "mu": 0.4, "restitution": 0.95}, 1, "restitution", 0.7, 0.99),
    ({"sides": 5, "alpha": 0.45, "beta": 0.5, "mu": 0.4, "restitution": 0.9}, 1, "alpha", 0.3, 0.6),
    ({"sides": 8, "alpha": 0.4, "beta": 0.5, "mu": 0.4, "restitution": 0.9}, 1, "alpha", 0.3, 0.6),
)
CONSTANTS = """NDIM={ndim}
IPS=-1
IRS=0
ILP=1
ICP=[{index}]
NTST=10
NCOL=4
IAD=3
ISP=1
ISW=1
IPLT=0
NBC=0
NINT=0
NMX=3000
NPR=0
MXBF=0
IID=2
ITMX=20
ITNW=7
NWTN=3
JAC=-1
EPSL=1e-10
EPSU=1e-10
EPSS=1e-9
DS={step}
DSMIN=1e-9
DSMAX=0.01
IADS=1
NPAR=6
THL={{}}
THU={{}}
UZR={{}}
RL0={low}
RL1={high}
"""


def swirl(program, command, scene, *flags):
    """The document of a command, also of one that found nothing (exit code 3)."""
    words = [program, command, "--json", "--quiet", *flags]
    for name, value in scene.items():
        words += [f"--{name}", str(value)]
    result = subprocess.run(words, capture_output=True, text=True)
    if result.returncode not in (0, 3):
        raise SystemExit(f"{' '.join(words)}: exit code {result.returncode}: {result.stderr}")
    return json.loads(result.stdout)


def text_of(state):
    return ",".join(map(repr, state))


def state_of(point):
    return [point[name] for name in ("psi", "chi", "vn", "vt", "S") if point.get(name) is not None]


def inertia_factor(sides):
    return 0.5 if sides == "disk" else (2 + math.cos(2 * math.pi / sides)) / 6


def labelled_points(file, dimension):
    """(type, parameter, state) of the labelled points in AUTO's output of branches."""
    points = []
    for line in file.read_text().splitlines():
        cells = re.sub(r"(\d)([+-]\d{3})\b", r"\1E\2", line).split()  # Fortran leaves out the E of long exponents
        if cells and cells[0] != "0" and int(cells[2]) != 0:
            points.append((abs(int(cells[2])) % 10, float(cells[4]), [float(cell) for cell in cells[6:6 + dimension]]))
    return points


def by_auto(program, scene, period, along, start):
    """(kind, parameter, state) of special points from a cycle on, both ways, and how many of these ways did not end in time."""
    name, low, high = along
    found, unfinished = [], 0
    for step in (1e-3, -1e-3):
        with tempfile.TemporaryDirectory() as folder:
            folder = Path(folder)
            numbers = [scene[key] for key in NUMBERS]
            numbers += [0 if scene["sides"] == "disk" else scene["sides"], inertia_factor(scene["sides"])]
            (folder / "start.txt").write_text(f"{period}\n{' '.join(map(repr, start))}\n{' '.join(map(repr, numbers))}\n")
            (folder / "fort.2").write_text(CONSTANTS.format(ndim=len(start), index=NUMBERS.index(name) + 1, step=step, low=low,
                                                            high=high))
            try:
                subprocess.run([program], cwd=folder, capture_output=True, timeout=LIMIT, check=True)
            except subprocess.TimeoutExpired:
                unfinished += 1
            found += [(KINDS[kind], value, state) for kind, value, state in labelled_points(folder / "fort.7", len(start))
                      if kind in KINDS and low <= value <= high]
    return found, unfinished


def same(one, other):
    return one[0] == other[0] and abs(one[1] - other[1]) < TOLERANCE and abs(one[2][-1] - other[2][-1]) < math.sqrt(TOLERANCE)


def proven_cycle(program, scene, period, state):
    """The cycle proven at a state; where Newton's method finds none from the digits that AUTO prints, the nearest of all."""
    near = swirl(program, "certify", scene, f"--near={text_of(state)}", "--period", str(period))["orbits"]
    if near and near[0]["proven"]:
        return near[0]
    if period != 1:
        return None
    fixed_points = [orbit for orbit in swirl(program, "certify", scene, "--all")["orbits"] if orbit["proven"]]
    distance = {id(orbit): max(abs(a - b) for a, b in zip(state_of(orbit["point"]), state)) for orbit in fixed_points}
    nearest = min(fixed_points, key=lambda orbit: distance[id(orbit)], default=None)
    return nearest if nearest and distance[id(nearest)] < TOLERANCE else None


def refuted(program, scene, period, name, point):
    """Is a cycle proven there, and all of its multipliers away from where the kind has one?"""
    kind, value, state = point
    orbit = proven_cycle(program, {**scene, name: value}, period, state)
    if orbit is None:
        return False
    wanted = {"fold": 1, "flip": -1}
    for real, imaginary, radius in orbit["multipliers"]:
        away = abs(complex(real, imaginary) - wanted[kind]) if kind in wanted else abs(abs(complex(real, imaginary)) - 1)
        if away <= radius:
            return False
    return True


def unlike(points):
    """The points, each once: two cycles may lie on one branch."""
    kept = []
    for point in points:
        if not any(same(point, other) for other in kept):
            kept.append(point)
    return kept


def main(swirl_program, auto_program):
    branches = both = unexplained = disproved = passed_over = unfinished_ways = 0
    seconds = {"swirl": 0.0, "auto": 0.0}
    for scene, period, *along in CASES:
        name, low, high = along
        orbits = swirl(swirl_program, "orbits", scene, "--period", str(period))["orbits"]
        own, its = [], []
        cycles = [orbit for orbit in orbits if orbit["period"] == period][:12]
        for orbit in cycles:
            start = state_of(orbit["points"][0])
            begin = time.perf_counter()
            document = swirl(swirl_program, "continue", scene, f"--from={text_of(start)}", "--period", str(period), "--along",
                             f"{name}={low}:{high}", "--switch", "0")
            seconds["swirl"] += time.perf_counter() - begin
            own += [(s["kind"], s["parameter"], state_of(s["point"])) for branch in document["branches"]
                    for s in branch["special"] if s["kind"] in KINDS.values()]
            begin = time.perf_counter()
            found, unfinished = by_auto(auto_program, scene, period, along, start)
            seconds["auto"] += time.perf_counter() - begin
            its += found
            unfinished_ways += unfinished
        own, its = unlike(own), unlike(its)
        shared = [point for point in its if any(same(point, other) for other in own)]
        others = [point for point in its if point not in shared]
        wrong = [point for point in others if refuted(swirl_program, scene, period, name, point)]
        left = [point for point in own if not any(same(point, other) for other in its)]
        print(f"{scene['sides']} sides, period {period}, {name} {low} to {high}: {len(cycles)} branches, {len(shared)} points of both, "
              f"{len(wrong)} of AUTO's refuted by proof, {len(others) - len(wrong)} of AUTO's not explained, {len(left)} that AUTO "
              f"passes over")
        for title, points in (("refuted", wrong), ("not explained", [p for p in others if p not in wrong]), ("passed over", left)):
            for kind, value, state in points:
                print(f"  {title}: {kind} at {name} = {value:.10g}, S {state[-1]:.6g}")
        branches += len(cycles)
        both += len(shared)
        disproved += len(wrong)
        unexplained += len(others) - len(wrong)
        passed_over += len(left)
    print(f"{branches} branches: {both} points of both, {disproved} of AUTO's refuted, {unexplained} not explained, {passed_over} passed over "
          f"by AUTO; {unfinished_ways} of its {2 * branches} ways not ended in {LIMIT} s; seconds: Swirl {seconds['swirl']:.1f} (as "
          f"processes), AUTO {seconds['auto']:.1f}")
    return 0 if unexplained == 0 and branches >= 20 and both >= 20 and passed_over * 10 <= both else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
