"""The gallery's lines of Python and its figures: gallery_test.py ROOT [SWIRL MODULES]

With SWIRL and the folder of the module `swirl` (nightly) the gallery is made: every kind of figure is in it, each line of Python draws
its command's figure, byte by byte, and the site's first page opens with the page in which the map runs."""

import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve()
SWIRL, MODULES = (sys.argv.pop(1), Path(sys.argv.pop(1)).resolve()) if len(sys.argv) > 2 else (None, None)
sys.path[:0] = [str(ROOT / "docs/site"), str(ROOT / "notebooks-export")]

import gallery  # noqa: E402


class Lines(unittest.TestCase):
    def test_a_command_becomes_a_line_of_python(self):
        for command, line in (
                ("simulate --sides disk --alpha 0.4 --time 40", 'swirl.simulate(sides="disk", alpha=0.4, time=40)'),
                ("sweep --grid alpha=0.2:0.6:17 --grid mu=0.1,0.5 --track", 'swirl.sweep(track=True, grid={"alpha": (0.2, 0.6, 17), "mu": [0.1, 0.5]})'),
                ("continue --from=-0.08,0.02 --along alpha=0.3:0.5", 'swirl.continue_(from_=(-0.08, 0.02), along={"alpha": (0.3, 0.5)})'),
                ("fit --series film.csv --marks x y", 'swirl.fit(series="film.csv", marks=["x", "y"])')):
            self.assertEqual(gallery.python_of(command), line)
            compile(line, "line", "eval")
        self.assertEqual(gallery.plot_of("--kind section --x psi --y S"), '"section", x="psi", y="S"')
        self.assertEqual(gallery.plot_of(""), "")

    def test_every_line_is_python(self):
        for name, command, look, _ in gallery.figures():
            compile(f"{gallery.python_of(command)}.plot({gallery.plot_of(look)})", name, "eval")


class Figures(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        cls.made = subprocess.run([sys.executable, "-B", ROOT / "docs/site/gallery.py", SWIRL, cls.folder], capture_output=True, text=True,
                                  timeout=1200)

    def test_it_has_every_kind_of_figure(self):
        self.assertEqual((self.made.returncode, self.made.stderr), (0, ""))
        from swirl_figures import KINDS
        self.assertEqual({line.split(": ")[1] for line in self.made.stdout.splitlines()}, set(KINDS))
        self.assertIn("<!DOCTYPE html>", (self.folder / "page.html").read_text()[:100])

    def test_python_draws_the_same(self):
        result = subprocess.run([sys.executable, "-B", ROOT / "docs/site/gallery.py", "--check", MODULES, self.folder], capture_output=True,
                                text=True, timeout=1200)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)


if __name__ == "__main__":
    unittest.main(defaultTest=None if SWIRL else "Lines")
