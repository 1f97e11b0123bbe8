"""A figure for every record, and what may be chosen of it: figures_test.py SWIRL ROOT [--all]

The package draws in this process (one for each figure takes seconds to begin). --all: every kind in every format, and a
million points; with SWIRL_CONTACT_SHEET=FILE.png all of them on one sheet, to be looked at."""

import itertools
import json
import os
import re
import time
import unittest
import warnings
from types import SimpleNamespace

import numpy
from matplotlib.figure import Figure
from matplotlib.image import imread

from driving import InFolder, run
from drawn_records import ALL, CHAOTIC, HEXAGON, KINDS_OF, WithRecords, labels_of
import figure_records
from figure_faults import faults
from chosen import length_of
from swirl_figures import boundaries
from swirl_figures import KINDS, Look, RecordError, draw, kinds_of, open_record, save
from swirl_figures.thinning import apart, thinned
from swirl_figures.words import ordinal

#: Millimetres: a column, what is just wider, two columns; None: a screen.
WIDTHS = (86, 127, 140, 160, 178, 183, 190, None)
HEADS = {".png": b"\x89PNG\r\n", ".svg": b"<?xml", ".pdf": b"%PDF-"}
MOST_BYTES = 5_000_000


def contact_sheet(pictures, path, columns=5):
    rows = -(-len(pictures) // columns)
    figure = Figure(figsize=(5 * columns, 3.6 * rows), layout="constrained")
    for axes, picture in zip(figure.subplots(rows, columns).flat, pictures):
        axes.imshow(imread(picture), interpolation="antialiased")
        axes.set_title(picture.stem)
    for axes in figure.axes:
        axes.axis("off")
    figure.savefig(path, dpi=60)


class Names(WithRecords):
    def test_special_points_of_curves_are_named_where_names_do_not_lie_on_one_another(self):
        """Each that is not named lies beside one that is, of a kind that comes before or the same."""
        random = numpy.random.default_rng(1)
        crowd = SimpleNamespace(special={"alpha": random.uniform(0.1, 0.9, 300), "beta": random.uniform(0, 2, 300)},
                                special_kinds=list(random.choice(["flip-grazing", "cusp", "1:2"], 300)),
                                limits={"alpha": (0.1, 0.9), "beta": (0, 2)})
        points, named = boundaries._named(crowd, "alpha", "beta")
        self.assertEqual(len(points), 300)
        order = [["cusp", "1:2", "flip-grazing"].index(point[0]) for point in points]
        self.assertEqual(order, sorted(order))
        width, height = boundaries._NAME[0] * 0.8, boundaries._NAME[1] * 2
        for i, (_, x, y) in enumerate(points):
            near = [j for j in numpy.flatnonzero(named) if j < i and abs(points[j][1] - x) < width
                    and abs(points[j][2] - y) < height]
            self.assertEqual(bool(near), not named[i], points[i])
        self.assertGreater(sum(named), 100)


class EveryRecord(WithRecords):
    def test_has_its_kinds(self):
        for name, kinds in KINDS_OF.items():
            if name in self.records:
                self.assertEqual(kinds_of(self.records[name]), kinds, name)
        self.assertEqual({kind for kinds in KINDS_OF.values() for kind in kinds}, set(KINDS))

    def test_is_drawn_in_every_kind_with_room_in_columns_and_on_a_screen(self):
        """Each in one of the widths and in one of the formats, by turns; with --all in each width, and in a column and on a
        screen in each format."""
        widths, suffixes = itertools.cycle(WIDTHS), itertools.cycle(HEADS)
        for name, kinds in KINDS_OF.items():
            for kind in kinds if name in self.records else []:
                for width in WIDTHS if ALL else [next(widths)]:
                    every = HEADS if width in (86, None) else []
                    self.check(name, kind, width, every if ALL else [next(suffixes)])
        if ALL and "SWIRL_CONTACT_SHEET" in os.environ:
            contact_sheet(sorted(self.folder.glob("*-screen.png")), os.environ["SWIRL_CONTACT_SHEET"])

    def check(self, name, kind, width, suffixes):
        with warnings.catch_warnings():
            warnings.simplefilter("error")  # matplotlib's "constrained_layout not applied"
            figure = draw(self.records[name], kind, Look(width=width and width / 25.4, titles=width != 86))
        self.assertEqual(faults(figure), [], (name, kind, width))
        if width:
            across, down = 25.4 * figure.get_size_inches()
            self.assertAlmostEqual(across, width)
            self.assertLess(down, 297, (name, kind, width))  # a page
        for suffix in suffixes:
            file = self.folder / f"{name}-{kind}-{width or 'screen'}{suffix}"
            save(figure, file)
            content = file.read_bytes()
            self.assertTrue(content.startswith(HEADS[suffix]), file)
            self.assertTrue(5_000 < len(content) < MOST_BYTES, (file, len(content)))
            if suffix == ".png":
                pixels = (imread(file)[..., :3] * 255).astype(int)
                colours = numpy.unique(pixels @ [1 << 16, 1 << 8, 1])  # as one number: rows take seconds to sort
                self.assertGreater(len(colours), 20, file)


class WhatIsDrawn(WithRecords):
    """The curves are the record's numbers."""

    def test_the_parts_of_J_add_up(self):
        axes = draw(self.records["orbit"], "balance").axes[2]
        lines = {line.get_label(): line.get_ydata() for line in axes.get_lines()}
        restitution, friction, all_of_it = (next(values for label, values in lines.items() if label.startswith(word))
                                            for word in ("restitution", "friction", "all"))
        self.assertLess(abs(restitution + friction - all_of_it).max(), 1e-11)

    def test_forces_on_the_wall_are_those_of_its_motion(self):
        """m a = −λ n + f t, a from second differences of the samples' places."""
        record = open_record(self.records["wall"])
        t, x, y, spin, on_wall, normal, friction, slip = (
            record.column("samples", name)
            for name in ("t", "x", "y", "spin", "in_contact", "normal_force", "friction", "slip"))
        self.assertTrue(numpy.isnan(normal[on_wall == 0]).all())
        inner = numpy.flatnonzero(on_wall[:-2] & on_wall[1:-1] & on_wall[2:]) + 1
        self.assertGreater(len(inner), 30)
        step, (alpha, beta) = t[1] - t[0], (0.1, 0.05)
        place = x + 1j * y
        force = (place[inner + 1] - 2 * place[inner] + place[inner - 1]) / step**2
        n = place[inner] - beta * numpy.exp(1j * t[inner])
        n /= abs(n)
        smooth = numpy.abs(numpy.diff(friction[inner], prepend=friction[inner[0]])) < 0.01  # not where it starts to slip
        expected = (-normal[inner] + 1j * friction[inner]) * n
        self.assertLess(abs(force - expected)[smooth].max(), 50 * step**2)  # of fourth derivatives of some ten
        rolls = (friction**2 < (0.4 * normal) ** 2 * 0.98)[inner] & (abs(slip[inner]) < 1e-12)
        self.assertGreater(rolls.sum(), 10)
        slides = abs(slip[inner]) > 1e-6
        self.assertLess(abs(abs(friction[inner]) - 0.4 * normal[inner])[slides].max(), 1e-12)

    def test_a_portrait_has_the_coordinates_that_are_asked_for(self):
        axes = draw(self.records["orbit"], "section", Look(x="vn", y="vt")).axes[0]
        shown = axes.collections[0].get_offsets()
        record = open_record(self.records["orbit"])
        self.assertEqual(set(map(tuple, shown)), set(zip(record.column("collisions", "vn"), record.column("collisions", "vt"))))
        with self.assertRaisesRegex(RecordError, "coordinate = chi: .* disk"):
            draw(self.records["wall"], "section", Look(x="chi"))
        with self.assertRaisesRegex(RecordError, "coordinate = q: the section's are psi"):
            draw(self.records["wall"], "section", Look(x="q"))

    def test_the_verdict_shows_the_orbits_own_period(self):
        record = open_record(self.records["verdict"])
        points = record.column("tail", "points")
        self.assertEqual(points.shape, (2000, 5))
        self.assertEqual(record.attribute("tail", "first"), 1001)
        period = record.attribute("mode", "period")
        self.assertEqual(period, 8)
        self.assertLess(abs(points[period:] - points[:-period])[-1000:].max(), 1e-4)

    def test_the_verdict_on_a_series_shows_the_stretch_that_was_judged(self):
        record = open_record(self.records["measured"])
        judged = record.column("series", "value")[101:]
        self.assertEqual(record.attributes("mode/settings")["samples_used"], len(judged))
        portrait, values, spectrum = draw(self.records["measured"]).axes[:3]
        shown = portrait.collections[0].get_offsets()
        self.assertEqual(list(map(tuple, shown)), list(zip(judged[:-1], judged[1:])))
        line = values.get_lines()[0]
        self.assertEqual(list(line.get_ydata()), list(judged[:120]))
        self.assertAlmostEqual(line.get_xdata()[0], 10.1)
        strongest = spectrum.get_lines()[0].get_xdata()[spectrum.get_lines()[0].get_ydata().argmax()]
        self.assertAlmostEqual(strongest, 0.7 / (2 * numpy.pi), delta=1 / len(judged))

    def test_of_an_angle_whose_gap_was_bridged_the_longest_run_is_shown(self):
        """Named by letters of its own: a dollar sign is no formula."""
        file, record = self.folder / "bridged.csv", self.folder / "bridged.h5"
        angles = [f"{row / 10:.1f},{0.04 * row + numpy.sin(0.11 * row):.9f}\n" for row in range(600) if row != 3]
        file.write_text("t,$x_$\n" + "".join(angles))
        made = run(["classify", "--series", str(file), "--angle", "$x_$", "-o", str(record), "--quiet"])
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual(open_record(record).attributes("mode/settings")["samples_bridged"], 1)
        values = draw(record).axes[1].get_lines()[0]
        self.assertEqual((len(values.get_xdata()), round(values.get_xdata()[0], 6)), (120, 0.45))
        made = run(["classify", "--series", str(file), "--column", "$x_$", "-o", str(record), "--quiet", "--force"])
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual(draw(record).axes[1].get_ylabel(), r"\$x_\$")

    def test_crowded_special_points_are_thinned_and_counted(self):
        """A cycle's special point is one, in the legend as in the caption, at however many phases it is drawn."""
        for phases in (1, 3):
            file = self.folder / f"crowded{phases}.h5"  # a record stays open until its figure's leftovers are collected
            figure_records.write_crowded_special(file, 500, phases)
            look = Look()
            figure = draw(file, None, look)
            told = next(text for text in labels_of(figure) if text.startswith("flip"))
            drawn, all_of_them = map(int, re.fullmatch(r"flip \((\d+) of (\d+) drawn\)", told).groups())
            self.assertEqual(all_of_them, 500)
            markers = [line for line in figure.axes[0].get_lines() if line.get_marker() == "s"]
            self.assertEqual(sum(len(set(line.get_xdata())) for line in markers), drawn)
            self.assertLess(drawn, 100)
            self.assertIn(f"Special points, 500, of which {drawn} are drawn", look.notes[-1])

    def test_thinning(self):
        x = numpy.arange(1_000_000.0)
        y = numpy.sin(x * 1e-3)
        y[123_456] = 7
        few_x, few_y = thinned(x, y)
        self.assertLess(len(few_x), 10_000)
        self.assertEqual((few_y.max(), few_y.min(), few_x[0], few_x[-1]), (7, y.min(), x[0], x[-1]))
        self.assertTrue((y[few_x.astype(int)] == few_y).all())
        self.assertEqual(list(apart(numpy.array([0, 0.5, 2, 0]), numpy.array([0, 0.5, 2, 5]), 1, 1)),
                         [True, False, True, True])


class VectorFiles(WithRecords):
    """Of many panels: what exceeds the marks that a figure may have is an image in the file."""

    def bytes_of(self, figure, name):
        for suffix in (".svg", ".pdf"):
            save(figure, self.folder / f"{name}{suffix}")
            self.assertLess((self.folder / f"{name}{suffix}").stat().st_size, MOST_BYTES, name)

    def test_stay_small_with_many_panels(self):
        points, orbit = self.folder / "many-points.h5", self.folder / "many-impacts.h5"
        figure_records.write_sampled_sweep(points, ["alpha", "beta", "mu"], 20_000)
        run(f"simulate {CHAOTIC} --collisions 19999 --quiet -o {orbit}")
        self.bytes_of(draw(points), "points")
        if ALL:
            self.bytes_of(draw([orbit] * 4, "spin"), "spins")
            self.bytes_of(draw([orbit] * 8), "orbits")

    def test_of_few_marks_have_no_image(self):
        figure = draw([self.records["orbit"]] * 4, "spin")
        save(figure, self.folder / "few.svg")
        self.assertNotIn("<image", (self.folder / "few.svg").read_text())


class Options(WithRecords):
    def plot(self, arguments, code=0):
        result = run(f"plot {arguments}", cwd=self.folder)
        self.assertEqual(result.returncode, code, result.stderr)
        return result

    def test_what_is_chosen_is_drawn(self):
        from matplotlib.image import imread
        made = json.loads(self.plot("spectrum.h5 spectrum.h5 -o two.png --width 3.4in --font-size 7 --no-title --xlim 0:3 "
                                    "--json").stdout)
        self.assertEqual(made, {"figure": "two.png", "kind": "spectrum", "record": "spectrum.h5",
                                "records": ["spectrum.h5", "spectrum.h5"]})
        self.assertEqual(imread(self.folder / "two.png").shape[1], int(3.4 * 160))
        figure = draw([self.records["spectrum"]] * 2, None, Look(3.4, 7, False, (0, 3)))
        self.assertEqual([axes.get_xlim() for axes in figure.axes], [(0, 3)] * 2)
        self.assertEqual([axes.xaxis.label.get_fontsize() for axes in figure.axes], [7] * 2)
        self.assertEqual([part._suptitle for part in figure.subfigs], [None] * 2)
        letters = imread(self.folder / "two.png")[:30, :30, :3]  # (a), which no part of the figure covers
        self.assertLess(letters.min(), 0.3)
        self.assertIn("hexagon", draw(self.records["spectrum"])._suptitle.get_text())

    def test_several_orbits_share_a_portrait(self):
        other = self.folder / "other-orbit.h5"
        run(f"simulate {CHAOTIC.replace('0.3', '0.35')} --collisions 300 --quiet -o {other}")
        figure = draw([self.records["orbit"], other], "section")
        self.assertEqual([len(dots.get_offsets()) for dots in figure.axes[0].collections], [500, 300])
        self.assertEqual(labels_of(figure), ["α = 0.3", "α = 0.35"])

    def test_the_smaller_of_two_portraits_is_seen(self):
        """All of its dots, larger than those of the other and above them; also of a run that comes to rest on a cycle."""
        long, cycle = self.folder / "long-orbit.h5", self.folder / "cycle-orbit.h5"
        run(f"simulate {CHAOTIC} --collisions 120000 --quiet -o {long}")
        run(f"simulate {HEXAGON} --skip 20000 --collisions 70000 --quiet -o {cycle}")
        figure = draw([self.records["orbit"], long], "section")
        few, many = figure.axes[0].collections
        self.assertEqual((len(few.get_offsets()), len(many.get_offsets())), (500, 40000))
        self.assertGreater(few.get_sizes()[0], 10 * many.get_sizes()[0])
        self.assertGreater(few.get_zorder(), many.get_zorder())
        self.assertIn("(every 3rd impact)", labels_of(figure)[1])
        self.assertIn("2 orbits, 120,500 impacts", figure._suptitle.get_text())
        places, many = draw([cycle, long], "section").axes[0].collections
        self.assertGreater(places.get_sizes()[0], 10 * many.get_sizes()[0])
        self.assertEqual([ordinal(n) for n in (2, 3, 4, 11, 22, 113)], ["2nd", "3rd", "4th", "11th", "22nd", "113th"])

    def test_wrong_ones_are_one_line(self):
        before = sorted(self.folder.iterdir())
        for arguments, mentions in (("--width 10", "width = 10: allowed are 40 to 500 mm"), ("--width wide", "width = wide"),
                                    ("--width nan", "width = nan"), ("--font-size 1", "font-size = 1: allowed are 4 to 40"),
                                    ("--xlim 3:1", "xlim = 3:1: allowed is A:B"), ("--xlim 1", "xlim = 1"),
                                    ("--xlim 0:inf", "xlim = 0:inf"), ("--kind path --xlim 0:1", "no abscissa"),
                                    ("--x vn", "x = vn: a figure of kind orbit has no coordinates"),
                                    ("--kind spin --y psi", "y = psi: a figure of kind spin"),
                                    ("--kind section --x psi --y psi", "x = psi and y = psi"),
                                    ("--kind section --x S", "x = S and y = S")):
            result = self.plot(f"orbit.h5 -o new.png {arguments}", 2)
            self.assertIn(mentions, result.stderr)
            self.assertEqual(len(result.stderr.splitlines()), 1)
        self.assertIn("none.h5", self.plot("orbit.h5 none.h5 -o new.png", 2).stderr)
        self.assertIn("8", self.plot(" ".join(["orbit.h5"] * 9) + " -o new.png", 2).stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)


@unittest.skipUnless(ALL, "nightly")
class AMillionPoints(InFolder):
    def test_take_less_than_five_seconds_and_five_megabytes(self):
        record = self.folder / "million.h5"
        self.assertEqual(run(f"simulate {CHAOTIC} --collisions 1000000 --quiet -o {record}").returncode, 0)
        draw(record, "path")  # imports, fonts
        for kind in kinds_of(record):
            for suffix in HEADS:
                begin = time.monotonic()
                save(draw(record, kind), self.folder / f"figure{suffix}")
                seconds = time.monotonic() - begin
                size = (self.folder / f"figure{suffix}").stat().st_size
                print(f"{kind}{suffix}: {seconds:.1f} s, {size / 1e6:.2f} MB")
                self.assertLess(seconds, 5, kind)
                self.assertLess(size, MOST_BYTES, kind)


if __name__ == "__main__":
    unittest.main()
