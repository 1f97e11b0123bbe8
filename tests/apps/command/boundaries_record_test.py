"""swirl boundaries --from a record, from outside: boundaries_record_test.py SWIRL"""

import json
import math
import shutil
import unittest
from pathlib import Path

import h5py
import xarray

from boundary_planes import BORDERS, HEXAGON, PLANE, SMALL, Searched, document, place
from driving import run


class Records(Searched):
    """A test that changes a record takes a copy."""

    def copied(self, record):
        return Path(shutil.copy(record, self.folder / "c.h5"))

    def test_the_record_holds_what_the_document_says(self):
        path, answer = self.record, self.answer
        curves = xarray.open_dataset(path, group="curves", engine="h5netcdf")
        self.assertEqual(list(curves["first"].values), [place(p)[0] for c in answer["curves"] for p in c["points"]])
        self.assertEqual(list(curves["second"].values), [place(p)[1] for c in answer["curves"] for p in c["points"]])
        ends = xarray.open_dataset(path, group="curve_ends", engine="h5netcdf")
        self.assertEqual(list(ends["kind"].values), [c["kind"] for c in answer["curves"]])
        self.assertEqual([[a, b] for a, b in zip(ends["begins_at"].values, ends["ends_at"].values)],
                         [c["ends"] for c in answer["curves"]])

    def test_special_points_of_a_record_are_places_to_begin(self):
        lines, again = self.folder / "line.h5", self.folder / "c.h5"
        start = "-0.0839,0.028,-0.5542,0.8898,-0.9793"
        run(f"continue --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --from={start} --along alpha=0.3:0.5 "
            f"--quiet -o {lines}")
        scene = "--sides 6 --mu 0.5 --restitution 0.9 --plane alpha=0.3:0.5 --plane beta=0.4:0.6"
        first = document(f"boundaries {scene} --from {lines} -o {again}")["curves"]
        self.assertGreater(len(first), 0)
        self.same_curves(first, document(f"boundaries {scene} --from {again}")["curves"])

    def same_curves(self, first, second):
        """Both have equal kinds, periods and ends; the middle of each curve lies within a step of one of the others."""
        def key(curve):
            return curve["kind"], curve["period"], sorted(curve["ends"])
        self.assertEqual(sorted(map(key, first)), sorted(map(key, second)))
        for curve in first:
            middle = place(curve["points"][len(curve["points"]) // 2])
            self.assertLess(min(math.dist(middle, place(point)) for other in second if key(other) == key(curve)
                                for point in other["points"]), 0.02 * 0.2)

    def test_a_record_of_curves_leads_to_all_of_them_again(self):
        path, other = self.folder / "c.h5", f"{HEXAGON} --plane alpha=0.76:0.84 --plane beta=0.5:0.7"
        curves = document(f"boundaries {other} --max-period 4 --lines 1 -o {path}")["curves"]
        kinds = set()
        for scene, first, record in ((BORDERS, self.borders["curves"], self.borders_record), (other, curves, path)):
            kinds.update(curve["kind"] for curve in first)
            self.same_curves(first, document(f"boundaries {scene} --from {record}")["curves"])
        self.assertLessEqual({"fold", "grazing", "two-vertices", "stick-slip"}, kinds)

    def test_a_record_that_does_not_say_what_touches_on_its_border_curves_is_refused(self):
        for scene, known, code in ((PLANE, self.record, 0), (BORDERS, self.borders_record, 2)):  # of the first the curves are smooth
            curves = self.answer["curves"] if known is self.record else self.borders["curves"]
            self.assertEqual("grazing" in {curve["kind"] for curve in curves}, code == 2)
            path = self.copied(known)
            with h5py.File(path, "r+") as record:
                del record["curves/touch"]
            result = run(f"boundaries {scene} --from {path} --quiet --json")
            self.assertEqual(result.returncode, code, result.stderr)
            if code == 2:
                self.assertEqual((result.stdout, len(result.stderr.splitlines())), ("", 1), result.stderr)
                self.assertIn("what touches", result.stderr)
            else:
                self.assertTrue(json.loads(result.stdout)["curves"])

    def test_a_record_leads_to_its_curves_in_a_smaller_plane(self):
        """The flip curve's end on the edge, beta = 0.3, alone lies in it, also where roundings put it a bit beyond."""
        part = BORDERS.replace("alpha=0.5:0.7", "alpha=0.5:0.55")
        inside = [c for c in self.borders["curves"] if any(p["parameters"]["alpha"] <= 0.55 for p in c["points"])]
        path = self.copied(self.borders_record)
        with h5py.File(path, "r+") as record:
            second = record["curves/second"][...]
            self.assertGreater((abs(second - 0.3) < 1e-15).sum(), 3)
            second[abs(second - 0.3) < 1e-15] = math.nextafter(0.3, 1)
            record["curves/second"][...] = second
        again = json.loads(run(f"boundaries {part} --from {path} --json --quiet").stdout)["curves"]
        kind = lambda c: (c["kind"], c["period"])
        self.assertGreaterEqual(len(inside), 3)
        for curve in inside:
            self.assertIn(kind(curve), list(map(kind, again)))

    def test_a_neimark_sacker_seed_without_an_angle_has_that_of_its_multipliers(self):
        path = self.folder / "line.h5"
        points = next(c for c in self.answer["curves"] if c["kind"] == "neimark-sacker")["points"]
        point = points[len(points) // 2]  # its ends are on the plane's edge, within rounding
        start, (alpha, beta) = ",".join(repr(x) for x in point["point"].values()), place(point)
        run(f"continue {HEXAGON} --alpha {alpha!r} --beta {beta!r} --from={start} --along alpha=0.4:0.6 --quiet -o {path}")
        plane = SMALL.split(" --max")[0]

        def pairs():
            return sum(curve["kind"] == "neimark-sacker" for curve in document(f"boundaries {plane} --quiet --from {path}")["curves"])
        found = pairs()
        self.assertGreater(found, 0)
        with h5py.File(path, "r+") as record:
            record["special/form_angle"][:] = math.nan
        self.assertEqual(pairs(), found)

    def test_columns_that_do_not_fit_are_refused(self):
        path = self.copied(self.record)
        for column, wrong in (("curves/period", 0), ("curves/period", -1), ("curves/period", 1000),
                              ("curves/curve", -3), ("curves/curve", 77)):
            with h5py.File(path, "r+") as record:
                right = record[column][0]
                record[column][0] = wrong
            result = run(f"boundaries {SMALL.split(' --max')[0]} --from {path}")
            self.assertEqual((result.returncode, result.stdout), (2, ""), (column, wrong, result.stderr))
            self.assertIn("damaged", result.stderr)
            with h5py.File(path, "r+") as record:
                record[column][0] = right


if __name__ == "__main__":
    unittest.main()
