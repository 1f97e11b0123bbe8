"""Scenes are values."""

import copy
import pickle
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from imported import DISK, HEXAGON, MODULES, PERIOD_8, swirl
from swirl.scene import NAMES


class Scenes(unittest.TestCase):
    def test_numbers_and_defaults_are_the_commands(self):
        self.assertEqual((HEXAGON.sides, HEXAGON.alpha, HEXAGON.law, HEXAGON.units), (6, 0.4, "poisson", None))
        self.assertAlmostEqual(HEXAGON.inertia_factor, (2 + 0.5) / 6, places=15)  # of the uniform lamina
        self.assertEqual((DISK.sides, DISK.inertia_factor, DISK.dimension, HEXAGON.dimension), ("disk", 0.5, 4, 5))

    def test_equal_parameters_make_equal_scenes(self):
        same = swirl.Scene(sides=6, alpha=0.4, beta=0.5, mu=0.5, restitution=0.95, law="poisson")
        self.assertEqual(same, HEXAGON)
        self.assertEqual(len({same, HEXAGON, PERIOD_8}), 2)
        self.assertNotEqual(HEXAGON, PERIOD_8)
        self.assertEqual(HEXAGON.with_(alpha=0.635), PERIOD_8)

    def test_a_scene_cannot_be_changed(self):
        for name in ("alpha", "new"):
            with self.assertRaises(AttributeError):
                setattr(HEXAGON, name, 0.5)
        with self.assertRaises(AttributeError):
            del HEXAGON._texts

    def test_pickle_copy_and_repr_give_it_back(self):
        units = swirl.Scene.from_units(sides=5, container_radius=0.05, polygon_radius=0.02, swirl_radius=0.01, swirl_rate=7,
                                       mass=0.003, mu=0.3, restitution=0.8, law="stronge")
        for scene in (HEXAGON, DISK, units, swirl.Scene(6, 0.1 + 0.2, 0.5, 0.5, "0.950")):
            self.assertEqual(pickle.loads(pickle.dumps(scene)), scene)
            self.assertEqual(copy.deepcopy(scene), scene)
            self.assertEqual(eval(repr(scene), {"Scene": swirl.Scene}), scene)
        self.assertEqual(units.units, {"length": 0.05, "time": 1 / 7, "mass": 0.003})
        self.assertAlmostEqual(units.alpha, 0.4, places=15)

    def test_files_and_records_hold_scenes(self):
        with tempfile.TemporaryDirectory() as folder:
            path = Path(folder) / "scene.toml"
            path.write_text("[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.95\nlaw = 'poisson'\n")
            self.assertEqual(swirl.Scene.from_toml(path), HEXAGON)
            with self.assertRaisesRegex(ValueError, "cannot be opened"):
                swirl.Scene.from_toml(Path(folder) / "none.toml")
        # A record says kappa, and 1/omega_s.
        turned = [swirl.Scene.from_units(sides=6, container_radius=0.05, polygon_radius=0.02, swirl_radius=0.01, swirl_rate=rate,
                                         mu=0.3, restitution=0.8) for rate in (7, 49, 0.1, 104.7)]
        for scene in (HEXAGON, DISK, *turned):
            again = swirl.Scene.from_record(swirl.describe(scene))
            self.assertEqual((again, hash(again)), (scene, hash(scene)))
            self.assertNotEqual(again, scene.with_(inertia_factor=0.3))
        self.assertNotEqual(turned[0], turned[1])
        with self.assertRaises(OSError):
            swirl.Scene.from_record("no-such.h5")

    def test_wrong_numbers_are_named(self):
        for wrong, words in (({"sides": 1}, "sides = 1 is outside its range"), ({"alpha": 1}, "alpha"), ({"mu": None}, "--mu is missing"),
                             ({"law": "hertz"}, "law = hertz is none of"), ({"alpha": float("nan")}, "alpha"), ({"mu": True}, "no number")):
            with self.assertRaisesRegex(ValueError, words):
                swirl.Scene(**{"sides": 6, "alpha": 0.4, "beta": 0.5, "mu": 0.5, "restitution": 0.9, **wrong})
        with self.assertRaises(TypeError):
            swirl.Scene(sides=6, radius=1)

    def test_its_parameters_are_those_of_the_command(self):
        import inspect
        self.assertEqual(set(inspect.signature(swirl.Scene).parameters), set(NAMES))


class Import(unittest.TestCase):
    def test_nothing_heavy_is_imported_with_it(self):
        script = "import sys; sys.path.insert(0, sys.argv[1]); import swirl; print(*sorted({'numpy', 'xarray', 'pandas', 'matplotlib', 'tqdm'} & set(sys.modules)))"
        result = subprocess.run([sys.executable, "-B", "-c", script, str(MODULES)], capture_output=True, text=True, check=True)
        self.assertEqual(result.stdout.strip(), "")


if __name__ == "__main__":
    unittest.main()
