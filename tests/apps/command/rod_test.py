"""--sides 2, the rod, from outside: rod_test.py SWIRL. What knows it, and what refuses it."""

import json
import math
import tempfile
import unittest
from pathlib import Path

from driving import document, run
from every_command import ASKED, FollowedOrRefused

ROD = "--sides 2 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
REFUSED = {"tradeoff", "certify", "boundaries"}


class Rod(unittest.TestCase, FollowedOrRefused):
    def test_commands_know_or_refuse_it(self):
        self.check_every_command(ASKED, lambda name: ROD, REFUSED, ["sides = 2", "rod"], {"sides": 2})

    def test_its_numbers(self):
        facts = document(f"describe {ROD}")
        self.assertAlmostEqual(facts["scene"]["inertia_factor"], 1 / 3, delta=1e-16)
        text = json.dumps(facts)
        self.assertIn(f"{math.pi / 2 - math.asin(0.4):.12f}", text)  # chi_m
        self.assertIn("rod", run(f"simulate {ROD} --collisions 3").stdout)

    def test_its_ends_strike_within_their_room(self):
        rows = document("simulate --sides 2 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1 --collisions 500")["collisions"]
        room = math.pi / 2 - math.asin(0.4)
        self.assertLessEqual(max(abs(row["chi"]) for row in rows), room + 1e-12)
        self.assertEqual({row["vertex"] for row in rows}, {0, 1})

    def test_lying_it_is_a_chord(self):
        found = document("simulate --sides 2 --alpha 0.4 --beta 0.5 --mu 0.3 --restitution 0.3 --time 60")
        self.assertTrue(any(len(contact["vertices"]) == 2 for contact in found["contacts"]))

    def test_an_axis_of_sides_begins_at_it(self):
        asked = "--alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --runs 1 --transient 50 --collisions 100"
        cells = document(f"sweep {asked} --grid sides=2:4:3")["cells"]
        self.assertEqual([cell["parameters"]["sides"] for cell in cells], [2, 3, 4])
        self.assertEqual(run(f"sweep {asked} --grid sides=1:4:4").returncode, 2)

    def test_pages_refuse_it(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder) / "map.h5"
            line = (f"sweep --sides 2 --mu 0.5 --restitution 0.9 --grid alpha=0.2:0.4:2 --grid beta=0.3:0.5:2 --runs 1 "
                    f"--transient 50 --collisions 100 --quiet -o {record}")
            self.assertEqual(run(line).returncode, 0)
            result = run(f"explore {record} -o {Path(folder) / 'map.html'}")
            self.assertEqual(result.returncode, 2)
            self.assertIn("rod", result.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
