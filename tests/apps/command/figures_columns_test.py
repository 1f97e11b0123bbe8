"""Attractors across a parameter: columns of samples, and attractors that were followed. figures_columns_test.py SWIRL ROOT"""

import base64
import io
import itertools
import re
import struct
import unittest
import zlib
from collections import Counter

import h5py
import numpy
from matplotlib.collections import PathCollection
from matplotlib.image import imread

from driving import InFolder
from drawn_records import labels_of
import figure_records
from swirl_figures import Look, draw, save
from swirl_figures.style import DOTS_PER_INCH


def images_in(file):
    """The opacity of each image in a vector file, rows from above."""
    content = file.read_bytes()
    if file.suffix == ".svg":
        return [imread(io.BytesIO(base64.b64decode(image)), format="png")[..., 3]
                for image in re.findall(rb'href="data:image/png;base64,([^"]*)"', content)]
    masks = []
    for found in re.finditer(rb"obj\s*<<((?:(?!endobj).)*?/ColorSpace /DeviceGray(?:(?!endobj).)*?)>>\s*stream\r?\n", content, re.S):
        width, height, length = (_number_in(found.group(1), name, content) for name in (b"Width", b"Height", b"Length"))
        masks.append(_picture(width, height, content[found.end():found.end() + length]))
    return masks


def _number_in(words, name, content):
    """Of a PDF's dictionary, where it may be another object."""
    number, other = re.search(rb"/" + name + rb" (\d+)( 0 R)?", words).groups()
    return int(re.search(rb"\n" + number + rb" 0 obj\s*(\d+)", content).group(1) if other else number)


def _picture(width, height, data):
    """A PDF's compressed pixels are those of a PNG."""
    def chunk(kind, words):
        return struct.pack(">I", len(words)) + kind + words + struct.pack(">I", zlib.crc32(kind + words))
    head = struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return imread(io.BytesIO(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head) + chunk(b"IDAT", data) + chunk(b"IEND", b"")), format="png")


class Columns(InFolder):
    """Of a bifurcation diagram: samples that fill S from 0 to 1 in columns side by side."""
    WIDTHS = (60, 86, 178, None, 500)

    def setUp(self):
        super().setUp()
        self.record = self.folder / "record.h5"

    def filled(self, width):
        """In a .png: how much of each column of pixels is not white, of those from the first column of samples to the last
        and from S = 0.05 to 0.95."""
        figure = draw(self.record, None, Look(width=width and width / 25.4))
        save(figure, self.folder / "columns.png")
        figure.set_dpi(DOTS_PER_INCH)
        (left, bottom), (right, top) = figure.axes[0].transData.transform([(0.1, 0.05), (0.9, 0.95)]).round().astype(int)
        pixels = imread(self.folder / "columns.png")[..., :3].min(axis=2)
        return (pixels[len(pixels) - top:len(pixels) - bottom, left:right] < 0.9).mean(axis=0)

    def test_leave_no_gap_at_any_width(self):
        figure_records.write_columns(self.record, 400)
        for width in self.WIDTHS:
            self.assertEqual(self.filled(width).min(), 1, width)

    def test_windows_are_seen_as_wide_as_they_are(self):
        figure_records.write_columns(self.record, 400, empty=(100, 250, 251))
        for width in self.WIDTHS[2:]:
            filled = self.filled(width)
            blank = numpy.flatnonzero(filled == 0)
            self.assertEqual(len(blank) + (filled == 1).sum(), len(filled), width)
            runs = numpy.split(blank, numpy.flatnonzero(numpy.diff(blank) > 1) + 1)
            self.assertEqual(len(runs), 2, width)
            for pixels, (place, count) in zip(runs, ((100, 1), (250.5, 2))):
                self.assertAlmostEqual(pixels.mean() / len(filled), place / 399, delta=0.003)
                self.assertAlmostEqual(len(pixels), count / 399 * len(filled), delta=1)

    def test_leave_no_gap_in_vector_files(self):
        figure_records.write_columns(self.record, 400)
        for width, suffix in itertools.product((86, 500), (".svg", ".pdf")):
            file = self.folder / f"columns{suffix}"
            save(draw(self.record, None, Look(width=width / 25.4)), file)
            images = images_in(file)
            self.assertEqual(len(images), 1, file)
            rows = numpy.flatnonzero(images[0].max(axis=1) > 0)
            within = images[0][rows[0] + 5:rows[-1] - 5] > 0.9
            columns = numpy.flatnonzero(within.any(axis=0))
            self.assertGreater(len(columns), 0.8 * width / 25.4 * DOTS_PER_INCH * 0.8)
            self.assertTrue(within[:, columns[0] + 1:columns[-1]].all(), (width, suffix))

    def test_far_apart_are_dots(self):
        figure_records.write_columns(self.record, 21)
        axes = draw(self.record).axes[0]
        self.assertEqual((len(axes.images), len(axes.collections[0].get_offsets())), (0, 21 * 500))

    def test_of_other_origins_lie_above(self):
        figure_records.write_columns(self.record, 400)
        with h5py.File(self.record, "r+") as record:
            record["samples/origin"][:] = numpy.repeat([0, 2], 100_000)
        figure = draw(self.record)
        self.assertEqual(labels_of(figure), ["random starts (darker: more)", "followed down (darker: more)"])
        picture = figure.axes[0].images[0].get_array()
        above, below = picture[picture.shape[0] // 2, [5, -5]].astype(int)
        self.assertEqual((len(set(above[:3])), above[3]), (1, 255))  # grey
        self.assertTrue(below[0] > below[1] > below[2] and below[3] == 255, below)  # orange


def dots_in(axes):
    return [dots for dots in axes.collections if isinstance(dots, PathCollection)]


class Tracks(InFolder):
    def setUp(self):
        super().setUp()
        self.record = self.folder / "record.h5"
        figure_records.write_tracks(self.record)

    def test_shares_that_are_drawn_of_a_cell_add_up_to_1(self):
        look = Look()
        figure = draw(self.record, "attractors", look)
        total, places = Counter(), Counter()
        for dots in dots_in(figure.axes[0]):
            for (x, y), size in zip(dots.get_offsets(), dots.get_sizes(), strict=True):
                total[x] += y
                places[x, round(y, 6), size] += 1
        self.assertEqual({x: round(share, 12) for x, share in total.items()}, {0.4: 1, 0.45: 1, 0.5: 1})
        self.assertEqual(max(places.values()), 1)  # of equal shares one is seen about the other
        self.assertEqual(labels_of(figure)[-1], "no attractor by the verdict: not followed")
        self.assertIn("not followed      2        0.25  0.6667", look.notes[-1])

    def test_what_was_not_followed_is_grey_and_joined_to_nothing(self):
        axes = draw(self.record, "attractors").axes[0]
        rings = [dots for dots in dots_in(axes) if tuple(dots.get_facecolor()[0]) == (1, 1, 1, 1)]
        self.assertEqual([sorted(map(tuple, ring.get_offsets())) for ring in rings],
                         [[(0.4, 2 / 3), (0.5, 1 / 4), (0.5, 1 / 4)]])
        self.assertEqual(len([line for line in axes.get_lines() if len(line.get_xdata()) == 2]), 2)

    def test_the_legend_is_silent_where_all_were_followed(self):
        with h5py.File(self.record, "r+") as record:
            record["attractors/track"][:] = [0, 1, 3, 0, 2, 2, 4, 5]
        self.assertNotIn("not followed", " ".join(labels_of(draw(self.record, "attractors"))))


if __name__ == "__main__":
    unittest.main()
