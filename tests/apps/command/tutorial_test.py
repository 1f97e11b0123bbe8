"""docs/tutorial.md's commands in an empty folder, in their order, and what it says of their results: tutorial_test.py SWIRL
ROOT"""

import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

import h5py

from driving import run

TEXT = (Path(sys.argv.pop(1)).resolve() / "docs" / "tutorial.md").read_text(encoding="utf-8")


class Tutorial(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder, cls.said = Path(folder.name), {}
        scene = re.search(r"^```toml\n# (\S+)\n(.*?)^```", TEXT, re.M | re.S)
        (cls.folder / scene[1]).write_text(scene[2])
        cls.blocks = re.findall(r"^```sh\n(.*?)^```", TEXT, re.M | re.S)
        for line in "".join(cls.blocks).splitlines():
            result = run(line.removeprefix("swirl "), cwd=cls.folder)
            assert line.startswith("swirl ") and result.returncode == 0, (line, result.stderr)
            cls.said[line.split()[1]] = result.stdout

    def test_it_has_ten_commands(self):
        self.assertEqual(len(self.blocks), 10)
        self.assertEqual(re.findall(r"^\*\*(\d+)\.", TEXT, re.M), [str(number) for number in range(1, 11)])

    def test_all_that_it_names_is_there(self):
        for name in ("orbit.h5", "orbit.png", "orbit.gif", "runs.h5", "map.h5", "cycles.h5", "branches.h5", "diagram.h5",
                     "diagram.pdf"):
            self.assertGreater((self.folder / name).stat().st_size, 1000, name)

    def test_what_it_says_of_them_is_so(self):
        verdict = json.loads(run("classify --scene hexagon.toml --json", cwd=self.folder).stdout)
        self.assertEqual((verdict["mode"], verdict["kind"]), ("steady", "fixed-point"))
        self.assertIn(f"S = −{-verdict['mean_S']:.6f}", TEXT)
        modes = json.loads(run("describe --scene hexagon.toml --json", cwd=self.folder).stdout)["steady_modes"]
        stable = [mode for mode in modes if mode["stability"] == "stable"]
        self.assertEqual((len(modes), [mode["j"] for mode in stable]), (31, [2]))
        self.assertAlmostEqual(stable[0]["S"], verdict["mean_S"], places=9)
        with h5py.File(self.folder / "runs.h5") as runs:
            self.assertEqual(list(runs["attractors/share"][:]), [1.0])
        with h5py.File(self.folder / "branches.h5") as branches:
            special = branches["special"]
            found = {(kind.decode(), f"{parameter:.6f}") for kind, parameter in zip(special["kind"][:], special["parameter"][:])}
        for kind, words in (("flip", r"flip at α = (\S+?),"), ("neimark-sacker", r"\(Neimark–Sacker\) at α = (\S+?)\.\s")):
            self.assertIn((kind, re.search(words, TEXT)[1]), found)
        with h5py.File(self.folder / "cycles.h5") as cycles:
            self.assertIn("unstable", {name.decode() for name in cycles["orbits/stability"][:1]})


if __name__ == "__main__":
    unittest.main()
