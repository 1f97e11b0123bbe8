"""swirl boundaries, from outside: boundaries_command_test.py SWIRL [PLACES]"""

import functools
import json
import math
import sys
import unittest

import numpy

from boundary_planes import BORDERS, HEXAGON, SMALL, Searched, document, place
from driving import Keeping, Refusing, run

#: On each curve, compared with `continue` across it: a second argument, of the nightly test.
PLACES = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 5


@functools.cache
def curves_around_a_grazing_curve():
    """Of periods 1 and 2, with a multiplier 1 and -1 and pairs on the circle; and the plane's width."""
    plane = {"alpha": (0.35, 0.65), "beta": (0.06, 0.21)}
    answer = document(f"boundaries {HEXAGON} --max-period 2 --lines 1 --longest-step 0.005 "
                      + " ".join(f"--plane {name}={low}:{high}" for name, (low, high) in plane.items()))
    return answer, numpy.array([high - low for low, high in plane.values()])


class Boundaries(Searched):
    def test_curves_carry_the_multiplier_that_they_are_of(self):
        answer = self.answer
        kinds = {curve["kind"] for curve in answer["curves"]}
        self.assertLessEqual({"fold", "flip", "neimark-sacker"}, kinds)
        for curve in answer["curves"]:
            self.assertEqual(len(curve["ends"]), 2)
            for point in curve["points"]:
                alpha, beta = place(point)
                rounding = 1e-12  # the last point lies on the edge as Newton's method leaves it
                self.assertTrue(-rounding <= alpha - 0.4 <= 0.2 + rounding, (alpha, beta))
                self.assertTrue(-rounding <= beta - 0.25 <= 0.25 + rounding, (alpha, beta))
                critical = {"fold": lambda m: abs(m - 1), "flip": lambda m: abs(m + 1),
                            "neimark-sacker": lambda m: abs(abs(m) - 1)}.get(curve["kind"])
                if critical:  # a multiplier that is double moves as the root of rounding
                    self.assertLess(min(critical(complex(*m)) for m in point["multipliers"]), 1e-6)

    def test_a_curve_that_leaves_the_plane_ends_on_its_edge(self):
        for curve in self.answer["curves"]:
            for point, why in zip((curve["points"][0], curve["points"][-1]), curve["ends"]):
                if why == "plane":
                    alpha, beta = place(point)
                    self.assertLess(min(abs(alpha - 0.4), abs(alpha - 0.6), abs(beta - 0.25), abs(beta - 0.5)), 1e-12)

    def test_continue_across_a_curve_has_its_special_point_there(self):
        for curve in self.answer["curves"]:
            if curve["kind"] not in ("fold", "flip", "neimark-sacker"):
                continue
            points = curve["points"]
            for place_number in range(PLACES):  # spread evenly, without the ends
                i = (place_number + 1) * len(points) // (PLACES + 1)
                if 0 < i < len(points) - 1:
                    self.check_across(curve["kind"], points[i - 1], points[i], points[i + 1])

    def check_across(self, kind, before, point, after):
        """Along the parameter that crosses the curve more steeply, from a little off it, where the cycle is not singular;
        behind a fold there is none."""
        along = [b - a for a, b in zip(place(before), place(after))]
        axis = 0 if abs(along[0]) < abs(along[1]) else 1
        name, value = ("alpha", "beta")[axis], place(point)[axis]
        other, fixed = ("alpha", "beta")[1 - axis], place(point)[1 - axis]
        start = ",".join(repr(x) for x in point["point"].values())
        found = []
        for aside in (-1e-4, 1e-4):
            branches = document(f"continue {HEXAGON} --{name} {value + aside!r} --{other} {fixed!r} --switch 0 --from={start} "
                                f"--along {name}={value - 0.01!r}:{value + 0.01!r}", code=(0, 3))["branches"]
            found += [special["parameter"] for branch in branches for special in branch["special"]
                      if special["kind"] == kind]
            if found:
                break
        self.assertLess(min((abs(special - value) for special in found), default=1), 1e-9, (kind, place(point)))

    def test_no_curve_comes_twice(self):
        curves = self.answer["curves"]
        for i, curve in enumerate(curves):
            middle = place(curve["points"][len(curve["points"]) // 2])
            for other in curves[:i]:
                if (other["kind"], other["period"]) == (curve["kind"], curve["period"]):
                    # Points lie 0.02 of the plane's width apart at most.
                    nearest = min(math.dist(middle, place(point)) for point in other["points"])
                    spin = min(abs(curve["points"][len(curve["points"]) // 2]["point"]["S"] - point["point"]["S"])
                               for point in other["points"])
                    self.assertTrue(nearest > 1e-4 or spin > 1e-4, (i, curve["kind"], middle))

    def test_a_point_on_two_curves_is_found_on_both(self):
        # The ends on borders too: curves of the two kinds do not know each other.
        answer = document(f"boundaries {HEXAGON} --plane alpha=0.6:0.9 --plane beta=0.05:0.4 --max-period 1 --lines 5")
        resonances = [special for curve in answer["curves"] for special in curve["special"] if special["kind"] == "1:2"]
        self.assertEqual(len(resonances), 2)  # of the flip curve, and where the Neimark–Sacker curve ends
        for special in resonances:
            self.assertLess(math.dist(place(special), (0.788667565, 0.2554828)), 1e-8)
        touching = [special for curve in answer["curves"] if curve["kind"] == "grazing" for special in curve["special"]]
        ends = [(curve["kind"], curve["points"][i]) for curve in answer["curves"] for i, why in zip((0, -1), curve["ends"])
                if why == "grazing" and curve["kind"] in ("fold", "flip")]
        self.assertGreater(len(ends), 1)
        for kind, end in ends:  # the map ends at u_n = 1e-6, a little before the border
            self.assertLess(min(math.dist(place(end), place(special)) for special in touching
                                if special["kind"] == f"{kind}-grazing"), 1e-5)

    def test_curves_are_born_where_a_grazing_cycle_has_a_multiplier_one(self):
        """The fold curve of the cycle that misses and that of the one with the vanishing impact touch the grazing curve
        quadratically, as the square root in the map's derivative makes it; flip curves meet it at an angle."""
        answer, width = curves_around_a_grazing_curve()
        exponents = {}
        for grazing in answer["curves"]:
            if grazing["kind"] != "grazing" or grazing["period"] != 1:
                continue
            border = numpy.array([place(point) for point in grazing["points"]]) / width
            for special in grazing["special"]:
                kind = special["kind"].split("-")[0]
                for curve in answer["curves"]:
                    if curve["kind"] != kind:
                        continue
                    for way in (1, -1):
                        points = numpy.array([place(point) for point in curve["points"][::way]]) / width
                        if numpy.linalg.norm(points[0] - numpy.array(place(special)) / width) < 5e-4:
                            exponents[special["kind"]] = self.tangency(border, numpy.array(place(special)) / width, points)
        self.assertEqual(set(exponents), {"fold-grazing", "fold-vanishing-impact", "flip-grazing", "flip-vanishing-impact"})
        for kind, exponent in exponents.items():  # fitted between 0.005 and 0.05 away, where higher powers have a share
            self.assertLess(abs(exponent - (2 if kind.startswith("fold") else 1)), 0.06, (kind, exponent))

    def test_the_doubled_cycle_has_a_grazing_curve_that_touches_the_flip_curve(self):
        """Where a grazing cycle has a multiplier -1: one turn of the doubled cycle touches, the other stays inside."""
        answer, width = curves_around_a_grazing_curve()
        found = 0
        for grazing in answer["curves"]:
            for special in grazing["special"]:
                if grazing["period"] != 1 or special["kind"] != "flip-grazing":
                    continue
                centre = numpy.array(place(special)) / width
                flip = self.ends_at(answer, "flip", 1, centre, width)
                doubled = self.ends_at(answer, "grazing", 2, centre, width)
                self.assertIsNotNone(doubled)
                self.assertIn("halved", {end for curve in answer["curves"] for end in curve["ends"]
                                         if curve["kind"] == "grazing" and curve["period"] == 2})
                power = self.tangency(flip[::-1], centre, doubled, nearest=0.001, farthest=0.01)
                self.assertLess(abs(power - 2), 0.08, power)  # 1.81 between 0.005 and 0.05: there is a third power, too
                found += 1
        self.assertEqual(found, 1)

    def test_neimark_sacker_curves_are_born_on_borders_and_none_is_followed_twice(self):
        answer, width = curves_around_a_grazing_curve()
        curves = answer["curves"]
        on_border = [(curve["period"], numpy.array(place(special)) / width) for curve in curves
                     for special in curve["special"] if special["kind"] == "neimark-sacker-grazing"]
        self.assertGreaterEqual(len(on_border), 4)
        for period, centre in on_border:
            self.assertIsNotNone(self.ends_at(answer, "neimark-sacker", period, centre, width), (period, centre * width))
        for i, curve in enumerate(curves):
            for other in curves[:i]:
                if (curve["kind"], curve["period"]) != (other["kind"], other["period"]):
                    continue
                apart = [min(numpy.linalg.norm((numpy.array(place(curve["points"][end])) - place(point)) / width)
                             for point in other["points"]) for end in (0, len(curve["points"]) // 2, -1)]
                self.assertGreater(max(apart), 1e-3, (curve["kind"], curve["period"], i))

    def test_a_neimark_sacker_curve_ends_at_every_1_1_and_1_2(self):
        # No branch along the three lines each way meets the one that ends at this flip curve's 1:2.
        curves = document(f"boundaries {HEXAGON} --plane alpha=0.2:0.3 --plane beta=0.6:0.9 --max-period 2 --lines 3")["curves"]
        ends = [(why, place(point)) for curve in curves if curve["kind"] == "neimark-sacker"
                for why, point in zip(curve["ends"], (curve["points"][0], curve["points"][-1]))]
        begun = [(special["kind"], place(special)) for curve in curves if curve["kind"] in ("fold", "flip")
                 for special in curve["special"] if special["kind"] in ("1:1", "1:2")]
        self.assertGreater(len(begun), 0)
        for kind, here in begun:
            self.assertTrue(any(kind == why and math.dist(here, end) < 1e-6 for why, end in ends), (kind, here, ends))

    def test_a_curve_that_ends_at_stick_slip_leads_to_that_border(self):
        width = numpy.array([0.2, 0.2])
        ends = [curve for curve in self.borders["curves"] if "stick-slip" in curve["ends"]]
        self.assertGreaterEqual(len(ends), 1)
        for curve in ends:
            last = numpy.array(place(curve["points"][-1 if curve["ends"][1] == "stick-slip" else 0]))
            met = [special for border in self.borders["curves"] if border["kind"] == "stick-slip"
                   for special in border["special"]
                   if numpy.linalg.norm((numpy.array(place(special)) - last) / width) < 1e-5]
            self.assertEqual([special["kind"] for special in met], [f"{curve['kind']}-stick-slip"])

    @staticmethod
    def ends_at(answer, kind, period, centre, width):
        """The points, from there on, of a curve that ends at a place; none if there is none."""
        for curve in answer["curves"]:
            for way in (1, -1):
                points = numpy.array([place(point) for point in curve["points"][::way]]) / width
                near = numpy.linalg.norm(points[0] - centre) < 5e-4
                if curve["kind"] == kind and curve["period"] == period and near:
                    return points
        return None

    @staticmethod
    def tangency(border, centre, points, nearest=5e-3, farthest=0.05):
        """The power of the distance from `centre`, within these limits, with which the distance of a curve from the border
        grows."""
        middle = numpy.argmin(numpy.linalg.norm(border - centre, axis=1))
        around = border[max(0, middle - 12):middle + 13] - centre
        tangent = (around[-1] - around[0]) / numpy.linalg.norm(around[-1] - around[0])
        normal = numpy.array([-tangent[1], tangent[0]])
        x = around @ tangent
        line = numpy.polyfit(x[abs(x) < 0.06], (around @ normal)[abs(x) < 0.06], 6)
        x, y = (points - centre) @ tangent, (points - centre) @ normal
        first_far = numpy.argmax(abs(x) > farthest) or len(x)
        used = numpy.arange(len(x)) < first_far
        used &= abs(x) > nearest
        off = abs(y - numpy.polyval(line, x))[used]
        return numpy.polyfit(numpy.log(abs(x[used])), numpy.log(off), 1)[0]

    def test_continue_up_to_a_border_curve_ends_on_it(self):
        kinds = {curve["kind"] for curve in self.borders["curves"]}
        self.assertIn("grazing", kinds)
        for curve in self.borders["curves"]:
            if curve["kind"] not in ("grazing", "stick-slip"):
                continue
            point = curve["points"][len(curve["points"]) // 2]
            alpha, beta = place(point)
            near = ",".join(repr(x) for x in point["point"].values())
            found = []
            for shift in (1e-5, -1e-5):  # a grazing cycle is there on one side
                orbits = document(f"orbits {HEXAGON} --alpha {alpha + shift!r} --beta {beta!r} --near={near} "
                                  f"--period {curve['period']}", code=(0, 3))["orbits"]
                for orbit in orbits:
                    start = ",".join(repr(x) for x in orbit["points"][0].values())
                    branches = document(f"continue {HEXAGON} --alpha {alpha + shift!r} --beta {beta!r} --switch 0 --from={start} "
                                        f"--period {orbit['period']} --along alpha={alpha - 4e-3!r}:{alpha + 4e-3!r}", code=(0, 3))
                    found += [special["parameter"] for branch in branches["branches"] for special in branch["special"]
                              if special["kind"] == curve["kind"]]
            self.assertLess(min(abs(value - alpha) for value in found), 1e-9, (curve["kind"], alpha, beta))

    def test_equal_bytes_whatever_the_threads(self):
        """The second plane has curves of several kinds and periods, which are followed side by side, and lead to others."""
        for arguments in (SMALL, f"{BORDERS} --max-period 2 --lines 1"):
            answers = [run(f"boundaries {arguments} --json --threads {threads}").stdout for threads in (1, 3)]
            self.assertEqual(*answers)
        self.assertGreater(len({(curve["kind"], curve["period"]) for curve in json.loads(answers[0])["curves"]}), 4)

    def test_a_disk_that_loses_energy_has_no_fixed_point_whose_end_could_be_followed(self):
        """Between impacts a disk keeps |u_n|, and e < 1 takes of it."""
        answer = document("boundaries --sides disk --mu 0.3 --restitution 0.8 --plane alpha=0.3:0.4 --plane beta=0.3:0.8 "
                          "--max-period 1 --lines 1")
        self.assertEqual((answer["curves"], answer["outcome"]), ([], "completed"))

    def test_newtons_method_may_leave_a_parameters_range(self):
        answer = document("boundaries --sides 5 --alpha 0.4 --beta 0.3 --plane mu=0:0.5 --plane restitution=0.7:1 "
                          "--max-period 1 --lines 1")
        self.assertGreater(len(answer["curves"]), 0)
        self.assertEqual(answer["outcome"], "completed")


class Wrong(Refusing):
    def test_wrong_input_is_one_line_and_exit_2(self):
        for extra, mention in (("", "--plane"), ("--plane alpha=0.4:0.6", "twice"),
                               ("--plane alpha=0.4:0.6 --plane alpha=0.1:0.2", "different"),
                               ("--plane alpha=0.4:0.6 --plane size=0.1:0.2", "none of"),
                               ("--plane alpha=0.4:1.2 --plane beta=0.1:0.2", "alpha = 1.2"),
                               ("--plane alpha=0.4:0.6:3 --plane beta=0.1:0.2", "NAME=A:B"),
                               ("--plane alpha=nan:0.6 --plane beta=0.1:0.2", "finite"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --max-period 0", "max-period"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --longest-step 2", "longest-step"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --accuracy quad", "double"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --from none.h5", "none.h5"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --from none.h5 --max-period 2", "--max-period"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --from none.h5 --lines 2", "--lines"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --all --attracting", "both given"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --all --from none.h5", "--all"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --max-time 3", "--max-time goes with --all"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --all --max-time 0", "max-time"),
                               ("--plane alpha=0.4:0.6 --plane beta=0.1:0.2 --against none.h5", "none.h5")):
            self.refused(f"boundaries {HEXAGON} {extra}", mention)

    def test_records_of_other_kinds_are_refused(self):
        scene = "--sides 6 --mu 0.5 --restitution 0.9"
        path = self.folder.parent / (self.folder.name + ".h5")
        self.addCleanup(path.unlink)
        run(f"orbits {scene} --alpha 0.4 --beta 0.5 --period 1 --starts 1 --trajectories 1 --collisions 100 --quiet -o {path}")
        plane = "--plane alpha=0.4:0.6 --plane beta=0.1:0.2"
        self.refused(f"boundaries {scene} {plane} --from {path}", "none of")
        self.refused(f"boundaries {scene} {plane} --against {path}", "no record of swirl sweep")
        path.unlink()
        run(f"sweep {scene} --grid alpha=0.4:0.6:2 --grid beta=0.1:0.2:2 --refine 1 --runs 1 --collisions 100 --quiet -o {path}")
        self.refused(f"boundaries {scene} {plane} --against {path}", "refined sweep")


class Interrupted(Keeping):
    def test_what_is_finished_is_kept(self):
        answer = self.interrupt(f"boundaries {HEXAGON} --plane alpha=0.1:0.9 --plane beta=0.05:1.05 --lines 60 --threads 1", 1.5)
        self.assertIsInstance(answer["curves"], list)
        self.assertEqual(answer["outcome"], "interrupted")


if __name__ == "__main__":
    unittest.main()
