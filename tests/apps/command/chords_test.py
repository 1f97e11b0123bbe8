"""Chords and diameters in describe and classify, from outside: chords_test.py SWIRL"""

import math
import unittest

import h5py

from driving import InFolder, document, run

PAPER = "--sides 6 --beta 0.1 --mu 0.5 --restitution 1"


class Chords(InFolder):
    def test_describe_lists_the_hexagons_limit(self):
        found = document(f"describe {PAPER} --alpha 0.44 --max-time 1")["chords"]
        chord = next(c for c in found if c["j"] == 3 and c["a"] > 0)
        self.assertAlmostEqual(chord["a"], 0.5868, delta=5e-5)
        self.assertEqual((chord["fate"], chord["attracts"]), ("limit", True))
        self.assertAlmostEqual(chord["limit_S"], -10.451, delta=1e-3)
        self.assertAlmostEqual(math.hypot(*chord["multipliers"][0]), 0.364, delta=5e-4)
        diameter = next(c for c in found if c["a"] == 0)
        self.assertEqual((diameter["fate"], diameter["limit_S"]), ("leaves", None))

    def test_describe_gives_the_balance_below_e_1(self):
        found = document("describe --sides 6 --alpha 0.56 --beta 0.1 --mu 0.5 --restitution 0.9999 --max-time 1")
        diameter = next(c for c in found["chords"] if c["a"] == 0)
        self.assertAlmostEqual(diameter["balance_J"], 1.1427, delta=0.02)
        self.assertAlmostEqual((0.75 * diameter["growth"]) ** (1 / 3), 0.44702, delta=5e-6)

    def test_a_diameter_accelerates(self):
        found = document(f"classify {PAPER} --alpha 0.56")
        self.assertEqual((found["mode"], found["kind"], found["mean_S"]), ("quasi-steady", "accelerated", None))
        growth = found["growth_exponent"]
        self.assertLess(growth["low"], growth["value"])
        self.assertLess(growth["value"], growth["high"])
        self.assertAlmostEqual(growth["value"], 1 / 3, delta=0.05)
        gain = next(e for e in found["evidence"] if e["name"] == "gain of energy per impact")
        self.assertAlmostEqual(gain["value"] / gain["threshold"], 1, delta=0.2)

    def test_a_chord_has_its_limit(self):
        found = document(f"classify {PAPER} --alpha 0.44")
        self.assertEqual((found["mode"], found["kind"], found["mean_S"]), ("quasi-steady", "chord", None))
        self.assertAlmostEqual(found["limit_S"], -10.451, delta=1e-3)
        self.assertIsNone(found["growth_exponent"])
        self.assertIn("S goes to -10.45", run(f"classify {PAPER} --alpha 0.44").stdout)

    def test_a_neutral_chord_is_named_as_the_reason(self):
        found = document(f"classify {PAPER} --alpha 0.5")
        self.assertEqual((found["mode"], found["mean_S"]), ("undecided", None))
        self.assertAlmostEqual(found["evidence"][-1]["value"], 1, delta=1e-6)
        self.assertIn("whose multipliers have modulus 1", run(f"classify {PAPER} --alpha 0.5").stdout)

    def test_a_slow_limit_that_depends_on_beta_is_not_told(self):
        """S comes to 0.4904 at beta 0.2; to leading order in beta it is 0.7171."""
        found = document("classify --sides 6 --alpha 0.48 --beta 0.2 --mu 0.5 --restitution 1 --point=0,0,-0.9,0.5,0.7")
        self.assertEqual((found["kind"], found["limit_S"]), ("quasi-periodic", None))
        self.assertAlmostEqual(found["mean_S"], 0.49, delta=0.02)

    def test_created_energy_is_no_chaos_however_few_impacts(self):
        found = document("classify --sides 6 --law newton --alpha 0.14 --beta 0.1 --mu 0.5 --restitution 1 --transient 2500 --collisions 500")
        self.assertEqual((found["mode"], found["kind"], found["mean_S"]), ("undecided", "accelerated", None))

    def test_sweeps_say_where_orbits_go(self):
        swept = f"sweep {PAPER} --grid alpha=0.3,0.44,0.56"
        chaos, chord, diameter = document(swept)["cells"]
        self.assertEqual([chaos["runs"][0][key] for key in ("growth_exponent", "limit_S")], [None, None])
        for row in (chord["runs"][0], chord["attractors"][0]):
            self.assertAlmostEqual(row["limit_S"], -10.451, delta=1e-3)
            self.assertIsNone(row["growth_exponent"])
        for row in (diameter["runs"][0], diameter["attractors"][0]):
            self.assertAlmostEqual(row["growth_exponent"]["value"], 1 / 3, delta=0.05)
            self.assertIsNone(row["limit_S"])
        shown = run(swept).stdout
        self.assertIn("S -> -10.4508", shown)
        self.assertIn(f"J ~ n^{diameter['runs'][0]['growth_exponent']['value']:.3g}", shown)
        with h5py.File(self.record(swept)) as record:
            self.assertAlmostEqual(record["sweep/run_limit_S"][1, 0], -10.451, delta=1e-3)
            self.assertEqual(record["sweep/run_growth_exponent"][2, 0], diameter["runs"][0]["growth_exponent"]["value"])

    def test_diagrams_say_where_orbits_go(self):
        diagram = f"bifurcate {PAPER} --along alpha=0.44:0.56:2 --starts 1"
        chord, diameter = (column["attractors"][0] for column in document(diagram)["columns"])
        self.assertAlmostEqual(chord["limit_S"], -10.451, delta=1e-3)
        self.assertGreater(diameter["growth_exponent"]["value"], 0.2)
        self.assertIn("S -> -10.4508", run(diagram).stdout)
        with h5py.File(self.record(diagram)) as record:
            self.assertAlmostEqual(record["attractors/limit_S"][0], -10.451, delta=1e-3)

    def record(self, command):
        path = self.folder / "driven.h5"
        self.assertIn(run(f"{command} --quiet -o {path}").returncode, (0, 3))
        return path

    def test_chaos_is_neither(self):
        found = document("classify --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1")
        self.assertEqual((found["kind"], found["growth_exponent"], found["limit_S"]), ("chaotic", None, None))


if __name__ == "__main__":
    unittest.main()
