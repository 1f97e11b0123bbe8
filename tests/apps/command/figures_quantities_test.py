"""What a sweep found, as lines and as maps; the energy; --ylim and --log. figures_quantities_test.py SWIRL ROOT"""

import unittest

import h5py
import numpy
from matplotlib.collections import QuadMesh

from driving import document, folder_of_module, made_records, run
from drawn_records import labels_of
from swirl_figures import Look, RecordError, draw, kinds_of, open_record

RECORDS = {"plane": "sweep --sides 6 --beta 0.1 --restitution 1 --grid alpha=0.3:0.7:5 --grid mu=0:0.5:3 --runs 3 --transient 200 "
                    "--collisions 300",
           "many": "sweep --sides 6 --beta 0.5 --restitution 0.9 --grid alpha=0.3:0.7:9 --grid mu=0.1:0.9:12 --transient 50 --collisions 64",
           "line": "sweep --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:0.9:3 --transient 100 --collisions 100",
           "orbit": "simulate --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --collisions 200",
           "disk": "simulate --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.95 --collisions 400"}


def lines_of(figure):
    """{label of the legend: (x, y)} of the lines with markers; of a figure of means."""
    containers = figure.axes[0].containers
    return {label: container[0].get_xydata().T for label, container in zip(labels_of(figure), containers, strict=True)}


class Means(unittest.TestCase):
    def test_are_lines_over_one_parameter_for_each_value_of_another_with_error_bars(self):
        record = open_record(RECORDS["plane"])
        figure = draw(record, "means")
        lines = lines_of(figure)
        self.assertEqual(list(lines), ["μ = 0", "μ = 0.25", "μ = 0.5"])
        mean, error = (record.column("sweep", name, ["alpha", "mu"]) for name in ("mean_S", "mean_S_error"))
        for index, (x, y) in enumerate(lines.values()):
            numpy.testing.assert_array_equal((x, y), (record.column("sweep", "alpha"), mean[:, index]))
            bars = figure.axes[0].containers[index][2][0].get_segments()
            lengths = numpy.where(numpy.isnan(error[:, index]), 0, 2 * error[:, index])  # where there is none, no bar
            known = ~numpy.isnan(mean[:, index])  # what is driven without end has no mean
            drawn = [bar[1, 1] - bar[0, 1] for bar, is_known in zip(bars, known, strict=True) if is_known]
            numpy.testing.assert_allclose(drawn, lengths[known], atol=1e-12)
        self.assertGreater(numpy.nanmean(lines["μ = 0"][1]), numpy.nanmean(lines["μ = 0.5"][1]) + 0.5)  # the paper's Figure 7

    def test_go_over_the_parameter_that_is_asked_for(self):
        lines = lines_of(draw(RECORDS["plane"], "means", Look(over="mu")))
        self.assertEqual(list(lines), ["α = 0.3", "α = 0.4", "α = 0.5", "α = 0.6", "α = 0.7"])
        with self.assertRaisesRegex(RecordError, "over = beta: the sweep's parameters are alpha, mu"):
            draw(RECORDS["plane"], "means", Look(over="beta"))

    def test_of_many_values_some_are_drawn_and_said(self):
        figure = draw(RECORDS["many"], "means", Look(over="alpha"))
        self.assertEqual(len(labels_of(figure)), 8)
        self.assertIn("8 of 12 values are drawn", figure._suptitle.get_text())

    def test_over_one_parameter_are_one_line(self):
        (x, y), = lines_of(draw(RECORDS["line"], "means")).values()
        numpy.testing.assert_array_equal(y, open_record(RECORDS["line"]).column("sweep", "mean_S"))
        self.assertEqual(kinds_of(RECORDS["line"]), ["modes", "means"])  # no plane, no map

    def test_of_other_quantities(self):
        record = open_record(RECORDS["plane"])
        for of, column in (("exponent", "largest_exponent"), ("RC", "recurrence_rate")):
            for index, (_, y) in enumerate(lines_of(draw(record, "means", Look(of=of))).values()):
                numpy.testing.assert_array_equal(y, record.column("sweep", column, ["alpha", "mu"])[:, index])


class Maps(unittest.TestCase):
    def cells(self, of):
        axes = draw(RECORDS["many"], "map", Look(of=of)).axes[0]
        mesh = next(mesh for mesh in axes.collections if isinstance(mesh, QuadMesh))
        return numpy.ma.filled(mesh.get_array(), numpy.nan).reshape(9, 12, order="F") if mesh.get_array().ndim == 1 else mesh.get_array().T

    def test_are_the_records_numbers(self):
        record = open_record(RECORDS["many"])
        for of, column in (("S", "mean_S"), ("exponent", "largest_exponent")):
            found = record.column("sweep", column, ["alpha", "mu"])
            numpy.testing.assert_array_equal(numpy.ma.filled(self.cells(of), numpy.nan), found)

    def test_periods_are_those_of_most_starts(self):
        period = open_record(RECORDS["many"]).column("sweep", "run_period", ["alpha", "mu", "run"])[..., 0]
        places = numpy.ma.filled(self.cells("period").astype(float), numpy.nan)
        known = sorted({value for value in period.ravel() if 0 < value <= 8})
        for place, value in enumerate(known):
            numpy.testing.assert_array_equal(places == place, period == value)
        numpy.testing.assert_array_equal(numpy.isnan(places), period == 0)

    def test_words_that_are_not_known_are_refused(self):
        for look, words in ((Look(of="mass"), "of = mass: allowed are S, exponent, period, RC"),
                            (Look(over="mu"), "over = mu: a figure of kind map has nothing to choose there, one of kind means has")):
            with self.assertRaisesRegex(RecordError, words):
                draw(RECORDS["plane"], "map", look)


class Energy(unittest.TestCase):
    def test_is_that_of_the_velocities(self):
        """E_p = ½ m v² + ½ I ω_p² (Sun 2019), I that of the uniform body."""
        for name, factor, alpha in (("orbit", (2 + numpy.cos(numpy.pi / 3)) / 6, 0.3), ("disk", 0.5, 0.4)):
            record = open_record(RECORDS[name])
            vx, vy, spin, energy, t = (record.column("collisions", column) for column in ("vx", "vy", "spin", "energy", "t"))
            numpy.testing.assert_allclose(energy, (vx**2 + vy**2 + factor * alpha**2 * spin**2) / 2, rtol=1e-14)
            axes = draw(record, "energy").axes[0]
            drawn = axes.get_lines()[0].get_xydata() if len(t) <= 300 else axes.collections[0].get_offsets()
            numpy.testing.assert_array_equal(drawn, numpy.column_stack([t, energy]))

    def test_of_an_older_record_is_drawn_from_its_velocities(self):
        from shutil import copy
        older = copy(RECORDS["disk"], RECORDS["disk"].with_name("older.h5"))
        with h5py.File(older, "r+") as file:
            del file["collisions/energy"]
        dots = [draw(record, "energy").axes[0].collections[0].get_offsets() for record in (older, RECORDS["disk"])]
        numpy.testing.assert_allclose(*dots, rtol=1e-14)

    def test_a_document_has_it(self):
        row = document("simulate --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.95 --collisions 1")["collisions"][0]
        self.assertAlmostEqual(row["energy"], (row["vx"]**2 + row["vy"]**2 + 0.5 * 0.4**2 * row["spin"]**2) / 2, delta=1e-15)


class Axes(unittest.TestCase):
    def plot(self, arguments, code=0):
        result = run(f"plot {RECORDS['orbit']} -o {RECORDS['orbit'].with_name('new.png')} --quiet {arguments}")
        self.assertEqual(result.returncode, code, result.stderr)
        return result.stderr

    def test_ordinates_are_limited(self):
        axes = draw(RECORDS["orbit"], "spin", Look(ylim=(-1, 2))).axes[0]
        self.assertEqual(axes.get_ylim(), (-1, 2))
        self.assertIn("ylim = 2:1: allowed is A:B", self.plot("--ylim 2:1", 2))
        for kind, words in (("spin", "ylim = 900:1000: record"), ("path", "no ordinate to limit")):
            with self.assertRaisesRegex(RecordError, words):
                draw(RECORDS["orbit"], kind, Look(ylim=(900, 1000)))

    def test_axes_are_logarithmic(self):
        axes = draw(RECORDS["orbit"], "energy", Look(log="xy")).axes[0]
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "log"))
        self.plot("--kind energy --log y --ylim 0.001:2")
        with self.assertRaisesRegex(RecordError, "log = z: allowed are x, y, xy"):
            draw(RECORDS["orbit"], "energy", Look(log="z"))
        with self.assertRaisesRegex(RecordError, "ylim = -1:1: the ordinate is logarithmic"):
            draw(RECORDS["orbit"], "energy", Look(log="y", ylim=(-1, 1)))


def setUpModule():
    RECORDS.update(made_records(RECORDS, folder_of_module(), (0, 3)))  # the disk comes to rest on the wall


if __name__ == "__main__":
    unittest.main()
