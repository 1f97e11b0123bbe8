"""swirl plot --caption: what a figure shows, in words. caption_test.py SWIRL"""

import re
import tempfile
import unittest
from pathlib import Path

import h5py

import figure_records
from driving import InFolder, run

class Captions(InFolder):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.record = Path(folder.name) / "d.h5"
        figure_records.write_crowded_special(cls.record, 40)

    def setUp(self):
        super().setUp()
        self.words = self.folder / "d.txt"

    def drawn(self, flags=""):
        result = run(f"plot {self.record} -o {self.folder}/d.png --caption {self.words} --quiet {flags}")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return self.words.read_text()

    def not_drawn(self, words, mention):
        result = run(f"plot {self.record} -o {self.folder}/e.png --caption {words} --quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
        self.assertIn(mention, result.stderr)
        self.assertFalse((self.folder / "e.png").exists())

    def test_every_special_point_is_listed_also_those_that_are_left_out(self):
        with h5py.File(self.record) as record:
            places = sorted(record["special/parameter"][:])
        text = self.drawn()
        all_points, drawn = map(int, re.search(r"Special points, (\d+), of which (\d+) are drawn", text).groups())
        rows = re.findall(r"^ +(\S.*?) +(3\.\d+) +(\S+)(?: +(left out.*))?$", text, re.MULTILINE)
        self.assertEqual([float(row[1]) for row in rows], [float(f"{place:.10g}") for place in places])
        self.assertEqual(all_points, len(places))
        self.assertEqual(sum(not row[3] for row in rows), drawn)
        self.assertIn("hexagon, β = 0.5, μ = 0.5, e = 0.95", text)
        self.assertIn(str(self.record), text)
        narrow = self.drawn("--width 40 --no-title")
        fewer = int(re.search(r"of which (\d+) are drawn", narrow).group(1))
        self.assertTrue(0 < fewer <= drawn < all_points)  # a marker covers more of a narrow figure
        self.assertIn("hexagon, β = 0.5", narrow)  # the title that the figure lacks

    def test_legend_and_caption_count_the_same_points_in_a_range(self):
        text = self.drawn("--xlim 3.25:3.3")
        head, all_points, drawn = re.search(r"(Special points with alpha from 3.25 to 3.3), (\d+), of which (\d+) are", text).groups()
        rows = re.findall(r"^ +flip +(3\.\d+) .*$", text, re.MULTILINE)
        self.assertEqual(len(rows), int(all_points))
        self.assertTrue(all(3.25 <= float(row) <= 3.3 for row in rows) and 0 < int(drawn) <= len(rows) < 40, text)

    def test_of_several_kinds_each_part_has_its_own(self):
        figure_records.write_orbits(self.folder / "o.h5", 4, 1.3)
        text = self.drawn(str(self.folder / "o.h5"))
        self.assertIn("Kinds of figure: bifurcation, multipliers.", text)
        self.assertLess(text.index("(a) bifurcation"), text.index("(b) multipliers"))
        self.assertIn("Kind of figure: bifurcation.", self.drawn())

    def test_a_file_that_swirl_did_not_write_stays(self):
        self.words.write_text("my notes\n")
        self.not_drawn(self.words, "d.txt")
        self.assertEqual(self.words.read_text(), "my notes\n")
        self.drawn("--force")
        self.drawn()  # its own is replaced

    def test_the_figure_itself_is_no_caption(self):
        (self.folder / "e.png").symlink_to("d.txt")
        result = run(f"plot {self.record} -o {self.folder}/e.png --caption {self.words} --quiet")
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
        self.assertIn("is the figure itself", result.stderr)
        self.assertFalse(self.words.exists())

    def test_wrong_names(self):
        for name, mention in (("d.doc", "suffix"), ("no/such/d.txt", "no/such"), ("d.h5", "suffix")):
            with self.subTest(name):
                self.not_drawn(self.folder / name, mention)


if __name__ == "__main__":
    unittest.main()
