"""plot --xlim: what is drawn of a part of a record is that part, as it is. figures_ranges_test.py SWIRL ROOT"""

import re
import tempfile
import unittest
from pathlib import Path

import numpy

from driving import run, with_records
from drawn_records import CHAOTIC, HEXAGON, labels_of
import figure_records
from swirl_figures import Look, RecordError, draw, open_record
from swirl_figures.ranges import clipped

RECORDS = {"long": f"simulate {CHAOTIC} --collisions 40000",
           "wall": "simulate --sides disk --alpha 0.1 --beta 0.05 --mu 0.4 --restitution 0.3 --time 60 --sample 0.02",
           "rests": "simulate --sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --collisions 200",
           "spectrum": f"spectrum {HEXAGON} --transient 1000 --collisions 2000",
           "exponents": f"lyapunov {HEXAGON} --transient 100 --collisions 2000",
           "tradeoff": f"tradeoff {HEXAGON} --budget 0.3",
           "driven": "bifurcate --sides 6 --law newton --beta 0.1 --mu 0.5 --restitution 1 --along alpha=0.2:0.8:4 --starts 1"}


def line(axes, label):
    return next(line for line in axes.get_lines() if line.get_label().startswith(label)).get_xydata()


class WithRecords(with_records(RECORDS, (0, 3))):
    @classmethod
    def add_records(cls, folder):
        cls.records.update({name: folder / f"{name}.h5" for name in ("diagram", "curves")})
        figure_records.write_bifurcation(cls.records["diagram"])
        figure_records.write_boundaries(cls.records["curves"])

    def draw(self, name, kind, least, most, **options):
        return draw(self.records[name], kind, Look(xlim=(least, most), **options))


class Refused(WithRecords):
    def test_a_logarithmic_abscissa_has_nothing_at_zero(self):
        self.draw("exponents", "lyapunov", 10, 100)
        for least in (0, -1):
            with self.assertRaisesRegex(RecordError, f"xlim = {least}:100: the abscissa is logarithmic"):
                self.draw("exponents", "lyapunov", least, 100)

    def test_three_abscissas_have_no_range_in_common(self):
        with self.assertRaisesRegex(RecordError, "a figure of kind tradeoff has no abscissa to limit"):
            self.draw("tradeoff", "tradeoff", 1e-7, 1e-6)

    def test_a_range_that_no_page_can_show_is_told_at_once(self):
        out = self.records["wall"].with_name("f.png")
        for text, said in (("-1e308:1e308", "two numbers from -1e+15 to 1e+15 with A < B"), ("nan:1", "with A < B"),
                           ("2:1", "with A < B"), ("1:1.0000000000000002", "B - A is 2.2e-16, allowed is 1e-09 or more"),
                           ("1000:1000.000123", "xlim = 1000:1000.000123: ")):
            done = run(f"plot {self.records['wall']} --xlim={text} --quiet -o {out}")
            self.assertEqual((done.returncode, done.stderr.count("\n"), out.exists()), (2, 1, False), done.stderr)
            self.assertIn(said, done.stderr)
        self.draw("wall", None, 0, 1e15)
        done = run(f"plot {self.records['wall']} --xlim=-1e15:1e15 --quiet -o {out}")
        self.assertEqual((done.returncode, done.stderr), (0, ""))


class EndedEarly(unittest.TestCase):
    def test_the_end_of_its_orbit_is_why_a_record_has_no_figure(self):
        scene = "--sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --collisions 100 --quiet"
        with tempfile.TemporaryDirectory() as folder:
            for command in ("spectrum", "lyapunov"):
                record = Path(folder) / f"{command}.h5"
                self.assertEqual(run(f"{command} {scene} -o {record}").returncode, 3)
                said = "its orbit ended \\(in-contact\\) before there was enough of it"
                with self.assertRaisesRegex(RecordError, said):
                    draw(record)
                other = {"spectrum": f"notebook {record} -o {folder}/f.ipynb", "lyapunov": f"plot {record} -o {folder}/f.png"}
                done = run(other[command])
                self.assertEqual(done.returncode, 2)
                self.assertRegex(done.stderr, f"^[^\n]*{said}\n$")


class OfALongOrbit(WithRecords):
    def columns(self, *names):
        record = open_record(self.records["long"])
        return [record.column("collisions", name) for name in names]

    def test_J_and_its_changes_are_those_of_every_impact(self):
        t, energy, friction = self.columns("t", "jacobi", "jacobi_friction")
        above, middle, below = self.draw("long", "balance", 500, 700).axes
        shown = (t >= 500) & (t <= 700)
        drawn = above.get_lines()[0].get_xydata()
        inside = (drawn[:, 0] >= 500) & (drawn[:, 0] <= 700)
        numpy.testing.assert_array_equal(drawn[inside], numpy.column_stack([t, energy])[shown])
        self.assertTrue(drawn[0, 0] < 500 and drawn[-1, 0] > 700)  # lines lead to both borders
        self.assertIn(shown.sum(), [len(dots.get_offsets()) for dots in middle.collections])
        sums = line(below, "friction")
        self.assertAlmostEqual(sums[-1, 1], (numpy.cumsum(friction) - friction[0])[t <= sums[-1, 0]][-1])
        self.assertLess(numpy.ptp(below.get_ylim()), 3 * numpy.ptp([v for l in below.get_lines() for v in l.get_ydata()]))

    def test_few_impacts_are_steps(self):
        t, spin = self.columns("t", "spin")
        figure = self.draw("long", "spin", 1000, 1100)
        self.assertEqual(len(figure.axes), 1)
        steps = line(figure.axes[0], "S")
        shown = (t >= 1000) & (t <= 1100)
        self.assertTrue(set(t[shown]) <= set(steps[:, 0]))
        self.assertTrue(set(spin[shown].round(9)) <= set(steps[:, 1].round(9)))
        self.assertEqual(figure.axes[0].get_title(), f"Spin, {shown.sum()} of 40,000 impacts")

    def test_the_running_mean_has_every_value_of_the_range(self):
        t, angle = self.columns("t", "angle")
        for kind in ("spin", "orbit"):
            mean = line(self.draw("long", kind, 1000, 3000).axes[0], "running time mean")
            shown = (t >= 1000) & (t <= 3000)
            inside = (mean[:, 0] >= 1000) & (mean[:, 0] <= 3000)
            numpy.testing.assert_array_equal(mean[inside, 0], t[shown])
            numpy.testing.assert_allclose(mean[inside, 1], ((angle - angle[0])[shown]) / (t - t[0])[shown])

    def test_many_impacts_are_dots_and_the_last_of_them_steps(self):
        t, = self.columns("t")
        above, below = self.draw("long", "spin", 1000, 2000).axes
        self.assertEqual(len(above.collections[0].get_offsets()), ((t >= 1000) & (t <= 2000)).sum())
        self.assertEqual(below.get_title(), "The last 100 of these impacts")
        begin, end = below.get_xlim()
        self.assertTrue(1000 < begin < end < 2010, (begin, end))

    def test_cells_are_those_of_the_range(self):
        cells = self.draw("long", "spin", 1000, 40000).axes[0].collections[0]  # over 20,000 impacts: no dots
        across = cells.get_coordinates()[0, :, 0]
        self.assertTrue(1000 <= across[0] and across[-1] <= 40000)

    def test_a_portrait_has_the_impacts_of_the_range(self):
        psi, spin = self.columns("psi", "spin")
        figure = self.draw("long", "section", 0.5, 0.6)
        shown = (psi >= 0.5) & (psi <= 0.6)
        self.assertEqual(set(map(tuple, figure.axes[0].collections[0].get_offsets())), set(zip(psi[shown], spin[shown])))
        self.assertIn(f"{shown.sum():,} of 40,000 impacts", figure._suptitle.get_text())

    def test_where_there_is_nothing_it_is_said(self):
        for name, kind, least, most, words in (("long", "spin", 1e7, 2e7, "no impact there; there are some from"),
                                               ("long", "balance", 1e7, 2e7, "no impact there"),
                                               ("long", "section", 4, 5, "no impact there"),
                                               ("wall", "contacts", 0, 5, "no contact with the wall there"),
                                               ("diagram", None, 5, 6, "no point there"),
                                               ("curves", None, 50, 60, "nothing to draw there"),
                                               ("spectrum", None, 1e4, 2e4, "no frequency there")):
            with self.assertRaisesRegex(RecordError, words):
                self.draw(name, kind, least, most)


class OnTheWall(WithRecords):
    def test_the_whole_cone_of_friction_is_seen(self):
        """|f| ≤ μ λ, also its lower half, along which friction runs where the body slides."""
        for options in ({}, {"xlim": (49.7, 50.2)}):
            axes = draw(self.records["wall"], "contacts", Look(**options)).axes[2]
            band = axes.collections[0].get_paths()[0].vertices
            begin, end = options.get("xlim", (49.42, 50.4))
            heights = band[(band[:, 0] >= begin) & (band[:, 0] <= end), 1]
            bottom, top = axes.get_ylim()
            self.assertTrue(bottom < heights.min() < 0 < heights.max() < top, options)
            self.assertLess(top - bottom, 5 * numpy.ptp(heights))

    def test_spin_at_rest_is_drawn_without_an_impact(self):
        figure = self.draw("rests", "spin", 200, 300)
        self.assertEqual(figure.axes[0].get_title(), "Spin, 0 of 85 impacts")
        self.assertTrue(figure.axes[0].collections)


class OfOtherKinds(WithRecords):
    def test_of_a_diagram_ordinates_legend_and_caption_are_those_of_the_range(self):
        look = Look(xlim=(2.65, 2.95))  # of the logistic map: one stable fixed point
        figure = draw(self.records["diagram"], None, look)
        bottom, top = figure.axes[0].get_ylim()
        self.assertTrue(-0.7 < bottom < top < -0.6, (bottom, top))
        labels = labels_of(figure)
        self.assertIn("period 1", labels)
        self.assertFalse({"period 2", "unstable", "flip", "fold", "border"} & set(labels), labels)
        self.assertIn("Special points with alpha from 2.65 to 2.95, 0, of which 0", look.notes[-1])
        look = Look(xlim=(2.9, 3.1))
        self.assertTrue({"period 1", "period 2", "flip", "unstable"} <= set(labels_of(draw(self.records["diagram"], None, look))))
        self.assertEqual(re.findall(r"flip|fold|border", look.notes[-1]), ["flip"])

    def test_branches_end_at_the_borders(self):
        there_and_back = numpy.array([[0.0, 0], [4, 4], [0, 8]])
        pieces = clipped(there_and_back, (1, 3))
        self.assertEqual([piece.tolist() for piece in pieces], [[[1, 1], [3, 3]], [[3, 5], [1, 7]]])
        self.assertEqual([piece.tolist() for piece in clipped(there_and_back, (1, 5))], [[[1, 1], [4, 4], [1, 7]]])
        self.assertEqual(clipped(there_and_back, (5, 6)), [])

    def test_of_curves_the_legend_lists_those_of_the_range(self):
        labels = labels_of(self.draw("curves", None, 3.2, 3.9))
        self.assertEqual(labels, ["flip", "period 2"])

    def test_of_a_spectrum_the_legend_counts_the_peaks_of_the_range(self):
        place = open_record(self.records["spectrum"]).column("peaks", "frequency")
        middle = float(numpy.median(place))
        counts = re.findall(r"\((\d+)\)", " ".join(labels_of(self.draw("spectrum", None, middle, 10 * place.max()))))
        self.assertEqual(sum(map(int, counts)), (place >= middle).sum())

    def test_orbits_that_are_driven_away_do_not_stretch_the_ordinate(self):
        record = open_record(self.records["driven"])
        spin, kinds = record.column("samples", "S"), record.names("attractors", "kind")
        driven = numpy.isin(record.column("samples", "column"), record.column("attractors", "column")[kinds == "accelerated"])
        figure = draw(self.records["driven"])
        bottom, top = figure.axes[0].get_ylim()
        self.assertGreater(abs(spin[driven]).max(), 100 * max(-bottom, top))
        self.assertTrue(bottom < spin[~driven].min() and spin[~driven].max() < top)
        outside = int(((spin < bottom) | (spin > top)).sum())
        told = " ".join(text.get_text() for text in figure.axes[0].texts)
        self.assertIn("points lie outside", told)
        self.assertLessEqual(outside, int(told.split(" of ")[0].replace(",", "")))


if __name__ == "__main__":
    unittest.main()
