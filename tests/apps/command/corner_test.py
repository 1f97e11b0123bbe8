"""--corner, rounded corners, from outside: corner_test.py SWIRL. What follows them, and what refuses them."""

import json
import math
import re
import unittest

import h5py

from driving import InFolder, document, run, without_progress
from every_command import ASKED, FollowedOrRefused

SHARP = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
ROUND = f"{SHARP} --corner 0.05"
REFUSED = {"tradeoff", "certify", "boundaries", "describe"}


def kappa_of(sides, alpha, r):
    """I/(m alpha^2) by quadrature in polar form, from the middle of a corner to the middle of a side."""
    half, rho, steps = math.pi / sides, alpha - r, 20000
    ends = math.atan2(r * math.sin(half), rho + r * math.cos(half))  # of the corner's arc
    area = second = 0.0
    for i in range(steps):
        phi = (i + 0.5) / steps * half
        if phi < ends:
            reach = rho * math.cos(phi) + math.sqrt(r * r - (rho * math.sin(phi)) ** 2)
        else:
            reach = (rho * math.cos(half) + r) / math.cos(half - phi)
        area += reach ** 2 / 2
        second += reach ** 4 / 4
    return second / area / alpha ** 2


class RoundCorners(InFolder, FollowedOrRefused):
    def test_every_command_with_a_scene_follows_or_refuses_them(self):
        self.check_every_command(ASKED, lambda name: ROUND, REFUSED, ["corner = 0.05"], {"corner": 0.05})

    def test_kappa_is_that_of_the_shape(self):
        for sides, alpha, r in ((6, 0.4, 0.05), (3, 0.5, 0.3), (12, 0.6, 0.01)):
            scene = f"--sides {sides} --alpha {alpha} --corner {r} --beta 0.5 --mu 0.5 --restitution 0.9"
            found = document(f"simulate {scene} --collisions 1")["scene"]["inertia_factor"]
            self.assertAlmostEqual(found, kappa_of(sides, alpha, r), delta=1e-8)

    def test_zero_changes_nothing(self):
        plain = run(f"simulate {SHARP} --collisions 50 --json").stdout
        self.assertEqual(run(f"simulate {SHARP} --collisions 50 --corner 0 --json").stdout, plain)
        self.assertNotIn("corner", plain)

    def test_nearly_full_corners_are_nearly_the_disk(self):
        disk = document(f"simulate {SHARP.replace('--sides 6', '--sides disk')} --collisions 10")["collisions"]
        for sides in (3, 6):
            flags = SHARP.replace("--sides 6", f"--sides {sides}")
            rows = document(f"simulate {flags} --corner 0.39999999999 --collisions 10")["collisions"]
            for row, of_disk in zip(rows, disk):
                self.assertAlmostEqual(row["spin"], of_disk["spin"], delta=1e-7)
                self.assertAlmostEqual(row["t"], of_disk["t"], delta=1e-7)

    def test_an_impact_has_the_corners_lever_arm(self):
        found = document(f"simulate {ROUND} --collisions 40")
        kappa, rows = found["scene"]["inertia_factor"], found["collisions"]
        for before, row in zip(rows, rows[1:]):
            arm = (0.35 * math.cos(row["chi"]) + 0.05, 0.35 * math.sin(row["chi"]))
            change = (arm[0] * row["impulse_tangential"] + arm[1] * row["impulse_normal"]) / (kappa * 0.16)
            self.assertAlmostEqual(row["spin"] - before["spin"], change, delta=1e-12)
            self.assertAlmostEqual(row["jacobi"] - before["jacobi"], row["jacobi_restitution"] + row["jacobi_friction"],
                                   delta=1e-13)
            x, y = row["x"] - 0.5 * math.cos(row["t"]), row["y"] - 0.5 * math.sin(row["t"])
            angle = row["angle"] + 2 * math.pi * row["vertex"] / 6
            centre = math.hypot(x + 0.35 * math.cos(angle), y + 0.35 * math.sin(angle))
            self.assertAlmostEqual(centre, 0.95, delta=1e-12)

    def test_axes_over_them(self):
        asked = "--transient 50 --collisions 100"
        cells = document(f"sweep {SHARP} --grid corner=0:0.2:3 --runs 1 {asked}")["cells"]
        self.assertEqual([cell["parameters"]["corner"] for cell in cells], [0, 0.1, 0.2])
        self.assertEqual(run(f"sweep {SHARP} --grid corner=0.3:0.5:2 --runs 1 {asked}").returncode, 2)
        columns = document(f"bifurcate {SHARP} --inertia-factor 0.42 --along corner=0:0.2:2 {asked}")["columns"]
        self.assertEqual([column["parameter"] for column in columns], [0, 0.2])
        for line in (f"bifurcate {SHARP} --along corner=0:0.2:2", f"bifurcate {ROUND} --along alpha=0.3:0.4:2"):
            result = run(line)
            self.assertEqual((result.returncode, result.stdout), (2, ""), line)
            self.assertIn("inertia-factor", result.stderr)
        for command in ("boundaries", "certify"):
            result = run(f"{command} --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --plane corner=0:0.1 --plane beta=0.1:0.2")
            self.assertEqual(result.returncode, 2, command)
            self.assertIn("corner=0:0.1", result.stderr)

    def test_a_branch_along_the_radius(self):
        steady = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --inertia-factor 0.4166666666666667"
        found = document(f"continue {steady} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along corner=0:0.02")
        points = found["branches"][0]["points"]
        self.assertLess(min(point["parameter"] for point in points), 1e-12)
        self.assertGreater(max(point["parameter"] for point in points), 0.0199)
        last = max(points, key=lambda point: point["parameter"])
        z = ",".join(f"{last['point'][name]!r}" for name in ("psi", "chi", "vn", "vt", "S"))
        rows = document(f"simulate {steady} --corner {last['parameter']!r} --point={z} --collisions 3")["collisions"]
        for row in rows:
            self.assertAlmostEqual(row["spin"], last["point"]["S"], delta=1e-9)

    def test_wrong_values(self):
        for value, word in (("-0.1", "-0.1"), ("0.4", "0.4"), ("0.5", "0.5"), ("nan", "nan"), ("1e-80", "1e-80"), ("x", "'x'")):
            record = self.folder / "none.h5"
            result = run(f"simulate {SHARP} --corner {value} -o {record}")
            self.assertEqual((result.returncode, result.stdout, record.exists()), (2, "", False), value)
            self.assertEqual(len(without_progress(result.stderr)), 1, value)
            self.assertIn(f"corner = {word}", result.stderr)
        for line, word in ((f"simulate {SHARP.replace('--sides 6', '--sides disk')} --corner 0.1", "disk"),
                           (f"simulate {ROUND} --drag 0.1", "floor that drags"),
                           (f"simulate {ROUND} --noise-wall 0.1", "noise"),
                           (f"simulate {ROUND} --corner-radius 0.1", "both given"),
                           (f"ramp {SHARP} --along corner=0:0.1 --rate 1e-3", "the body"),
                           (f"simulate {ROUND} --accuracy paper", "accuracy = paper is not extended to rounded corners"),
                           (f"classify {ROUND} --accuracy quad", "rounded corners")):
            result = run(line)
            self.assertEqual((result.returncode, result.stdout), (2, ""), line)
            self.assertIn(word, result.stderr, line)

    def test_the_inertia_of_a_map_over_the_radius_is_its_cells_own(self):
        for grid in ("--grid corner=0:0.2:2", "--corner 0.1 --grid alpha=0.3:0.5:2"):
            scene = SHARP if "corner=" in grid else SHARP.replace("--alpha 0.4 ", "")
            found = document(f"sweep {scene} {grid} --runs 1 --collisions 100 --transient 10")
            self.assertEqual(found["settings"]["inertia_factor"], "uniform")

    def test_lengths_in_metres(self):
        scene = ("--sides 6 --container-radius 0.1 --polygon-radius 0.04 --swirl-radius 0.05 --corner-radius 0.005 --mu 0.5 "
                 "--restitution 0.9")
        found = document(f"simulate {scene} --collisions 10")
        self.assertAlmostEqual(found["scene"]["corner"], 0.05, delta=1e-16)
        self.assertEqual(found["units"]["length"], 0.1)

    def test_a_scene_file_has_them(self):
        file = self.folder / "scene.toml"
        file.write_text("[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\ncorner = 0.05\n")
        self.assertEqual(document(f"simulate --scene {file} --collisions 10"), document(f"simulate {ROUND} --collisions 10"))

    def test_a_record_is_followed_again(self):
        record = self.folder / "orbit.h5"
        self.assertEqual(run(f"simulate {ROUND} --collisions 300 --quiet -o {record}").returncode, 0)
        with h5py.File(record) as file:
            self.assertEqual(file["scene"].attrs["corner"], 0.05)
        direct = document(f"spectrum {ROUND} --transient 0 --collisions 300")
        self.assertEqual(direct["power"], document(f"spectrum {record}")["power"])
        self.assertIn("corner 0.05", re.sub(" +", " ", run(f"show {record}").stdout))

    def test_pages_refuse_them(self):
        record = self.folder / "map.h5"
        self.assertEqual(run(f"sweep {SHARP} --grid corner=0:0.1:2 --grid beta=0.1:0.3:2 --runs 1 --transient 50 "
                             f"--collisions 100 --quiet -o {record}").returncode, 0)
        result = run(f"explore {record} -o {self.folder / 'map.html'}")
        self.assertEqual(result.returncode, 2)
        self.assertIn("rounded corners", result.stderr)

    def test_every_precision_follows_them(self):
        plain = document(f"simulate {ROUND} --collisions 8")["collisions"]
        for accuracy in ("extended", "quad"):
            for a, b in zip(plain, document(f"simulate {ROUND} --collisions 8 --accuracy {accuracy}")["collisions"]):
                self.assertAlmostEqual(a["spin"], b["spin"], delta=1e-9)

    def test_chatter_ends_by_name(self):
        result = run(f"simulate {ROUND.replace('--mu 0.5', '--mu 0').replace('0.9', '0.3')} --collisions 100000 --every 100000 --json")
        self.assertEqual(result.returncode, 3)
        found = json.loads(result.stdout)
        self.assertEqual((found["outcome"], found["contacts"]), ("contact-of-corner", []))


if __name__ == "__main__":
    unittest.main(verbosity=2)
