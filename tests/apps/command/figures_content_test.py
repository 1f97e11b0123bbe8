"""What figures show and leave out, and what they say of it: figures_content_test.py SWIRL ROOT"""

import itertools
import re
import unittest

import h5py

from driving import run, with_records
from drawn_records import labels_of
import figure_records
from swirl_figures import Look, caption, draw, open_record
from swirl_figures.spin import running_mean
from swirl_figures.style import MODE_COLOURS

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
SIDES = "--mu 0.5 --restitution 0.95 --transient 100 --collisions 100 --grid sides=3:6:4"
RECORDS = {"rolls": "simulate --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9 --time 60 --sample 0.05",
           "long-roll": "simulate --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.97 --time 900",
           "strikes": "simulate --sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --collisions 200",
           "line": "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:0.9:3 --runs 2 --transient 100 "
                   "--collisions 100",
           "sides1": f"sweep {SIDES} --alpha 0.4 --beta 0.5",
           "sides2": f"sweep {SIDES} --beta 0.5 --grid alpha=0.2:0.6:3",
           "sides3": f"sweep {SIDES} --grid beta=0.2:0.3:2 --grid alpha=0.2:0.6:3",
           "sides-tracked": f"sweep {SIDES} --alpha 0.4 --beta 0.5 --track",
           "sides-sampled": f"sweep {SIDES.replace('3:6:4', '3:6')} --beta 0.5 --grid alpha=0.2:0.6 --sample sobol:32",
           "shard": "sweep --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --grid alpha=0.4:0.5:4 --shard 1/2 --transient 100 "
                    "--collisions 100",
           "constant": f"spectrum {HEXAGON}",
           "continuum": "spectrum --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --observable x --transient 1000 "
                        "--collisions 2000",
           "two-sided": "spectrum --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --observable position "
                        "--transient 1000 --collisions 2000",
           "tour": "tour"}

COLUMN = Look(width=86 / 25.4, titles=False)


WithRecords = with_records(RECORDS, (0, 3))


class CutShort(WithRecords):
    """Of a long rest on the wall the beginning is shown: the panel and the caption say so."""

    def test_the_panel_and_the_caption_say_until_when(self):
        for name, kind, panels in (("rolls", "orbit", 1), ("rolls", "spin", 1), ("rolls", "contacts", 1), ("long-roll", "spin", 2)):
            for look in (Look(width=86 / 25.4, titles=False), Look(width=178 / 25.4)):
                figure = draw(self.records[name], kind, look)
                for axes in figure.axes[:panels]:
                    told = re.search(r"shown until \$\\omega_s t\$ = ([\d.]+) of ([\d.]+)$", axes.get_title())
                    self.assertTrue(told, (name, kind, axes.get_title()))
                    self.assertAlmostEqual(float(told[1]) / axes.get_xlim()[1], 1, delta=1e-3)
                    self.assertAlmostEqual(float(told[2]), open_record(self.records[name]).column("contacts", "t_end")[-1], delta=0.01)
                    self.assertIn(told[0], " ".join(look.notes))

    def mean_of(self, **options):
        axes = draw(self.records["rolls"], "spin", Look(**options)).axes[0]
        label = next(text.get_text() for text in axes.get_legend().get_texts() if "mean" in text.get_text())
        return label, float(label.split()[-1].replace("\N{MINUS SIGN}", "-")), axes.get_xlim()[1]

    def test_the_legends_mean_is_the_commands_also_where_the_rest_is_cut(self):
        label, mean, border = self.mean_of()
        said = open_record(self.records["rolls"]).attribute("result", "mean_S")
        times, means = running_mean(open_record(self.records["rolls"]))
        self.assertIn("at last", label)
        self.assertAlmostEqual(mean, said, delta=1e-3)
        self.assertGreater(abs(said - means[times <= border][-1]), 0.1)

    def test_of_a_range_it_is_that_at_its_end(self):
        label, mean, border = self.mean_of(xlim=(0, 10))
        times, means = running_mean(open_record(self.records["rolls"]))
        self.assertIn("at its end", label)
        self.assertAlmostEqual(mean, means[times <= border][-1], delta=1e-3)

    def test_a_range_that_is_asked_for_is_not_cut(self):
        look = Look(xlim=(0, 60))
        figure = draw(self.records["rolls"], "spin", look)
        self.assertEqual(figure.axes[0].get_xlim(), (0, 60))
        self.assertNotIn("shown until", figure.axes[0].get_title() + " ".join(look.notes))

    def test_the_command_writes_it_into_the_caption(self):
        said = r"shown until ω_s t = [\d.]+ of 60, the rest on the wall"
        result = run(f"plot {self.records['rolls']} --kind contacts -o cut.png --no-title --caption cut.txt --quiet", cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertRegex((self.folder / "cut.txt").read_text(), said)
        record, look = open_record(self.records["rolls"]), Look(titles=False)
        draw(record, "orbit", look)
        self.assertRegex(caption.text_of([record], ["orbit"], look), said)


class Marks(WithRecords):
    def test_events_do_not_hide_one_another(self):
        for look in (Look(), COLUMN, Look(xlim=(16.7, 16.8))):
            figure = draw(self.records["strikes"], "contacts", look)
            figure.draw_without_rendering()
            axes = figure.axes[0]
            events = [axes.transData.transform(line.get_xydata()) * 72 / figure.dpi for line in axes.get_lines()]
            self.assertEqual(labels_of(figure), ["landing", "strike"])
            self.assertEqual(len(events), 2)
            apart = abs(events[0][:, None] - events[1][None]).max(axis=2)
            self.assertGreater(apart.min(), 5, look)  # a mark's size

    def test_mean_spins_over_all_starts_have_no_modes_colour(self):
        axes = draw(self.records["line"]).axes[1]
        colours = {line.get_color() for line in axes.get_lines() if line.get_marker() == "o"}
        self.assertEqual(len(colours), 1)
        self.assertFalse(colours & set(MODE_COLOURS.values()))

    def test_persons_have_their_names(self):
        diagram, curves = self.folder / "names.h5", self.folder / "names-of-curves.h5"
        figure_records.write_bifurcation(diagram)
        figure_records.write_boundaries(curves)
        for file, kinds in ((diagram, {0: "neimark-sacker"}), (curves, {0: "chenciner", 1: "fold-neimark-sacker"})):
            with h5py.File(file, "r+") as record:
                for index, kind in kinds.items():
                    record["special/kind"][index] = kind
        look = Look()
        self.assertIn("Neimark–Sacker", labels_of(draw(diagram, None, look)))
        self.assertIn("Neimark–Sacker", look.notes[-1])
        labels = labels_of(draw(curves, None, look))
        self.assertTrue({"Neimark–Sacker", "CH: Chenciner", "LPNS: fold-Neimark–Sacker"} <= set(labels), labels)
        self.assertFalse(re.search("neimark|chenciner", " ".join(labels + look.notes)))


class Axes(WithRecords):
    def test_numbers_of_sides_are_whole(self):
        for name, look in itertools.product(("sides1", "sides2", "sides3", "sides-tracked", "sides-sampled"), (Look(), COLUMN)):
            figure = draw(self.records[name], None, look)
            figure.draw_without_rendering()
            seen = set()
            for axis in (axis for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)):
                if axis.get_label_text().startswith("$N$") or (axis.get_label_text() == "N"):
                    begin, end = sorted(axis.get_view_interval())
                    seen |= {float(tick.label1.get_text()) for tick in axis.get_major_ticks()
                             if tick.label1.get_text() and begin <= tick.get_loc() <= end}
            self.assertEqual(seen, {3, 4, 5, 6}, (name, look))

    def test_every_row_of_a_tour_is_whole(self):
        for look in (Look(), COLUMN):
            for axes in draw(self.records["tour"], None, look).axes[:2]:
                rows = axes.get_yticks()
                low, high = sorted(axes.get_ylim())
                self.assertTrue(low <= rows.min() - 0.5 and rows.max() + 0.5 <= high, (look, axes.get_ylim()))
                self.assertGreater(axes.get_ylim()[0], axes.get_ylim()[1])  # the first row is above

    def test_of_a_constant_no_axes_are_made_up(self):
        figure = draw(self.records["constant"])
        axes, = figure.axes
        self.assertEqual([text.get_text() for text in axes.texts], ["S is constant"])
        self.assertEqual((list(axes.get_xticks()), list(axes.get_yticks()), labels_of(figure)), ([], [], []))

    def test_a_spectrum_says_which_frequencies_it_leaves_out(self):
        for name in ("continuum", "two-sided"):
            frequency = open_record(self.records[name]).column("spectrum", "frequency")
            power = open_record(self.records[name]).column("spectrum", "power")
            for options in ({}, {"width": 86 / 25.4}, {"titles": False}):
                look = Look(**options)
                axes = draw(self.records[name], None, look).axes[0]
                begin, end = axes.get_xlim()
                self.assertLess(end, frequency[-1])
                self.assertGreaterEqual(power[(frequency >= begin) & (frequency <= end)].sum(), 0.999 * power.sum())
                self.assertEqual(axes.get_title("right"), f"99.9 % of the power; frequencies go up to {frequency[-1]:.4g}")
                self.assertRegex(look.notes[-1], rf"^Shown .* up to {end:.4g}, .* to {frequency[-1]:.4g}\.$")
            look = Look(xlim=(0, frequency[-1]))
            self.assertEqual(draw(self.records[name], None, look).axes[0].get_title("right"), "")
            self.assertNotIn("Shown", " ".join(look.notes))

    def test_a_spectrums_caption_says_so_where_the_figure_has_no_room(self):
        look = Look(width=50 / 25.4)
        self.assertEqual(draw(self.records["continuum"], None, look).axes[0].get_title("right"), "")
        self.assertIn("Shown are the frequencies up to", look.notes[-1])


class Refused(WithRecords):
    def test_a_shard_is_to_be_joined(self):
        result = run(f"plot {self.records['shard']} -o shard.png", cwd=self.folder)
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
        self.assertIn("is shard 1 of 2 of a sweep, which swirl join makes one record", result.stderr)
        self.assertFalse((self.folder / "shard.png").exists())


if __name__ == "__main__":
    unittest.main()
