"""swirl orbits, continue and bifurcate, from outside: orbits_command_test.py SWIRL"""

import json
import shlex
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import xarray

SWIRL = sys.argv[1]
sys.argv = sys.argv[:1]
HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
POINT = "-0.083922288419212287574,0.027966794811174552721,-0.55420644250323559488,0.88979354385790028771,-0.97926605821858726645"
WINDOW = "--sides 6 --beta 0.5 --mu 0.5 --restitution 0.95"


def run(arguments, **options):
    return subprocess.run([SWIRL, *shlex.split(arguments)], capture_output=True, text=True, timeout=300, **options)


def document(arguments):
    result = run(arguments + " --json")
    assert result.returncode == 0, (arguments, result.stderr)
    assert result.stderr == "", result.stderr
    return json.loads(result.stdout)


class InFolder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.folder = Path(self.temporary.name)
        self.addCleanup(self.temporary.cleanup)

    def refused(self, arguments, mention):
        result = run(f"{arguments} -o {self.folder}/a.h5")
        self.assertEqual((result.returncode, result.stdout), (2, ""), (arguments, result.stderr))
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class Orbits(InFolder):
    def test_the_published_fixed_point_is_found_with_its_multipliers(self):
        found = document(f"orbits {HEXAGON} --period 1")["orbits"]
        wanted = [float(x) for x in POINT.split(",")]
        best = min(found, key=lambda o: abs(o["points"][0]["S"] - wanted[4]))
        for name, value in zip(("psi", "chi", "vn", "vt", "S"), wanted):
            self.assertAlmostEqual(best["points"][0][name], value, delta=1e-12)
        for (re, im), (a, b) in zip(best["multipliers"], [(0.603654650944, 0.745364501151), (0.603654650944, -0.745364501151),
                                                          (-0.235491544256, 0.54249265091), (-0.235491544256, -0.54249265091), (0, 0)]):
            self.assertAlmostEqual(re, a, delta=2e-12)
            self.assertAlmostEqual(im, b, delta=2e-12)
        self.assertEqual((best["stability"], best["index"], best["family"], best["period"]), ("stable", 0, None, 1))
        self.assertEqual([set(letter) for letter in best["word"]], [{"vertex_step", "contact_mode"}])
        self.assertAlmostEqual(best["mean_S"], best["points"][0]["S"], delta=1e-13)

    def test_near(self):
        near = document(f"orbits {HEXAGON} --near=-0.0829,0.028,-0.5552,0.8908,-0.9783")
        self.assertEqual(len(near["orbits"]), 1)
        self.assertLessEqual(near["iterations"], 20)
        self.assertAlmostEqual(near["orbits"][0]["points"][0]["S"], -0.97926605821858726645, delta=1e-12)

    def test_nothing_near_is_exit_3_and_a_document(self):
        result = run(f"orbits {HEXAGON} --period 7 --near=1,0.1,-0.3,2,3 --json")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(json.loads(result.stdout)["orbits"], [])

    def test_a_family_is_one_orbit_with_its_tangent(self):
        disk = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"
        found = document(f"orbits {disk}")["orbits"]
        self.assertLess(len(found), 20)
        main = next(o for o in found if o["family"]["shortest_return_time"] < 0.1)
        self.assertEqual(main["family"]["dimension"], 1)
        self.assertGreater(main["family"]["longest_return_time"], 2.5)
        self.assertEqual(set(main["family"]["tangents"][0]), {"psi", "vn", "vt", "S"})
        pinned = document(f"orbits {disk} --pin tau=2.5")["orbits"]
        member = min(pinned, key=lambda o: abs(o["points"][0]["S"] + 0.30503695))
        self.assertAlmostEqual(member["points"][0]["S"], -0.30503695, delta=1e-8)
        self.assertAlmostEqual(abs(complex(*member["multipliers"][0])), 1.0072349, delta=1e-7)

    def test_without_friction_and_with_dissipation_none_exist(self):
        answer = document("orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0 --restitution 0.9")
        self.assertEqual(answer["orbits"], [])
        self.assertIn("J", answer["none_exist"])

    def test_threads_do_not_matter_and_the_record_opens(self):
        records = []
        for threads in (1, 2):
            path = self.folder / f"{threads}.h5"
            self.assertEqual(run(f"orbits {HEXAGON} --max-period 2 --threads {threads} -o {path} --quiet").returncode, 0)
            records.append(path.read_bytes())
        self.assertEqual(*records)
        orbits = xarray.open_dataset(self.folder / "1.h5", group="orbits", engine="h5netcdf")
        self.assertEqual(set(orbits["period"].values), {1, 2})
        self.assertTrue((orbits["residual"] < 1e-12).all())

    def test_wrong_input(self):
        for extra, mention in [("--period 0", "period"), ("--period 2 --max-period 3", "both"), ("--near 1,2", "numbers"),
                               ("--near 0,0,1,0,0", "u_n"), ("--pin x=3", "pin"), ("--pin tau=-1", "tau"),
                               ("--accuracy quad", "double"), ("--starts -1", "starts")]:
            self.refused(f"orbits {HEXAGON} {extra}", mention)


class Continue(InFolder):
    def test_a_branch_with_its_special_points(self):
        branches = document(f"continue {HEXAGON} --from={POINT} --along alpha=0.1:0.9")["branches"]
        kinds = [s["kind"] for s in branches[0]["special"]]
        for kind in ("fold", "flip", "neimark-sacker"):
            self.assertIn(kind, kinds)
        for point in branches[0]["points"]:
            self.assertLessEqual(point["residual"], 1e-12)
            self.assertTrue(0.1 <= point["parameter"] <= 0.9)
        for special in branches[0]["special"]:
            moduli = [complex(*m) for m in special["multipliers"]]
            critical = {"fold": lambda m: abs(m - 1), "flip": lambda m: abs(m + 1),
                        "neimark-sacker": lambda m: abs(abs(m) - 1) if m.imag else 1}[special["kind"]]
            self.assertLess(min(map(critical, moduli)), 1e-6)
            self.assertEqual(set(special["point"]), {"psi", "chi", "vn", "vt", "S"})
            self.assertIsNotNone(special["normal_form"])
        doubled = branches[1]
        self.assertEqual((doubled["period"], doubled["begins"], doubled["switched_from"]), (2, "switched", 0))

    def test_the_disks_family_loses_its_stability(self):
        branch, = document("continue --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 "
                           "--from=0,-0.576,0.192,-0.305 --along tau=1:3")["branches"]
        special, = branch["special"]
        self.assertEqual(special["kind"], "neimark-sacker")
        self.assertAlmostEqual(special["parameter"], 2.33112237041442, delta=1e-8)

    def test_the_ends_of_the_range_are_on_the_branch(self):
        branch = document(f"continue {HEXAGON} --from={POINT} --along beta=0.48:0.52 --switch 0")["branches"][0]
        self.assertEqual(sorted({branch["points"][0]["parameter"], branch["points"][-1]["parameter"]}), [0.48, 0.52])
        self.assertEqual((branch["begins"], branch["ends"]), ("range", "range"))

    def test_nothing_there_is_exit_3(self):
        result = run(f"continue {HEXAGON} --from=1,0.1,-0.3,2,3 --period 5 --along alpha=0.3:0.5 --json")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(json.loads(result.stdout)["branches"], [])

    def test_wrong_input(self):
        rest = f"continue {HEXAGON}"
        for extra, mention in [("--along alpha=0.3:0.5", "from"), (f"--from={POINT}", "along"),
                               (f"--from={POINT} --along alpha=0.5:0.6", "outside"),
                               (f"--from={POINT} --along sides=3:6", "NAME"), (f"--from={POINT} --along alpha=0.3:0.5:3", "A:B"),
                               (f"--from={POINT} --along alpha=0.3:x", "x"), (f"--from={POINT} --along alpha=0.4:0.4", "differ"),
                               ("--from=1,2,3 --along alpha=0.3:0.5", "numbers")]:
            self.refused(f"{rest} {extra}", mention)


class Bifurcate(InFolder):
    def test_columns_and_branches(self):
        path = self.folder / "d.h5"
        answer = document(f"bifurcate {WINDOW} --along alpha=0.365:0.41:10 --starts 2 --branches --follow -o {path}")
        self.assertEqual([c["parameter"] for c in answer["columns"]][::9], [0.365, 0.41])
        for column in answer["columns"][1:]:
            self.assertEqual((column["mode"], column["period"]), ("steady", 1))
            self.assertEqual([a["origin"] for a in column["attractors"]], ["random", "random", "up", "down"])
            self.assertEqual(len(column["S"]), 4)
            self.assertLess(max(column["S"]) - min(column["S"]), 1e-8)
        self.assertGreaterEqual(answer["agreement"]["compared"], 15)
        self.assertLess(answer["agreement"]["largest_difference_of_S"], 1e-8)
        self.assertEqual(answer["agreement"]["without_branch"], 0)
        self.assertIn("flip", [s["kind"] for b in answer["branches"] for s in b["special"]])
        for group, name in (("samples", "S"), ("columns", "period"), ("branches", "parameter"), ("special", "kind")):
            self.assertIn(name, xarray.open_dataset(path, group=group, engine="h5netcdf"))
        self.assertEqual(run(f"plot {path} -o {self.folder}/d.png --quiet").returncode, 0)

    def test_chaos_is_named(self):
        answer = document(f"bifurcate {WINDOW} --along alpha=0.3:0.35:3 --starts 2")
        self.assertEqual({c["mode"] for c in answer["columns"]}, {"chaotic"})
        self.assertEqual({c["period"] for c in answer["columns"]}, {None})

    def test_a_disk_that_rolls_is_named_as_classify_names_it(self):
        scene = "--sides disk --beta 0.23 --mu 0.4 --restitution 0.3"
        column = document(f"bifurcate {scene} --along alpha=0.35:0.36:2 --starts 1")["columns"][0]
        verdict = document(f"classify {scene} --alpha 0.35")
        self.assertEqual(column["attractors"][0]["kind"], verdict["kind"])
        self.assertEqual(column["mode"], verdict["mode"])

    def test_threads_do_not_matter(self):
        outputs = [run(f"bifurcate {WINDOW} --along alpha=0.3:0.4:6 --starts 3 --follow --json --threads {t}").stdout for t in (1, 2)]
        self.assertEqual(*outputs)

    def test_falling_ranges_run_backwards(self):
        columns = document(f"bifurcate {WINDOW} --along alpha=0.41:0.37:3 --starts 1")["columns"]
        self.assertEqual(columns[0]["parameter"], 0.41)

    def test_wrong_input(self):
        for extra, mention in [("--along alpha=0.3:0.4", "COUNT"), ("--along alpha=0.3:0.4:1", "COUNT"),
                               ("--along alpha=0.3:1.4:5", "1.39"), ("--along S=0:1:5", "NAME"), ("", "along"),
                               ("--along alpha=0.3:0.4:5 --observable x", "observable"),
                               ("--along alpha=0.3:0.4:5 --x 0.1", "random"), ("--along alpha=0.3:0.4:5 --starts 0", "follow")]:
            self.refused(f"bifurcate {WINDOW} {extra}", mention)


if __name__ == "__main__":
    unittest.main(verbosity=2)
