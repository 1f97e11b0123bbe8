"""--tangential-restitution, from outside: tangential_restitution_test.py SWIRL. What follows it, and what refuses it."""

import math
import re
import unittest

import h5py

import every_command
from driving import InFolder, document, run, without_progress

DISK = "--sides disk --alpha 0.3 --beta 0.4 --mu 0.5 --restitution 1"
LOSSY = "--sides disk --alpha 0.3 --beta 0.4 --mu 0.5 --restitution 0.6"
BILLIARD = "--sides disk --alpha 0.3 --beta 0 --mu 1000 --restitution 1 --tangential-restitution 1 --x 0.1 --vy 0.8 --spin 2"
#: How a command is asked, beside its scene.
ASKED = every_command.ASKED | {
    "certify": "--near=0,-0.43056,0.19151,-0.30504 --period 1",
    "continue": "--from=0,-0.43056,0.19151,-0.30504 --along tau=1:1.5",
}
REFUSED = {"tradeoff", "certify", "boundaries"}
#: The family that this one continues is of another swirl.
SCENES = {"continue": "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"}


class TangentialRestitution(InFolder, every_command.FollowedOrRefused):
    def test_every_command_with_a_scene_follows_or_refuses_it(self):
        self.check_every_command(ASKED, lambda name: f"{SCENES.get(name, DISK)} --tangential-restitution 0.7", REFUSED,
                                 ["tangential-restitution = 0.7"], {"tangential_restitution": 0.7})

    def test_axes_over_it(self):
        asked = "--transient 50 --collisions 100"
        cells = document(f"sweep {DISK} --grid tangential-restitution=0:1:3 --runs 1 {asked}")["cells"]
        self.assertEqual([cell["parameters"]["tangential-restitution"] for cell in cells], [0, 0.5, 1])
        columns = document(f"bifurcate {DISK} --along tangential-restitution=0:1:2 {asked}")["columns"]
        self.assertEqual([column["parameter"] for column in columns], [0, 1])
        for command in ("boundaries", "certify"):
            result = run(f"{command} --sides disk --alpha 0.4 --mu 0.5 --restitution 0.9 "
                         "--plane tangential-restitution=0:1 --plane beta=0.1:0.2")
            self.assertEqual(result.returncode, 2, command)
            self.assertIn("tangential-restitution=0:1", result.stderr)

    def test_zero_changes_nothing(self):
        plain = run(f"simulate {LOSSY} --collisions 50 --json").stdout
        self.assertEqual(run(f"simulate {LOSSY} --collisions 50 --tangential-restitution 0 --json").stdout, plain)
        self.assertNotIn("tangential_restitution", plain)

    def test_polygons_are_refused_with_the_reason(self):
        hexagon = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
        for line in (f"simulate {hexagon} --tangential-restitution 0.5",
                     f"continue {hexagon} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along tangential-restitution=0:0.5",
                     f"bifurcate {hexagon} --along tangential-restitution=0:1:2"):
            result = run(line)
            self.assertEqual((result.returncode, result.stdout), (2, ""), line)
            self.assertIn("B_3 != 0", result.stderr, line)

    def test_wrong_values(self):
        for value, word in (("-0.1", "-0.1"), ("1.5", "1.5"), ("nan", "nan"), ("x", "'x'")):
            record = self.folder / "none.h5"
            result = run(f"simulate {DISK} --tangential-restitution {value} -o {record}")
            self.assertEqual((result.returncode, result.stdout, record.exists()), (2, "", False), value)
            self.assertEqual(len(without_progress(result.stderr)), 1, value)
            self.assertIn(f"tangential-restitution = {word}", result.stderr)

    def test_a_scene_file_has_it(self):
        file = self.folder / "scene.toml"
        file.write_text('[scene]\nsides = "disk"\nalpha = 0.3\nbeta = 0.4\nmu = 0.5\nrestitution = 1\n'
                        "tangential-restitution = 0.25\n")
        found = document(f"simulate --scene {file} --collisions 10")
        self.assertEqual(found["scene"]["tangential_restitution"], 0.25)
        self.assertEqual(found, document(f"simulate {DISK} --tangential-restitution 0.25 --collisions 10"))

    def test_a_record_is_followed_again(self):
        record = self.folder / "orbit.h5"
        scene = f"{DISK} --tangential-restitution 0.75"
        self.assertEqual(run(f"simulate {scene} --collisions 300 --quiet -o {record}").returncode, 0)
        with h5py.File(record) as file:
            self.assertEqual(file["scene"].attrs["tangential_restitution"], 0.75)
        direct = document(f"spectrum {scene} --transient 0 --collisions 300")
        self.assertEqual(direct["power"], document(f"spectrum {record}")["power"])
        self.assertIn("tangential_restitution 0.75", re.sub(" +", " ", run(f"show {record}").stdout))

    def test_pages_refuse_it(self):
        record = self.folder / "map.h5"
        self.assertEqual(run(f"sweep {DISK} --grid tangential-restitution=0:1:2 --grid beta=0.1:0.3:2 --runs 1 --transient 50 "
                             f"--collisions 100 --quiet -o {record}").returncode, 0)
        result = run(f"explore {record} -o {self.folder / 'map.html'}")
        self.assertEqual(result.returncode, 2)
        self.assertIn("tangential restitution", result.stderr)

    def test_shards_are_joined(self):
        axes = f"{DISK} --grid tangential-restitution=0:1:2 --runs 2 --transient 50 --collisions 100 --quiet"
        parts = [self.folder / f"part{i}.h5" for i in (1, 2)]
        for i, part in enumerate(parts, 1):
            self.assertEqual(run(f"sweep {axes} --shard {i}/2 -o {part}").returncode, 0)
        self.assertEqual(run(f"join {parts[0]} {parts[1]} --quiet -o {self.folder / 'whole.h5'}").returncode, 0)
        self.assertEqual(run(f"sweep {axes} -o {self.folder / 'direct.h5'}").returncode, 0)
        self.assertEqual((self.folder / "whole.h5").read_bytes(), (self.folder / "direct.h5").read_bytes())

    def test_the_no_slip_billiard_alternates(self):
        """v_t takes two values in turn, its change the slip's part 2 kappa/(1 + kappa)."""
        rows = document(f"simulate {BILLIARD} --collisions 200")["collisions"]
        for row, after in zip(rows, rows[2:]):
            self.assertAlmostEqual(row["vt"], after["vt"], delta=1e-13)
        slip = rows[0]["vt"] + 0.3 * rows[0]["spin"]
        self.assertAlmostEqual(rows[1]["vt"], rows[0]["vt"] - 2 / 3 * slip, delta=1e-13)
        radii = [0.7 * abs(row["vt"]) / math.hypot(row["vt"], row["vn"]) for row in rows[:2]]
        self.assertGreater(abs(radii[0] - radii[1]), 0.05)

    def test_every_precision_follows_it(self):
        flags = f"{DISK} --tangential-restitution 0.9 --collisions 8"
        plain = document(f"simulate {flags}")["collisions"]
        for accuracy in ("extended", "quad"):
            for a, b in zip(plain, document(f"simulate {flags} --accuracy {accuracy}")["collisions"]):
                self.assertAlmostEqual(a["spin"], b["spin"], delta=1e-9)

    def test_a_lossy_disk_rolls_in_the_end(self):
        found = document(f"classify {LOSSY} --tangential-restitution 0.8")
        self.assertEqual(found["outcome"], "in-contact")
        self.assertEqual(found["kind"], "rolling-librating")
        self.assertAlmostEqual(found["mean_S"], -0.7 / 0.3, delta=1e-12)

    def test_with_drag(self):
        found = document(f"simulate {DISK} --drag 0.1 --tangential-restitution 0.9 --collisions 20")
        self.assertEqual((found["scene"]["drag"], found["scene"]["tangential_restitution"]), (0.1, 0.9))

    def test_describe_says_what_is_conserved(self):
        text = run(f"describe {DISK} --tangential-restitution 1").stdout
        self.assertIn("J + I S/alpha is conserved", text)
        self.assertNotIn("conserved", run(f"describe {DISK} --tangential-restitution 0.9").stdout)


if __name__ == "__main__":
    unittest.main(verbosity=2)
