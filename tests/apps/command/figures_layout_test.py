"""What has room in a figure as wide as a paper's column, and what is refused there.

figures_layout_test.py SWIRL ROOT [--all]; --all: an orbit's figure in every column."""

import unittest
import warnings

from matplotlib.figure import Figure

from driving import run
from drawn_records import ALL, WithRecords, labels_of
from chosen import COLUMNS
from figure_faults import faults
from swirl_figures import Look, RecordError, draw, save
from swirl_figures.room import make_room


def in_inches(width):
    return width and width / 25.4


class Columns(WithRecords):
    """Every figure in a column by turns: figures_test.py."""

    def check(self, name, kind, width):
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # matplotlib's "constrained_layout not applied"
            figure = draw(self.records[name], kind, Look(width=in_inches(width)))
        self.assertEqual(faults(figure), [], (name, kind, width))

    def test_of_an_orbit_with_many_impacts_has_room_in_every_column(self):
        widths = sorted({*COLUMNS.values(), 130})
        for width in widths if ALL else (widths[0], 130, widths[-1]):
            self.check("orbit", "orbit", width)

    def test_faults_are_seen(self):
        """Else the tests above show nothing."""
        figure = Figure(figsize=(2, 2))
        left, right = figure.subplots(1, 2)
        left.set_xlabel("a label that is longer than its panel")
        right.set_xlabel("and another one beside it")
        right.plot([0, 1], label="a legend that is wider than the panel that it stands in")
        right.legend()
        figure.add_axes((0.4, 0.4, 0.05, 0.05))
        found = " ".join(faults(figure))
        for fault in ("cut off: a label", "on one another: a label", "a legend wider", "a sliver"):
            self.assertIn(fault, found)
        narrow = Figure(figsize=(0.5, 0.5), layout="constrained")
        narrow.subplots().set(ylabel="no room", xlabel="no room", title="no room")
        self.assertIn("constrained_layout", " ".join(faults(narrow)))


class Numbers(WithRecords):
    def test_along_an_axis_are_thinned_and_words_are_not(self):
        figure = Figure(figsize=(3, 2), layout="constrained")
        numbers, words = figure.subplots(2, 1)
        numbers.set_xticks([0.1234 + 0.01 * k for k in range(12)])
        words.set_xticks(range(3), ["chaotic", "quasi-steady", "steady"])
        make_room(figure, Look(), "a test")
        self.assertLess(len(numbers.get_xticks()), 8)
        self.assertEqual([label.get_text() for label in words.get_xticklabels()], ["chaotic", "quasi-steady", "steady"])
        words.set_xticks(range(12), ["a long name"] * 12)
        with self.assertRaisesRegex(RecordError, "on one another"):
            make_room(figure, Look(width=3), "a test")
        self.assertEqual(len(words.get_xticks()), 12)

    def test_are_saved_as_they_were_laid_out(self):
        """With large letters an axis has room for fewer numbers, also when it is drawn again to be saved."""
        figure = draw(self.records["runs"], None, Look(width=in_inches(140), font_size=13))
        before = [label.get_text() for axes in figure.axes for label in axes.get_xticklabels()]
        save(figure, self.folder / "large.png")
        self.assertEqual([label.get_text() for axes in figure.axes for label in axes.get_xticklabels()], before)


class WithoutRoom(WithRecords):
    def refused(self, arguments, *mentions):
        result = run(f"plot {arguments} -o new.png", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
        for mention in mentions:
            self.assertIn(mention, result.stderr)
        self.assertFalse((self.folder / "new.png").exists())

    def test_figures_are_refused(self):
        self.refused("orbit.h5 --width 60 --font-size 20", "width = 60 mm with letters of 20 points: a figure of kind orbit")
        self.refused("recurrence.h5 --width 100 --font-size 14", "words cut off or on one another")
        self.refused("recurrence.h5 --font-size 40", "letters of 40 points")  # its panels' shape is given: no side is left
        self.refused("orbit.h5 orbit.h5 orbit.h5 --width aps-2", "a figure of 3 records", "on a page")

    def test_several_records_in_a_column_are_no_higher_than_a_page(self):
        for name, kind, count, width in (("orbit", "orbit", 2, 178), ("spectrum", None, 3, 86), ("orbit", "spin", 3, 178)):
            figure = draw([self.records[name]] * count, kind, Look(width=in_inches(width)))
            self.assertLess(25.4 * figure.get_size_inches()[1], 297)
            self.assertEqual(faults(figure), [])

    def test_on_a_screen_they_may_be_higher(self):
        figure = draw([self.records["spectrum"]] * 4)
        self.assertGreater(25.4 * figure.get_size_inches()[1], 400)

    def test_long_names_in_a_legend_are_broken_into_lines(self):
        names = []
        for i in range(3):
            run(f"simulate --sides {6 + i} --alpha 0.31{i} --beta 0.52{i} --mu 0.54{i} --restitution 0.95{i} --collisions 400 "
                f"--quiet -o {self.folder}/long{i}.h5")
            names.append(self.folder / f"long{i}.h5")
        figure = draw(names, "section", Look(width=in_inches(86), font_size=10))
        self.assertEqual(faults(figure), [])
        labels = labels_of(figure)
        self.assertTrue(all("\n" in label for label in labels), labels)
        self.assertIn("3 orbits, 1,200 impacts", figure._suptitle.get_text())


if __name__ == "__main__":
    unittest.main()
