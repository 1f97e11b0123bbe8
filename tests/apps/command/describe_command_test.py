"""swirl describe, from outside: describe_command_test.py SWIRL"""

import math
import unittest

import h5py
import xarray

from driving import InFolder, document, run

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DISK = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5"
COORDINATES = ("psi", "chi", "vn", "vt", "S")


class Describe(InFolder):
    def test_the_hexagon_has_its_31_steady_modes(self):
        found = document(f"describe {HEXAGON}")
        modes = found["steady_modes"]
        self.assertEqual([m["branch"] for m in modes], ["+"] * 6 + ["-"] * 25)
        self.assertEqual((found["complete"], found["families"], found["none_exist"], found["rim"]), (True, [], None, None))
        for mode in modes:
            self.assertAlmostEqual(mode["S"], 1 - 2 * math.pi * mode["j"] / (6 * mode["tau"]), delta=1e-13)
            largest = max(math.hypot(*m) for m in mode["multipliers"])
            self.assertEqual(mode["stability"], "stable" if largest < 1 else "unstable")
            self.assertEqual((mode["point"]["chi"], mode["point"]["S"]), (mode["chi"], mode["S"]))
            self.assertLess(mode["residual"], 1e-12)
        times = [[m["tau"] for m in modes if m["branch"] == sign] for sign in "+-"]
        self.assertEqual(times, [sorted(t) for t in times])

    def test_where_a_polygon_rests_on_two_vertices_orbits_come_to_rest(self):
        for body, rest in (("--sides 3 --alpha 0.4 --mu 0.5", "--restitution 0.3"), ("--sides 6 --alpha 0.3 --mu 0.2", "--restitution 0.5")):
            scene = f"{body} --beta 0.5 {rest}"
            found = document(f"describe {scene}")["rests"]
            self.assertEqual([r["stability"] for r in found], ["unstable", "stable"])
            sample = document(f"simulate {scene} --time 2000 --sample 2000")["samples"][-1]
            t, x, y = (sample[name] for name in ("t", "x", "y"))
            place = math.atan2(y - 0.5 * math.sin(t), x - 0.5 * math.cos(t)) - t  # from the container's centre
            self.assertAlmostEqual(math.remainder(place - found[1]["psi"], 2 * math.pi), 0, delta=1e-10)  # t is 2000: 1e-13 of it
            self.assertAlmostEqual(sample["spin"], 1, delta=1e-10)
            text = run(f"describe {scene}").stdout
            self.assertIn("\n  rest on the wall on two vertices, S = 1:\n", text)
            self.assertIn("\n  steady modes by impacts (none that stay on the wall) with tau <= 12: ", text)

    def test_friction_that_lifts_a_vertex_leaves_no_rest(self):
        # mu (1 - d cos g) <= d sin g with sin g = alpha sin(pi/N), d = cos g - alpha cos(pi/N): 0.39135 of this hexagon
        scene = "--sides 6 --alpha 0.3 --beta 0.5 --restitution 0.9 --max-time 1"
        self.assertEqual([len(document(f"describe {scene} --mu {mu}")["rests"]) for mu in (0.391, 0.392)], [2, 0])
        self.assertIn("two vertices, S = 1: none\n", run(f"describe {scene} --mu 0.5").stdout)
        still, = (r for r in document(f"describe {scene} --mu 0")["rests"] if r["stability"] == "neutral")
        self.assertAlmostEqual(still["psi"], 0, delta=1e-15)
        record = self.folder / "a.h5"
        run(f"describe {scene} --mu 0.2 -o {record} --quiet")
        with xarray.open_dataset(record, group="rests", engine="h5netcdf") as rests:
            self.assertEqual(rests["psi"].dims, ("rest",))

    def test_the_published_fixed_point_is_among_them_and_the_map_keeps_it(self):
        modes = document(f"describe {HEXAGON}")["steady_modes"]
        mode = min(modes, key=lambda m: abs(m["S"] + 0.97926605821858726645))
        wanted = (-0.083922288419212287574, 0.027966794811174552721, -0.55420644250323559488, 0.88979354385790028771,
                  -0.97926605821858726645)
        for name, value in zip(COORDINATES, wanted):
            self.assertAlmostEqual(mode["point"][name], value, delta=1e-13)
        self.assertAlmostEqual(math.hypot(*mode["multipliers"][0]), math.hypot(0.603654650944, 0.745364501151), delta=2e-12)
        self.assertEqual(mode["stability"], "stable")
        point = ",".join(repr(mode["point"][name]) for name in COORDINATES)
        impact, = document(f"simulate {HEXAGON} --point={point} --collisions 1")["collisions"]
        self.assertAlmostEqual(impact["flight_time"], mode["tau"], delta=1e-13)
        self.assertEqual((impact["vertex"], impact["contact_mode"]), (mode["j"] % 6, mode["contact_mode"]))

    def test_a_longer_time_only_adds_modes(self):
        short, long = (document(f"describe {HEXAGON} --max-time {t}")["steady_modes"] for t in (6, 12))
        kept = [m for m in long if m["tau"] <= 6]
        self.assertTrue(0 < len(short) < 31)
        self.assertEqual([(m["branch"], m["j"]) for m in short], [(m["branch"], m["j"]) for m in kept])
        for a, b in zip(short, kept):  # bracketed within other intervals: the same but for rounding
            self.assertAlmostEqual(a["tau"], b["tau"], delta=1e-13)
            self.assertAlmostEqual(a["chi"], b["chi"], delta=1e-13)

    def test_facts_against_their_formulas(self):
        for sides, alpha, painleve in ((6, 0.4, 1.721), (3, 0.3, 1.118)):
            scene = f"--sides {sides} --alpha {alpha} --beta 0.5 --restitution 0.9 --max-time 1"
            found = document(f"describe {scene} --mu 0.5")
            widest = math.pi / sides - math.asin(alpha * math.sin(math.pi / sides))
            kappa = found["scene"]["inertia_factor"]
            slope = min(math.sqrt(kappa / (1 + kappa)), math.tan(widest))
            self.assertAlmostEqual(found["widest_chi"], widest, delta=1e-15)
            self.assertAlmostEqual(found["painleve_friction"], kappa / slope + (1 + kappa) * slope, delta=1e-14)
            self.assertAlmostEqual(found["painleve_friction"], painleve, delta=5e-4)
            self.assertFalse(found["can_jam"])
            self.assertTrue(document(f"describe {scene} --mu 1.8")["can_jam"])
            self.assertAlmostEqual(found["untouched_radius"], 1 - alpha - 0.5, delta=1e-15)
            self.assertEqual((found["sheltered"], found["impacts"]), (True, "can-last"))
        wide = HEXAGON.replace("--beta 0.5", "--beta 0.7")
        self.assertFalse(document(f"describe {wide} --max-time 1")["sheltered"])

    def test_where_none_exist_it_says_why(self):
        for scene, why in (("--sides 6 --alpha 0.4 --beta 0.5 --mu 0 --restitution 0.9", "without friction"),
                           (f"{DISK} --restitution 0.9", "disk")):
            found = document(f"describe {scene}")
            self.assertEqual((found["steady_modes"], found["families"]), ([], []))
            self.assertIn(why, found["none_exist"])
            self.assertIn(found["none_exist"], " ".join(run(f"describe {scene}").stdout.split()))  # broken at 100 columns
        self.assertEqual(document("describe --sides 6 --alpha 0.4 --beta 0.5 --mu 0 --restitution 0.9")["impacts"], "fade")

    def test_the_disk_has_families_and_a_pendulum(self):
        found = document(f"describe {DISK} --restitution 1")
        rim, rho = found["rim"], 0.7
        self.assertTrue(rim["rolls"])
        self.assertAlmostEqual(rim["strength"], 0.1 / (1.5 * rho), delta=1e-15)
        self.assertAlmostEqual(rim["small_frequency"], math.sqrt(0.1 / (1.5 * rho)), delta=1e-15)
        self.assertAlmostEqual(rim["mean_S"], -rho / 0.3, delta=1e-15)
        self.assertAlmostEqual(rim["rest_force"], 0.1 + rho, delta=1e-15)
        for key in ("widest_chi", "painleve_friction"):
            self.assertIsNone(found[key])
        self.assertEqual({f["branch"] for f in found["families"]}, {"+", "-"})
        for family in found["families"]:
            middle = (family["shortest_return_time"] + family["longest_return_time"]) / 2
            mode, sign = family["midway"], 1 if family["branch"] == "+" else -1
            self.assertAlmostEqual(mode["tau"], middle, delta=1e-13)
            # S of the member at tau: (±beta − R sin tau/tau)/alpha, R = 1 − alpha ± beta
            self.assertAlmostEqual(mode["S"], (sign * 0.1 - (rho + sign * 0.1) * math.sin(middle) / middle) / 0.3, delta=1e-13)
            self.assertEqual((set(mode["point"]), len(mode["multipliers"])), ({"psi", "vn", "vt", "S"}, 4))
        sliding = document("describe --sides disk --alpha 0.3 --beta 0.1 --mu 0 --restitution 1 --max-time 2")
        self.assertEqual((sliding["rim"]["rolls"], sliding["rim"]["mean_S"], sliding["impacts"]), (False, None, "conserved"))
        self.assertTrue(all(f["S_is_free"] for f in sliding["families"]))

    def test_physical_units_make_the_same_scene(self):
        lengths = "--container-radius 2 --polygon-radius 0.8 --swirl-radius 1 --swirl-rate 4"
        found = document(f"describe --sides 6 {lengths} --mu 0.5 --restitution 0.9")
        self.assertEqual(found.pop("units"), {"length": 2, "time": 0.25, "mass": 1})
        self.assertEqual(found, document(f"describe {HEXAGON}"))

    def test_the_record_opens_and_holds_what_the_document_says(self):
        files = [self.folder / name for name in ("a.h5", "b.h5")]
        found = [document(f"describe {HEXAGON} -o {file}") for file in files][0]
        self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
        with h5py.File(files[0]) as record:
            self.assertEqual(record["facts"].attrs["painleve_friction"], found["painleve_friction"])
            self.assertEqual(record["scene"].attrs["sides"], 6)
            self.assertNotIn("rim", record)
        with xarray.open_dataset(files[0], group="steady_modes", engine="h5netcdf") as modes:
            self.assertEqual(dict(modes.sizes), {"steady_mode": 31, "coordinate": 5, "multiplier_index": 5})
            for key in ("j", "tau", "chi", "S", "speed", "residual"):
                self.assertEqual(list(modes[key].values), [m[key] for m in found["steady_modes"]], key)
            self.assertEqual(modes["branch"].attrs["flag_meanings"], "+ -")
            self.assertEqual([int(b) for b in modes["branch"]], [0] * 6 + [1] * 25)
            self.assertEqual(modes["point"].values.tolist(), [[m["point"][k] for k in COORDINATES] for m in found["steady_modes"]])
        for name, scene in (("disk.h5", f"{DISK} --restitution 1"), ("none.h5", f"{DISK} --restitution 0.5")):
            self.assertEqual(run(f"describe {scene} --quiet -o {self.folder / name}").returncode, 0)
            with h5py.File(self.folder / name) as record:
                self.assertAlmostEqual(record["rim"].attrs["mean_S"], -0.7 / 0.3, delta=1e-15)
                self.assertTrue(math.isnan(record["facts"].attrs["painleve_friction"]))
                self.assertEqual("families" in record, name == "disk.h5")

    def test_the_table_lists_every_mode_in_lines_of_one_width(self):
        lines = run(f"describe {HEXAGON}").stdout.splitlines()
        heading = next(i for i, line in enumerate(lines) if line.split()[:5] == ["orbit", "branch", "j", "tau", "chi"])
        rows = lines[heading + 1:-1]
        self.assertEqual([int(row.split()[0]) for row in rows], list(range(1, 32)))
        self.assertIn("--orbit I", lines[-1])
        column = lines[heading].index("stability")
        for row in rows:
            self.assertIn(row[column:], ("stable", "unstable"))
        self.assertTrue(all(len(line) <= 120 for line in lines))
        self.assertEqual(run(f"describe {HEXAGON} --quiet").stdout, "")

    def test_wrong_input(self):
        for extra, mention in (("--max-time 0", "max-time"), ("--max-time -1", "max-time"), ("--max-time nan", "max-time"),
                               ("--max-time 10001", "max-time"), ("--max-time long", "max-time"),
                               ("--accuracy quad", "double"), ("--bogus 1", "bogus"), ("--swirl-rate -1", "swirl-rate")):
            result = run(f"describe {HEXAGON} {extra} -o {self.folder}/a.h5")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)
        for scene, mention in (("--sides 6", "missing"), (HEXAGON.replace("0.4", "1.2"), "alpha = 1.2")):
            result = run(f"describe {scene} -o {self.folder}/a.h5")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
