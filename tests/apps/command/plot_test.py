"""swirl plot, from outside, and the package behind it: plot_test.py SWIRL ROOT"""

import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import numpy

from driving import SWIRL, examples_of, run, start, with_records

ROOT = str(Path(sys.argv.pop(1)).resolve())
sys.path.insert(0, str(Path(ROOT) / "notebooks-export"))

import figure_records
from swirl_figures import Look, draw, kinds_of, open_record, physical, save
from swirl_figures.flights import flights_of
from swirl_figures.path import FRAMES, sample, stays
from swirl_figures.spin import running_mean, spin_on_wall

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
RECORDS = {
    "steps": f"simulate {STEADY} --collisions 60",
    "chaotic": "simulate --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --collisions 2000",
    "every": "simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 1000 --every 10",
    "contact": "simulate --sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5 --collisions 200",
    "sampled": "simulate --sides disk --alpha 0.1 --beta 0.05 --mu 0.4 --restitution 0.3 --time 60 --sample 0.05",
    "single": f"simulate {STEADY} --collisions 1",
    "sweep1": "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.8:0.1:4 --runs 2",
    "sweep2": "sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:5 --grid beta=0.1:0.9:4 --runs 2",
    "point": "sweep --sides 6 --beta 0.5 --restitution 0.9 --grid mu=0.5:0.5:1 --grid alpha=0.4:0.4:1",
}
SHORT = " --transient 100 --collisions 100"
COMMANDS = {name: command + (SHORT if command.startswith("sweep") else "") for name, command in RECORDS.items()}
HEADS = {"png": b"\x89PNG\r\n", "svg": b"<?xml", "pdf": b"%PDF-"}


class WithRecords(with_records(COMMANDS, (0, 3))):
    """The records of all kinds."""

    @classmethod
    def add_records(cls, folder):
        for name, groups in (("continue", ["branches", "special"]), ("both", ["samples", "branches", "special"])):
            cls.records[name] = folder / f"{name}.h5"
            figure_records.write_bifurcation(cls.records[name], groups)
        cls.records["orbits"] = folder / "orbits.h5"
        figure_records.write_orbits(cls.records["orbits"], 4, 1.3)


class Figures(WithRecords):
    def draw(self, name, suffix):
        figure = self.folder / f"{name}.{suffix}"
        save(draw(self.records[name]), figure)  # as `swirl plot` does; a process for each takes seconds to begin
        content = figure.read_bytes()
        self.assertTrue(content.startswith(HEADS[suffix]), figure)
        self.assertGreater(len(content), 8_000, figure)
        return figure

    def test_every_kind_of_a_record_is_drawn(self):
        for name, kinds in (("chaotic", ["orbit", "spin", "path", "section", "balance", "energy"]), ("sweep2", ["modes", "means", "map"]), ("both", ["bifurcation"]),
                            ("orbits", ["multipliers"])):
            self.assertEqual(kinds_of(self.records[name]), kinds)
        result = run(f"plot {self.records['chaotic']} -o {self.folder}/kind.png --kind spin --json")
        self.assertEqual(json.loads(result.stdout)["kind"], "spin", result.stderr)

    def test_equal_records_give_equal_figures(self):
        for suffix in HEADS:  # from two processes: the command and this one
            here, there = self.draw("sweep1", suffix), self.folder / f"command.{suffix}"
            run(f"plot {self.records['sweep1']} -o {there} --quiet")
            self.assertEqual(here.read_bytes(), there.read_bytes(), suffix)

    def test_titles_and_axes_have_symbols(self):
        def texts(figure):
            found = [figure._suptitle.get_text()]
            for axes in figure.axes:
                found += [axes.get_xlabel(), axes.get_ylabel(), axes.get_title()]
            return " ".join(found)
        both = texts(draw(self.records["both"]))
        self.assertIn(r"$\alpha = R_p/R_c$", both)
        self.assertNotIn("α =", both)  # it varies: no part of the scene
        self.assertIn("hexagon, β = 0.5, μ = 0.5, e = 0.95", both)
        self.assertIn("α = 0.4, β = 0.5", texts(draw(self.records["orbits"])))
        point = texts(draw(self.records["point"]))  # two parameters of one value: the first is the axis
        self.assertIn("hexagon, α = 0.4, β = 0.5, e = 0.9", point)
        self.assertIn(r"$\mu$", point)

    def test_stability_changes_at_the_special_point(self):
        flip = 1 + numpy.sqrt(6)  # of the logistic map's 2-cycle; between two points of the record's branch
        ends = {"solid": [], "dashed": []}
        for lines in draw(self.records["continue"]).axes[0].collections:
            style = "solid" if lines.get_linestyles()[0][1] is None else "dashed"
            ends[style] += [(line[0], line[-1]) for line in lines.get_segments()]
        solid = [last for _, last in ends["solid"] if abs(last[0] - flip) < 1e-12]
        dashed = [first for first, _ in ends["dashed"] if abs(first[0] - flip) < 1e-12]
        self.assertEqual((len(solid), len(dashed)), (2, 2))  # both points of the cycle
        numpy.testing.assert_array_equal(sorted(map(tuple, solid)), sorted(map(tuple, dashed)))

    def test_a_name_is_only_a_name(self):
        name = "-dash $(touch x) quote'\".svg"
        result = run(["plot", str(self.records["single"]), f"--output={name}"], cwd=self.folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertTrue((self.folder / name).is_file())
        self.assertFalse((self.folder / "x").exists())


class Orbits(WithRecords):
    """What the figures are drawn from is what the record says."""

    def test_flights_join_the_states_of_the_record(self):
        for name in ("steps", "chaotic", "contact"):
            record = open_record(self.records[name])
            flights, joined = flights_of(record), flights_of(record).follows()
            self.assertGreater(joined.sum(), 0.8 * (len(flights) - 1))
            for column, values in (("spin", flights.spin), ("vx", flights.vx), ("vy", flights.vy)):
                error = abs(values[1:] - record.column("collisions", column)[:-1])[joined]
                self.assertLess(error.max(), 1e-11, (name, column))
            begin = flights.x[1:] - flights.vx[1:] * (flights.end - flights.begin)[1:]
            self.assertLess(abs(begin - record.column("collisions", "x")[:-1])[joined].max(), 1e-11)

    def test_the_running_mean_ends_at_the_mean_of_the_record(self):
        for name in ("steps", "chaotic", "contact"):
            record = open_record(self.records[name])
            mean = running_mean(record)[1][-1]
            delta = 1e-3 if name == "contact" else 1e-12
            self.assertAlmostEqual(mean, record.attributes("result")["mean_S"], delta=delta)

    def test_stays_on_the_wall_are_on_the_wall(self):
        record = open_record(self.records["sampled"])
        found = stays(record)
        self.assertGreater(len(found), 0)
        for t, x, y in found:
            away = numpy.hypot(*FRAMES["Container (not turning)"](x, y, t, 0.05))
            self.assertLess(abs(away - 0.9).max(), 1e-12)
        self.assertEqual(stays(open_record(self.records["contact"])), [])

    def test_spin_through_contact_is_that_of_the_samples(self):
        record = open_record(self.records["sampled"])
        curves, shown = spin_on_wall(record)
        self.assertTrue(shown.all())
        self.assertEqual(sum(len(t) for t, _ in curves), record.column("samples", "in_contact").sum())
        start, end, mean = (record.column("contacts", name) for name in ("t_start", "t_end", "mean_S"))
        t, spin = (numpy.concatenate(columns) for columns in zip(*curves))
        longest = (end - start).argmax()
        inside = (t >= start[longest]) & (t <= end[longest])
        between = 0.05  # the trapezium rule over whole samples: the ends are missing
        area = ((spin[1:] + spin[:-1]) / 2 * numpy.diff(t))[inside[1:] & inside[:-1]].sum()
        self.assertAlmostEqual(area / numpy.ptp(t[inside]), mean[longest],
                               delta=2 * between * numpy.ptp(spin[inside]) / (end - start)[longest])
        curves, shown = spin_on_wall(open_record(self.records["contact"]))  # without samples: means of the pieces
        self.assertEqual((curves, shown.any()), ([], False))
        labels = [text.get_text() for axes in draw(self.records["sampled"], "spin").axes
                  for text in axes.get_legend().get_texts()]
        self.assertIn("S on the wall", labels)
        self.assertNotIn("on the wall (mean of each piece)", labels)

    def test_no_path_leaves_the_container(self):
        for name in ("steps", "chaotic", "every", "contact"):
            record = open_record(self.records[name])
            beta = record.scene()["beta"]
            for t, x, y in sample(flights_of(record)):
                distance = [numpy.hypot(*FRAMES["Container (not turning)"](x, y, t, beta)),
                            numpy.hypot(FRAMES["Co-rotating with the swirl"](x, y, t, beta)[0] - beta,
                                        FRAMES["Co-rotating with the swirl"](x, y, t, beta)[1])]
                self.assertLess(numpy.max(distance), 1)
                self.assertLess(abs(distance[0] - distance[1]).max(), 1e-12)


class BadInput(WithRecords):
    def check(self, arguments, *mentions, **options):
        before = sorted(self.folder.rglob("*"))
        result = run(arguments, **options)
        self.assertEqual((result.returncode, result.stdout), (2, ""), arguments)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for mention in mentions:
            self.assertIn(mention, result.stderr)
        self.assertEqual(sorted(self.folder.rglob("*")), before)

    def test_records(self):
        text = self.folder / "text.h5"
        text.write_text("no record")
        cut = self.folder / "cut.h5"
        cut.write_bytes(self.records["steps"].read_bytes()[:5000])
        empty = self.folder / "empty.h5"
        run(f"simulate --sides 6 --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.9 --x 0.1 --quiet -o {empty}")
        other = self.folder / "other.h5"
        figure_records.write_without_results(other)
        for record, mention in ((self.folder / "none.h5", "none.h5"), (text, "text.h5"), (cut, "cut.h5"),
                                (empty, "no impacts"), (other, "nothing that there is a figure of")):
            self.check(f"plot {record} -o {self.folder}/new.png --quiet", mention)

    def test_figures(self):
        record = self.records["steps"]
        self.check(f"plot {record} -o {self.folder}/a.jpg", "a.jpg", ".png, .svg, .pdf")
        self.check(f"plot {record} -o {self.folder}/a", "suffix")
        self.check(f"plot {record} -o {self.folder}/no/such/a.png", "no/such")
        self.check(f"plot {record} -o {self.folder}/new.png --kind modes", "kind = modes", "orbit, spin, path")
        self.check(f"plot {record}", "--output")
        self.check("plot -o a.png", "record")
        (self.folder / "folder.png").mkdir()
        self.check(f"plot {record} -o {self.folder}/folder.png", "folder.png")
        link = self.folder / "record.png"
        link.symlink_to(record)
        self.check(f"plot {record} -o {link}", "the record itself")

    def test_what_stood_there_stays(self):
        kept = self.folder / "kept.png"
        kept.write_text("not touched")
        self.check(f"plot {self.records['steps']} -o {kept} --kind modes")
        self.assertEqual(kept.read_text(), "not touched")

    def test_without_python_or_its_packages(self):
        bare = self.folder / "bare-python"
        bare.write_text('#!/bin/sh\nexec /usr/bin/python3 -I -S "$@"\n')
        bare.chmod(0o755)
        command = f"plot {self.records['steps']} -o {self.folder}/new.png"
        self.check(command, "python3-matplotlib", env={**os.environ, "SWIRL_PYTHON": "/nonsense/python3"})
        self.check(command, "SWIRL_FIGURES", env={**os.environ, "SWIRL_FIGURES": str(self.folder)})
        self.check(command, "python3-matplotlib", env={**os.environ, "SWIRL_PYTHON": str(bare)})

    def test_a_full_disk_exits_with_4(self):
        with open("/dev/full", "w") as full:
            result = subprocess.run([SWIRL, "plot", str(self.records["steps"]), "-o", str(self.folder / "full.png")],
                                    stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
        self.assertEqual((result.returncode, len(result.stderr.splitlines())), (4, 1), result.stderr)


class Interrupted(WithRecords):
    def test_leaves_nothing(self):
        before = sorted(self.folder.rglob("*"))
        for seconds in (0.03, 0.1, 0.5):  # as the program starts, as Python does, as it draws
            process = start(f"plot {self.records['chaotic']} -o {self.folder / 'cut.png'}", stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)
            time.sleep(seconds)
            process.send_signal(signal.SIGINT)
            output, errors = process.communicate(timeout=60)
            if process.returncode != 0:  # else it was quicker this time
                self.assertIn(process.returncode, (130, -signal.SIGINT))  # the latter before main()
                self.assertEqual((output, errors), ("", ""))
                self.assertEqual(sorted(self.folder.rglob("*")), before)


class PhysicalUnits(unittest.TestCase):
    """Axes in m, s, kg: the same curves, other numbers at the ticks."""

    def test_axes_are_in_si_and_ratios_stay(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder) / "o.h5"
            scene = ("--sides 6 --container-radius 0.07 --polygon-radius 0.028 --swirl-radius 0.035 --swirl-rate 12 "
                     "--mass 0.004 --mu 0.5 --restitution 0.9")
            self.assertEqual(run(f"simulate {scene} --collisions 60 --quiet -o {record}").returncode, 0)
            opened = open_record(record)
            units = physical.units_of(opened)
            self.assertEqual(units, (0.07, 1 / 12, 0.004))
            for kind, labels in (("spin", {"time t [s]"}), ("path", {"x [m]", "y [m]"}), ("balance", {"time t [s]", "Jacobi integral J [J]"}),
                                 ("section", {"time t [s]"}), ("energy", {"energy E_p [J]"})):  # of its colours
                figure = draw(opened, kind)
                plain = [line.get_xydata() for axes in figure.axes for line in axes.lines]
                limits = [(axes.get_xlim(), axes.xaxis.get_label_text()) for axes in figure.axes]
                self.assertGreater(physical.in_si(figure, units), 0, kind)
                found = {axis.get_label_text().replace("$", "") for axes in figure.axes for axis in (axes.xaxis, axes.yaxis)}
                self.assertLessEqual(labels, found, kind)
                self.assertFalse([label for label in found if "R_c" in label], kind)
                figure.canvas.draw()
                for axes, ((low, high), label) in zip(figure.axes, limits):
                    self.assertEqual(axes.get_xlim(), (low, high), kind)  # the same picture
                    if "omega_s t" in label:  # a tick says where it is, in seconds
                        for tick in axes.xaxis.get_major_ticks():
                            text = tick.label1.get_text().replace("\N{MINUS SIGN}", "-")
                            if text and low <= tick.get_loc() <= high:
                                self.assertAlmostEqual(float(text), tick.get_loc() / 12, delta=1e-6 * high, msg=kind)
                self.assertTrue(all((one == other).all() for one, other in
                                    zip(plain, [line.get_xydata() for axes in figure.axes for line in axes.lines])))
            plot = f"plot {record} -o {folder}/a.png --units physical"
            self.assertEqual(run(f"{plot} --kind spin --xlim 1:3").returncode, 0)
            energy = opened.column("collisions", "energy") * 0.004 * (0.07 * 12) ** 2  # J
            self.assertEqual(run(f"{plot} --kind energy --xlim 1:3 --ylim 0:{2 * energy.max()} --force").returncode, 0)
            outside = f"{10 * energy.max():.6g}:{20 * energy.max():.6g}"
            refused = run(f"{plot} --kind energy --ylim {outside} --force").stderr
            self.assertRegex(refused, rf"ylim = {re.escape(outside)}: .* nothing to draw there, only from [\d.e-]+ to {energy.max():.6g}\n")
            whole = Look()
            draw(opened, "energy", whole)
            limits = physical.limits_drawn(whole.limited, Look(xlim=(1, 3), ylim=(0, energy.max())), units)
            self.assertAlmostEqual(limits["xlim"][1], 36, delta=1e-9)
            self.assertAlmostEqual(limits["ylim"][1], opened.column("collisions", "energy").max(), delta=1e-12)

    def test_a_record_without_units_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            record = Path(folder) / "o.h5"
            self.assertEqual(run(f"simulate {STEADY} --collisions 20 --quiet -o {record}").returncode, 0)
            result = run(f"plot {record} -o {folder}/a.png --units physical")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), result.stderr)
            self.assertIn("has no units", result.stderr)


class Help(unittest.TestCase):
    def test_the_example_runs(self):
        examples = examples_of("plot")
        self.assertGreaterEqual(len(examples), 2)
        with tempfile.TemporaryDirectory() as folder:
            for example in examples:
                self.assertEqual(run(example, cwd=folder).returncode, 0, example)


if __name__ == "__main__":
    unittest.main()
