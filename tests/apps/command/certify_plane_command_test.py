"""swirl certify --plane, from outside: certify_plane_command_test.py SWIRL [large]"""

import json
import random
import re
import sys
import unittest

import h5py
import numpy

from certificates import with_new_checksum
from driving import InFolder, document, run

LARGE = len(sys.argv) > 1 and sys.argv[1] == "large" and bool(sys.argv.pop(1))  # driving has taken SWIRL
HEXAGON = "--sides 6 --mu 0.5 --restitution 0.95"
#: (plane, resolution, longest flight): a fold and a flip of the hexagon cross the large one.
SMALL = "--plane alpha=0.3:0.31 --plane beta=0.5:0.51", 0.0625, 2
WIDE = "--plane alpha=0.4:0.6 --plane beta=0.25:0.5", 1 / 256, 2
PLANE, RESOLUTION, LONGEST = WIDE if LARGE else SMALL
COMMAND = f"certify {HEXAGON} {PLANE} --resolution {RESOLUTION} --max-time {LONGEST}"


def cell_at(cells, alpha, beta):
    return next(cell for cell in cells if cell["box"]["alpha"][0] <= alpha <= cell["box"]["alpha"][1]
                and cell["box"]["beta"][0] <= beta <= cell["box"]["beta"][1])


def counts_here(point):
    """Flies the fixed point of a curve's point no longer than those that cells count?"""
    scene = " ".join(f"--{name} {value!r}" for name, value in point["parameters"].items())
    start = ",".join(repr(value) for value in point["point"].values())
    step = document(f"simulate {HEXAGON} {scene} --point={start} --collisions 1")
    return step["collisions"][0]["flight_time"] <= LONGEST


class CertifyPlane(InFolder):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.text = run(f"{COMMAND} --json").stdout
        cls.found = json.loads(cls.text)

    def test_cells_are_the_plane_and_their_share_is_stated(self):
        area, total = 0, 0
        for cell in self.found["cells"]:
            sides = [high - low for low, high in cell["box"].values()]
            total += sides[0] * sides[1]
            area += sides[0] * sides[1] * cell["proven"]
            counts = [cell[name] for name in ("fixed_points", "attracting", "saddles", "repelling")]
            if cell["proven"]:
                self.assertEqual(counts[0], sum(counts[1:]))
                self.assertIsNone(cell["doubt"])
            else:
                self.assertEqual(counts, [None] * 4)
                self.assertIn(cell["doubt"], ("equations", "longest-flight", "contact-mode", "clearance", "stability"))
        (a, b), (c, d) = self.found["plane"].values()
        self.assertAlmostEqual(total / ((b - a) * (d - c)), 1, 12)
        self.assertAlmostEqual(area / total, self.found["proven_area"], 12)
        self.assertGreater(self.found["proven_area"], 0.8)
        self.assertEqual(self.found["outcome"], "completed")
        self.assertEqual(self.found["depths"][-1]["proven_area"], self.found["proven_area"])

    def test_a_list_of_all_fixed_points_agrees_at_random_places(self):
        draw = random.Random(5)
        proven = [cell for cell in self.found["cells"] if cell["proven"]]
        for _ in range(100 if LARGE else 2):
            cell = draw.choice(proven)
            alpha, beta = (draw.uniform(*cell["box"][name]) for name in ("alpha", "beta"))
            listed = document(f"certify {HEXAGON} --alpha {alpha!r} --beta {beta!r} --all --max-time {LONGEST}")
            self.assertTrue(listed["all"]["complete"])
            stability = [orbit["stability"] for orbit in listed["orbits"]]
            self.assertEqual((len(stability), stability.count("attracting"), stability.count("saddle"), stability.count("repelling")),
                             tuple(cell[name] for name in ("fixed_points", "attracting", "saddles", "repelling")), (alpha, beta))

    def test_no_curve_of_fixed_points_crosses_a_proven_cell(self):
        if not LARGE:
            self.skipTest("no curve crosses the small plane")
        curves = document(f"boundaries {HEXAGON} {PLANE} --max-period 1 --lines 6")["curves"]
        kinds = set()
        for curve in curves:
            if curve["period"] != 1 or curve["kind"] not in ("fold", "flip", "neimark-sacker", "grazing", "stick-slip"):
                continue
            for point in curve["points"]:
                if not counts_here(point):
                    continue
                cell = cell_at(self.found["cells"], *(min(max(point["parameters"][name], bounds[0]), bounds[1])
                                                      for name, bounds in self.found["plane"].items()))
                kinds.add(curve["kind"])
                self.assertFalse(cell["proven"], (curve["kind"], point["parameters"]))
        self.assertGreaterEqual(len(kinds), 2)

    def test_bytes_do_not_depend_on_threads(self):
        for threads in (1, 3):
            self.assertEqual(run(f"{COMMAND} --json --threads {threads}").stdout, self.text)

    def test_a_certificate_is_proven_again_and_edits_are_refused(self):
        file = self.file("plane.json", self.text)
        again = document(f"certify --check {file}")
        self.assertEqual((again["stated"], again["proven"], again["reason"]), (self.found["proven"], self.found["proven"], None))
        self.assertEqual(run(f"certify --check {self.file('cut.json', self.text.replace('0.5,', '0.51,', 1))}").returncode, 2)
        self.assertEqual(with_new_checksum(self.text), self.text)
        draw = random.Random(6)
        proven = [cell for cell in self.found["cells"] if cell["proven"]]
        for name in ("fixed_points", "attracting", "saddles", "repelling"):
            edited = json.loads(self.text)
            place = self.found["cells"].index(draw.choice(proven))
            edited["cells"][place][name] += 1
            self.refused(edited, (3,))
        for key, value in (("mu", 0.002), ("sides", 5)):  # few contacts hold by friction; other steps of vertices
            edited = json.loads(self.text)
            edited["scene"][key] = value
            self.refused(edited, (3,))
        edited = json.loads(self.text)
        edited["proven_area"] = 0.5 if LARGE else 0.25
        self.refused(edited, (2,))

    def refused(self, edited, codes):
        edited.pop("checksum")  # it comes last
        text = with_new_checksum(json.dumps(edited, indent=2).rstrip("}\n") + ",\n  \"checksum\"")
        self.assertIn(run(f"certify --check {self.file('edited.json', text)}").returncode, codes)

    def test_the_record_has_the_cells(self):
        self.assertEqual(run(f"{COMMAND} --quiet -o {self.folder / 'cells.h5'}").returncode, 0)
        with h5py.File(self.folder / "cells.h5") as file:
            cells = file["cells"]
            self.assertEqual(len(cells["proven"]), len(self.found["cells"]))
            self.assertEqual(file["result"].attrs["proven_area"], self.found["proven_area"])
            expected = [cell["fixed_points"] or 0 for cell in self.found["cells"]]
            self.assertEqual(list(cells["fixed_points"]), expected)
            self.assertTrue(numpy.array_equal(cells["first_low"], [cell["box"]["alpha"][0] for cell in self.found["cells"]]))

    def test_the_table_has_the_share_by_halvings(self):
        table = run(COMMAND).stdout
        self.assertRegex(table, r"halvings +cells +% proven +core s\n")
        self.assertIn(f"{100 * self.found['proven_area']:.3f} % of the plane is proven", table)
        shares = {}
        for cell in self.found["cells"]:
            if cell["proven"]:
                counts = cell["fixed_points"], cell["attracting"]
                shares[counts] = shares.get(counts, 0) + 100 * 2.0 ** -cell["depth"]
        told = re.findall(r"^ +(\d+) fixed points?, +of which (\d+) attracting: ([\d.]+) %$", table, re.MULTILINE)
        self.assertEqual([(int(points), int(attracting)) for points, attracting, _ in told], sorted(shares))
        for (*counts, share) in told:
            self.assertAlmostEqual(float(share), shares[tuple(map(int, counts))], delta=6e-4)
        self.assertLessEqual(max(map(len, table.splitlines())), 100)

    def test_what_cannot_be_is_refused(self):
        plane = "--plane alpha=0.3:0.31 --plane beta=0.5:0.51"
        for flags, words in ((f"{HEXAGON} --plane alpha=0.3:0.31", "--plane NAME=A:B is wanted twice"),
                             (f"--sides 6 --mu 0.5 --restitution 1 {plane}", "restitution < 1"),
                             (f"--sides 6 --mu 0 --restitution 0.9 {plane}", "mu > 0"),
                             (f"--sides disk --mu 0.5 --restitution 0.9 {plane}", "polygons"),
                             (f"{HEXAGON} {plane} --resolution 2", "resolution = 2 is outside its range"),
                             (f"{HEXAGON} {plane} --resolution nan", "resolution"),
                             (f"{HEXAGON} {plane} --max-time 0", "max-time = 0 is outside its range"),
                             (f"{HEXAGON} {plane} --all", "give one of"),
                             (f"{HEXAGON} {plane.replace('0.3:0.31', '0.31:0.3')}", "plane alpha=0.31:0.3: NAME=A:B with A < B is wanted"),
                             (f"{HEXAGON} {plane} --beta 0.5", "--beta and --plane beta=... are both given"),
                             (f"{HEXAGON} --alpha 0.3 --beta 0.5 --all --resolution 0.1", "--resolution goes with --plane")):
            result = run(f"certify {flags}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), (flags, result.stderr))
            self.assertIn(words, result.stderr)


if __name__ == "__main__":
    unittest.main()
