"""swirl boundaries --all against special points that it did not begin at: boundary_curves_test.py SWIRL [--all]

On random lines of a plane every fixed point of `certify --all` is followed by `continue`; each fold, flip and
Neimark-Sacker point that it finds is to lie on a curve. --all: thirteen scenes, as a table."""

import functools
import json
import math
import random
import sys
import time
import unittest

import numpy

from driving import document, run

MANY = "--all" in sys.argv and bool(sys.argv.remove("--all") or True)

KINDS = "fold", "flip", "neimark-sacker"
PLANE = "--plane alpha={}:{} --plane beta={}:{}"


class Case:
    """A scene, its plane, and how many random lines of it are looked at."""

    def __init__(self, name, scene, alpha=(0.3, 0.7), beta=(0.3, 0.7), lines=20, more="", time_limit=12.0):
        self.name, self.scene, self.lines, self.more, self.time_limit = name, scene, lines, more, time_limit
        self.ranges = {"alpha": alpha, "beta": beta}
        self.low, self.high = numpy.array(list(self.ranges.values())).T

    @property
    def plane(self):
        return PLANE.format(*self.ranges["alpha"], *self.ranges["beta"])


SMALL = Case("hexagon, a part", "--sides 6 --mu 0.5 --restitution 0.95", (0.4, 0.5), (0.4, 0.5), 2, "--lines 2", 3.0)
CASES = [
    Case("hexagon", "--sides 6 --mu 0.5 --restitution 0.95"),
    Case("hexagon, Newton", "--sides 6 --mu 0.5 --restitution 0.95 --law newton"),
    Case("hexagon, Stronge", "--sides 6 --mu 0.5 --restitution 0.95 --law stronge"),
    Case("hexagon, mu 0.2", "--sides 6 --mu 0.2 --restitution 0.9"),
    Case("hexagon, elastic", "--sides 6 --mu 0.5 --restitution 1"),
    Case("triangle", "--sides 3 --mu 0.5 --restitution 0.95"),
    Case("triangle, Stronge", "--sides 3 --mu 0.8 --restitution 0.9 --law stronge"),
    Case("square", "--sides 4 --mu 0.5 --restitution 0.95"),
    Case("pentagon", "--sides 5 --mu 0.5 --restitution 0.95"),
    Case("pentagon, Newton", "--sides 5 --mu 0.3 --restitution 0.9 --law newton"),
    Case("octagon", "--sides 8 --mu 0.5 --restitution 0.95"),
    Case("12 sides", "--sides 12 --mu 0.5 --restitution 0.95"),
    Case("disk", "--sides disk --mu 0.5 --restitution 0.95"),
]


def coordinates(point):
    return numpy.array(list(point.values()))


def turned(angles):
    return (angles + math.pi) % (2 * math.pi) - math.pi


class SpecialPoint:
    def __init__(self, kind, p, z):
        self.kind, self.p, self.z = kind, p, z

    def distance_to(self, case, curve):
        """In the arclength along which curves are followed, from the chords between a curve's points."""
        z = numpy.array([coordinates(point["point"]) for point in curve["points"]])
        p = numpy.array([list(point["parameters"].values()) for point in curve["points"]])
        away = z - self.z
        away[:, :len(self.z) - 3] = turned(away[:, :len(self.z) - 3])
        y = numpy.hstack([away, (p - self.p) / (case.high - case.low)])
        step = numpy.diff(y, axis=0)
        step[:, :len(self.z) - 3] = turned(step[:, :len(self.z) - 3])
        share = numpy.clip(-(y[:-1] * step).sum(1) / numpy.maximum((step ** 2).sum(1), 1e-300), 0, 1)
        return numpy.linalg.norm(y[:-1] + share[:, None] * step, axis=1).min()


def special_points(case, draw):
    """Those of all fixed points on random lines, each once; in how many fixed points they are from."""
    found, fixed_points = [], 0
    for number in range(case.lines):
        axis = number % 2
        names = list(case.ranges)
        along, other = names[axis], names[1 - axis]
        fixed = draw.uniform(*case.ranges[other])
        for value in [draw.uniform(*case.ranges[along]) for _ in range(3)]:
            scene = f"{case.scene} --{along} {value!r} --{other} {fixed!r}"
            listed = json.loads(run(f"certify {scene} --all --max-time {case.time_limit} --json").stdout)
            for orbit in listed["orbits"]:  # exit code 3: the list is not proven to be whole, its orbits are
                fixed_points += 1
                start = ",".join(repr(x) for x in orbit["point"].values())
                answer = json.loads(run(f"continue {scene} --from={start} --switch 0 --json "
                                        f"--along {along}={case.ranges[along][0]}:{case.ranges[along][1]}").stdout)
                for branch in answer["branches"]:
                    for special in branch["special"]:
                        if special["kind"] in KINDS:
                            p = numpy.array([fixed, fixed])
                            p[axis] = special["parameter"]
                            z = coordinates(special["point"])
                            if not any(other.kind == special["kind"] and numpy.abs(other.p - p).max() < 1e-8
                                       and numpy.abs(numpy.hstack([turned(other.z[:-3] - z[:-3]), other.z[-3:] - z[-3:]])).max() < 1e-6
                                       for other in found):
                                found.append(SpecialPoint(special["kind"], p, z))
    return found, fixed_points


#: Of a chord to the curve: steps are 0.02 long at most and bend by 14 degrees, so that they lie tan(7 degrees)/4 of
#: them beside it.
CHORD = 0.02 * math.tan(math.radians(7)) / 4 + 1e-5


@functools.cache
def looked_at(case):
    """The curves, the seconds they took, the special points and those of them that lie on no curve."""
    begun = time.monotonic()
    answer = document(f"boundaries {case.scene} {case.plane} --all --max-period 1 --max-time {case.time_limit} {case.more}")
    seconds = time.monotonic() - begun
    points, fixed_points = special_points(case, random.Random(48))
    missing = [point for point in points
               if min((point.distance_to(case, curve) for curve in answer["curves"]
                       if curve["kind"] == point.kind and curve["period"] == 1), default=1) > CHORD]
    return answer, seconds, fixed_points, points, missing


class EveryCurve(unittest.TestCase):
    def test_special_points_of_all_fixed_points_on_random_lines_lie_on_curves(self):
        if MANY:
            print(f"\n{'scene':<20} {'curves':>6} {'of them attracting':>18} {'lines':>6} {'s':>6} {'fixed points':>12} {'special points':>14} {'on no curve':>11}")
        for case in CASES if MANY else [SMALL]:
            answer, seconds, fixed_points, points, missing = looked_at(case)
            lines = answer["lines"]
            if MANY:
                print(f"{case.name:<20} {len(answer['curves']):>6} {sum(c['bounds_attracting'] for c in answer['curves']):>18} "
                      f"{lines['even'] + lines['between']:>6} {seconds:>6.0f} {fixed_points:>12} {len(points):>14} {len(missing):>11}", flush=True)
                for point in missing:
                    print(f"    on no curve: {point.kind} at ({point.p[0]:.10f}, {point.p[1]:.10f}), {point.z}", flush=True)
            with self.subTest(case.name):
                self.assertEqual([(point.kind, *point.p) for point in missing], [])
                if "disk" not in case.name:
                    self.assertGreater(len(points), 3 if case is SMALL else 50)


if __name__ == "__main__":
    unittest.main()
