"""swirl ramp, from outside: ramp_command_test.py SWIRL [--all]

The hexagon of SCENE has a cycle of two impacts that folds at FOLD as β rises, and a steady mode that ends in a subcritical
flip at FLIP as β falls: between them both attract."""

import math
import statistics
import sys
import unittest

import xarray

from driving import InFolder, document, examples_of, interrupted, run

#: The 97.5 % quantile of Student's distribution, of so many points less two.
STUDENT = {4: 4.303, 7: 2.571}
ALL = "--all" in sys.argv and not sys.argv.remove("--all")
SCENE = "--sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9"
FOLD, FLIP = 0.381272422458637, 0.3775155751
#: On the cycle at β = 0.38.
TWO = "0.0579050729,0.2629593559,-0.5381775153,0.7252958927,-0.8956189008"
STEADY = f"{SCENE} --beta 0.5"


def left(found, period):
    return next(mode for mode in found["modes"] if mode["period"] == period and mode["left_at"] is not None)


def exponent(rates, delays):
    """The slope of their logarithms, and half of its interval at 95 % (Student)."""
    x, y = [math.log(rate) for rate in rates], [math.log(delay) for delay in delays]
    slope, _ = statistics.linear_regression(x, y)
    mean_x, mean_y = statistics.fmean(x), statistics.fmean(y)
    rest = sum((v - mean_y - slope * (u - mean_x)) ** 2 for u, v in zip(x, y))
    return slope, STUDENT[len(x)] * math.sqrt(rest / (len(x) - 2) / sum((u - mean_x) ** 2 for u in x))


class Loop(unittest.TestCase):
    def test_its_ends_are_the_fold_and_the_flip(self):
        found = document(f"ramp {SCENE} --along beta=0.374:0.384 --rate 1e-6 --down --windows 30 --branches")
        self.assertEqual(found["outcome"], "completed")
        up, down = left(found, 2), left(found, 1)
        self.assertEqual((up["direction"], up["way"], up["end"]), ("up", 0, "fold"))
        self.assertAlmostEqual(up["end_at"], FOLD, delta=1e-9)
        self.assertGreater(up["delay"], 0)
        self.assertEqual((down["direction"], down["way"], down["end"]), ("down", 1, "flip"))
        self.assertAlmostEqual(down["end_at"], FLIP, delta=1e-9)
        self.assertGreater(down["delay"], 0)
        inside = [window for window in found["windows"] if FLIP + 2e-4 < window["parameter"] < FOLD - 2e-4]
        self.assertEqual({(window["direction"], window["period"]) for window in inside}, {("up", 2), ("down", 1)})

    def test_the_delay_past_the_fold_is_that_of_its_normal_form(self):
        """Rate by rate the delay is that which is given beside it, up to the next order, v^(1/3) ln v with v = rate T; and its
        exponent is 2/3, the rounds by which D is exceeded before all else counted as theory has them."""
        rates = [10 ** (-0.5 * i) for i in (range(12, 19) if ALL else range(12, 16))]
        delays, factors, whole = [], [], []
        for rate in rates:
            mode = left(document(f"ramp {SCENE} --point={TWO} --transient 3000 --along beta=0.3805:0.382 --rate {rate} --windows 4 --branches"), 2)
            self.assertEqual(mode["end"], "fold")
            self.assertAlmostEqual(mode["end_at"], FOLD, delta=1e-9)
            v = rate * mode["round"]
            delays.append(mode["delay"])
            factors.append(mode["delay"] / mode["predicted_delay"])
            whole.append(factors[-1] * v ** (2 / 3))
            self.assertLess(abs(factors[-1] - 1), -v ** (1 / 3) * math.log(v), rate)
        slope, half = exponent(rates, whole)
        if ALL:
            raw, raw_half = exponent(rates, delays)
            print("rates", rates, "\ndelays", delays, "\nfactors", factors, f"\nexponent {slope:.4f} +- {half:.4f}, of the delays as they are "
                  f"{raw:.4f} +- {raw_half:.4f}")
        self.assertAlmostEqual(slope, 2 / 3, delta=0.01)
        self.assertLess(half, 0.01)

    def test_at_a_border_the_mode_is_left_at_once(self):
        """Below 0.3744 a corner of the cycle of two grazes: it is left within some rounds, whatever the rate."""
        for rate in (1e-5, 1e-6, 1e-7):
            mode = left(document(f"ramp {SCENE} --point={TWO} --along beta=0.376:0.374 --rate {rate} --windows 4 --branches"), 2)
            self.assertEqual((mode["direction"], mode["end"]), ("down", "grazing"))
            self.assertIsNone(mode["predicted_delay"])
            rounds = mode["delay"] / (rate * mode["round"])
            self.assertGreater(rounds, -2)
            self.assertLess(rounds, 20)

    def test_without_hysteresis_down_is_up_reversed(self):
        """Both follow the one attracting branch, each behind it by the order of the rate."""
        for rate in (1e-4, 1e-5):
            found = document(f"ramp {SCENE} --along beta=0.42:0.45 --rate {rate} --down --windows 20")
            windows = found["windows"]
            up = {round(w["parameter"], 9): w["mean_S"] for w in windows if w["direction"] == "up"}
            down = {round(w["parameter"], 9): w["mean_S"] for w in windows if w["direction"] == "down"}
            self.assertEqual(len(up), 20)
            self.assertEqual(set(up), set(down))
            largest = max(abs(up[p] - down[p]) for p in up)
            self.assertLess(largest, 20 * rate, rate)
            self.assertEqual([mode["left_at"] for mode in found["modes"]], [None])

    def test_a_slow_one_is_on_the_diagram(self):
        found = document(f"ramp {SCENE} --along beta=0.45:0.42 --rate 1e-6 --windows 4")
        columns = {}
        for window in found["windows"]:
            self.assertEqual((window["period"], window["direction"]), (1, "down"))
            plain = document(f"bifurcate {SCENE} --along beta={window['parameter']!r},0.9 --starts 1")["columns"][0]
            columns[window["parameter"]] = plain["attractors"][0]["mean_S"]
            self.assertAlmostEqual(window["mean_S"], columns[window["parameter"]], delta=1e-5)


class Command(InFolder):
    def test_the_parameter_stands_still_during_a_flight(self):
        """Without a change to speak of the impacts are those of simulate; with one the value is behind by rate × flight."""
        point = "--point=-0.0839,0.028,-0.5542,0.8898,-0.9793"
        still = document(f"ramp {STEADY} {point} --along beta=0.5:0.5000000000000001 --duration 100 --windows 1 --transient 0")
        plain = document(f"simulate {STEADY} {point} --collisions {still['result']['impacts'] + 1}")["collisions"]
        self.assertAlmostEqual(still["windows"][0]["vt"], plain[-1]["vt"], delta=1e-12)
        moved = document(f"ramp {STEADY} {point} --along beta=0.5:0.55 --rate 1e-3 --windows 4 --transient 100")
        longest = max(impact["flight_time"] for impact in plain)
        for window in moved["windows"]:
            self.assertGreater(window["lag"], 0)
            self.assertLess(window["lag"], 1.5e-3 * longest)

    def test_every_parameter_that_can_change(self):
        for along, scene in (("mu=0.5:0.2", STEADY), ("restitution=0.9:1", STEADY), ("drag=0:0.05", STEADY),
                             ("tangential-restitution=0:0.5", "--sides disk --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1")):
            found = document(f"ramp {scene} --along {along} --duration 200 --windows 4 --down --transient 100")
            self.assertEqual((found["outcome"], found["along"]), ("completed", along.split("=")[0]))
            self.assertNotIn(found["along"].replace("-", "_"), found["scene"])
            self.assertEqual([window["way"] for window in found["windows"]], [0] * 4 + [1] * 4)

    def test_one_that_is_over_within_a_flight_has_one_way(self):
        """The flight ends 1e18 ways' durations later."""
        found = document(f"ramp {STEADY} --along beta=0.5:0.51 --rate 1e16 --transient 10")
        self.assertEqual([(window["way"], window["impacts"]) for window in found["windows"]], [(0, 1)])

    def test_a_branch_that_goes_on_beyond_the_range_is_no_end_to_be_late_at(self):
        """With a tolerance below what the ramp moves the mode by in a round it is left, and its branch does not end."""
        found = document(f"ramp {SCENE} --along beta=0.42:0.45 --rate 1e-3 --tolerance 1e-4 --windows 4 --branches")
        mode = found["modes"][0]
        self.assertIsNotNone(mode["left_at"])
        self.assertEqual((mode["end"], mode["delay"]), ("range", None))

    def test_without_a_window_that_is_said(self):
        table = run("ramp --sides disk --alpha 0.3 --mu 0.5 --restitution 0.5 --along beta=0.1:0.2 --rate 1e-3").stdout
        self.assertIn("no window was finished\nin-contact; 0 impacts", table)

    def test_what_can_not_change_is_refused_with_the_reason(self):
        for along, reason in (("alpha=0.3:0.4", "vertices"), ("corner=0:0.1", "the body"), ("sides=3:4", "no number that changes continuously"), ("law=1:2", "continuously"),
                              ("inertia-factor=0.4:0.5", "the body"), ("swirl-rate=1:2", "unit of time"), ("gamma=0:1", "none of"),
                              ("beta=0.4", "NAME=A:B"), ("beta=0.4:0.4", "differ"), ("mu=0.5:-1", "mu = -1"), ("restitution=0.9:1.1", "1.1")):
            self.refused(f"ramp {STEADY} --along {along} --rate 1e-3", reason)
        self.refused(f"ramp {STEADY} --along beta=0.4:0.5", "--rate")
        self.refused(f"ramp {STEADY} --along beta=0.4:0.5 --rate 1e-3 --duration 5", "give one")
        self.refused(f"ramp {STEADY} --along beta=0.4:0.5 --rate 1e-3 --down --cycles 2", "give one")
        for flag, value in (("--rate", "0"), ("--rate", "nan"), ("--duration", "-1"), ("--duration", "inf")):
            self.refused(f"ramp {STEADY} --along beta=0.4:0.5 {flag} {value}", flag[2:], value)
        for value in ("0", "1", "nan"):
            self.refused(f"ramp {STEADY} --along beta=0.4:0.5 --rate 1e-3 --tolerance {value}", "tolerance")
        self.refused(f"ramp {STEADY} --along beta=0.4:0.5 --rate 1e-3 --x 3", "start")

    def refused(self, arguments, *mentions):
        result = run(f"{arguments} -o {self.folder}/a.h5")
        self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), (arguments, result.stderr))
        for mention in mentions:
            self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])

    def test_an_orbit_that_ends_says_where(self):
        found = document("ramp --sides disk --alpha 0.4 --mu 0.4 --restitution 0.9 --along beta=0.3:0.31 --duration 100", 3)
        self.assertNotEqual(found["outcome"], "completed")
        self.assertEqual(found["result"]["parameter"], 0.3)

    def test_the_record_has_what_the_document_has(self):
        command = f"ramp {SCENE} --along beta=0.374:0.384 --rate 1e-5 --cycles 2 --windows 5 --samples 3 --branches"
        found = document(f"{command} -o {self.folder}/a.h5")
        self.assertEqual(run(f"{command} --quiet --threads 1 -o {self.folder}/b.h5").returncode, 0)
        self.assertEqual((self.folder / "a.h5").read_bytes(), (self.folder / "b.h5").read_bytes())
        windows = xarray.open_dataset(self.folder / "a.h5", group="windows", engine="h5netcdf")
        self.assertEqual(list(windows["mean_S"].values), [window["mean_S"] for window in found["windows"]])
        self.assertEqual(len(found["windows"]), 20)
        samples = xarray.open_dataset(self.folder / "a.h5", group="samples", engine="h5netcdf")
        self.assertEqual(samples.sizes["sample"], 60)
        for name in ("psi", "chi", "vn", "vt", "S"):
            self.assertEqual(list(samples[name].values[2::3]), [window[name] for window in found["windows"]])
        modes = xarray.open_dataset(self.folder / "a.h5", group="modes", engine="h5netcdf")
        self.assertEqual(modes.sizes["mode"], len(found["modes"]))

    def test_a_figure_lies_over_the_diagram_of_its_parameter(self):
        for name, command in (("ramp", f"ramp {SCENE} --along beta=0.374:0.384 --rate 1e-5 --down --windows 5"),
                              ("same", f"bifurcate {SCENE} --along beta=0.37:0.39:3 --starts 1 --branches"),
                              ("other", "bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --along alpha=0.39:0.4:2 --starts 1")):
            self.assertEqual(run(f"{command} --quiet -o {self.folder}/{name}.h5").returncode, 0)
        drawn = run(f"plot {self.folder}/same.h5 {self.folder}/ramp.h5 -o {self.folder}/a.png --caption {self.folder}/a.txt")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertIn("fold", (self.folder / "a.txt").read_text())
        refused = run(f"plot {self.folder}/other.h5 {self.folder}/ramp.h5 -o {self.folder}/b.png")
        self.assertEqual((refused.returncode, len(refused.stderr.splitlines())), (2, 1), refused.stderr)
        self.assertIn("is over beta", refused.stderr)

    def test_an_interruption_keeps_what_is_done(self):
        command = f"ramp {SCENE} --along beta=0.42:0.45 --rate 1e-9 --windows 100000 --quiet -o {self.folder}/a.h5"
        self.assertEqual(interrupted(command, 1.5), 130)
        windows = xarray.open_dataset(self.folder / "a.h5", group="windows", engine="h5netcdf")
        self.assertGreater(windows.sizes["window"], 0)
        self.assertEqual(set(windows["period"].values[2:]), {1})

    def test_examples_run(self):
        for example in examples_of("ramp"):
            self.assertEqual(run(example, cwd=self.folder).returncode, 0, example)


if __name__ == "__main__":
    unittest.main()
