"""Shades, seams and room: what is darker has more, colours are apart in grey, cells have no gaps, legends leave room.

figures_shades_test.py SWIRL ROOT"""

import re
import subprocess
import unittest

import h5py
import numpy
from matplotlib.colors import to_rgb
from matplotlib.image import imread

from driving import InFolder, folder_of_module, made_records
from drawn_records import labels_of
import figure_records
from swirl_figures import Look, boundaries, draw, open_record, save
from swirl_figures.style import DOTS_PER_INCH, MODE_COLOURS
from swirl_figures.verdict_panels import power_of

CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
RECORDS = {"fall": "bifurcate --sides 6 --alpha 0.3 --beta 0.1 --restitution 1 --along mu=0:1:6 --collisions 4000 --exhaustive",
           "cycle": f"recurrence {CYCLE}", "verdict": f"classify {CYCLE} --transient 1000 --collisions 2003 --exhaustive"}


def lightness(colour):
    """CIE L* of an sRGB colour, as a printer without ink of other colours shows it."""
    linear = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in to_rgb(colour)]
    luminance = 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    return 116 * luminance ** (1 / 3) - 16 if luminance > 0.008856 else 903.3 * luminance


class InGrey(unittest.TestCase):
    def test_steady_and_chaotic_are_apart(self):
        shades = {mode: lightness(colour) for mode, colour in MODE_COLOURS.items()}
        self.assertGreaterEqual(abs(shades["steady"] - shades["chaotic"]), 25)
        rising = sorted(shades.values())
        self.assertGreater(min(numpy.diff(rising)), 10, shades)


class Diagram(InFolder):
    def test_is_darker_where_it_has_more_samples(self):
        """Of S = u², u even in 0 to 1: the density is 1/(2 √S)."""
        record = self.folder / "record.h5"
        figure_records.write_columns(record, 400, spin=numpy.linspace(0, 1, 2000) ** 2)
        figure = draw(record)
        save(figure, self.folder / "density.png")
        figure.set_dpi(DOTS_PER_INCH)
        pixels = imread(self.folder / "density.png")[..., 0]
        shades = []
        for spin in (0.02, 0.15, 0.4, 0.8):
            across, up = figure.axes[0].transData.transform((0.5, spin)).round().astype(int)
            shades.append(pixels[len(pixels) - up - 4:len(pixels) - up + 4, across - 50:across + 50].mean())
        self.assertTrue(all(before < after - 0.02 for before, after in zip(shades, shades[1:])), shades)
        self.assertLess(shades[-1], 0.95)

    def test_shows_mean_spin_fall_with_friction(self):
        """Sun 2019: positive without friction, negative with it; here from +1.1 to −0.07 by time (e = 1, α = 0.3, β = 0.1)."""
        figure = draw(RECORDS["fall"])
        line = max((line for line in figure.axes[0].get_lines() if line.get_color() == "#222222"), key=lambda line: len(line.get_xdata()))
        mean = line.get_ydata()
        self.assertEqual(len(mean), 6)
        self.assertAlmostEqual(mean[0], 1.1, delta=0.15)    # three standard errors of 16,000 impacts
        self.assertAlmostEqual(mean[-1], -0.07, delta=0.1)
        bottom, top = figure.axes[0].get_ylim()
        self.assertGreater((mean[0] - mean[-1]) / (top - bottom), 0.08)
        self.assertTrue(any(label.startswith(r"mean spin $\langle S \rangle$ by time") for label in labels_of(figure)))


class Seams(InFolder):
    def rendered(self, figure, dots):
        """The pixels within each panel of the PDF but for its frame."""
        save(figure, self.folder / "cells.pdf")
        subprocess.run(["pdftoppm", "-r", str(dots), "-png", "-singlefile", "cells.pdf", "cells"], cwd=self.folder, check=True)
        pixels = imread(self.folder / "cells.png")[..., :3]
        height, width = pixels.shape[:2]
        for axes in figure.axes:
            if axes.get_label() != "<colorbar>":
                (x0, y0), (x1, y1) = axes.bbox.get_points() / figure.bbox.get_points()[1] * (width, height)
                yield axes, pixels[height - int(y1) + 6:height - int(y0) - 6, int(x0) + 6:int(x1) - 6]

    def test_are_not_seen_between_cells_of_one_colour(self):
        """Of maps and of bands, at two sizes on a screen."""
        for shape, width in (((23, 17), 86 / 25.4), ((80,), None)):
            record = self.folder / "grid.h5"
            figure_records.write_grid(record, shape)
            figure = draw(record, None, Look(width=width))
            for dots in (72, 110):
                for axes, pixels in list(self.rendered(figure, dots))[:1 if len(shape) == 1 else None]:
                    spread = pixels.max(axis=(0, 1)) - pixels.min(axis=(0, 1))
                    self.assertLess(spread.max(), 0.02, (shape, dots, axes.get_title()))

    def test_would_be_seen_if_cells_only_touched(self):
        figure_records.write_grid(self.folder / "grid.h5", (23, 17))
        figure = draw(self.folder / "grid.h5")
        for axes in figure.axes[:2]:
            for mesh in axes.collections:
                mesh.set_rasterized(False)
        spread = max((pixels.max(axis=(0, 1)) - pixels.min(axis=(0, 1))).max() for _, pixels in self.rendered(figure, 110))
        self.assertGreater(spread, 0.05)


class Boundaries(InFolder):
    def test_legend_takes_a_third_of_a_column_at_most(self):
        for count in (4, 9, len(boundaries._SHORT)):
            record = self.folder / f"curves{count}.h5"
            figure_records.write_boundaries(record)
            with h5py.File(record, "r+") as file:
                del file["special"]
                group = file.create_group("special")
                figure_records._dimension(group, "special_point", count)
                figure_records._write(group, "kind", ["special_point"], list(boundaries._SHORT)[:count])
                for name, low, high in (("first", -1, 4), ("second", -1, 1)):
                    figure_records._write(group, name, ["special_point"], numpy.linspace(low, high, count))
            look = Look(width=86 / 25.4)
            figure = draw(record, None, look)
            figure.draw_without_rendering()
            strip = figure.subfigs[1]
            self.assertLessEqual(strip.bbox.height / figure.bbox.height, 1 / 3 + 1e-9, count)
            words = " ".join([*labels_of(figure), *(text.get_text() for text in strip.texts), *look.notes]).replace("\n", " ")
            for letters, kind in zip(boundaries._SHORT.values(), list(boundaries._SHORT)[:count]):
                self.assertRegex(words, rf"\b{re.escape(letters)}[:\s]")
                self.assertIn(kind.split("-")[0].replace("neimark", "Neimark").replace("chenciner", "Chenciner"), words)


class OfACycle(unittest.TestCase):
    def test_lengths_of_lines_are_whole_numbers_and_end_with_the_longest(self):
        figure = draw(RECORDS["cycle"])
        figure.draw_without_rendering()
        axes = next(axes for axes in figure.axes if axes.get_xlabel() == "length of a line")
        begin, end = axes.get_xlim()
        labels = [tick.label1.get_text().replace(",", "") for tick in axes.xaxis.get_major_ticks() if begin <= tick.get_loc() <= end]
        self.assertTrue(all(label.isdigit() and int(label) > 0 for label in labels), labels)
        self.assertGreater(len(labels), 2)
        longest = open_record(RECORDS["cycle"]).column("recurrence", "Lmax")[0]
        self.assertTrue(0.5 < begin <= 1 and longest <= end < 1.5 * longest, (begin, end, longest))

    def test_the_verdicts_spectrum_has_its_harmonics_and_nothing_else(self):
        record = open_record(RECORDS["verdict"])
        names = [str(name) for name in record.names("tail", "coordinate")]
        spin = record.column("tail", "points")[:, names.index("S")]
        frequency, power = power_of(spin, 8)
        lines = power > 1e-12 * power.max()  # what is left of the way to the cycle, 0.8952 every 8 impacts after 1,000
        numpy.testing.assert_allclose(frequency[lines], [1 / 8, 2 / 8, 3 / 8, 4 / 8])
        drawn = draw(record).axes[2]
        self.assertEqual(drawn.get_title(), f"Spectrum, {len(spin) // 8} periods")
        numpy.testing.assert_array_equal(drawn.get_lines()[0].get_xdata(), frequency)


def setUpModule():
    RECORDS.update(made_records(RECORDS, folder_of_module()))


if __name__ == "__main__":
    unittest.main()
