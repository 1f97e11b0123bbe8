"""Measured series and records as input to recurrence, spectrum and classify: series_command_test.py SWIRL REFERENCES"""

import json
import math
import random
import sys
import unittest
from pathlib import Path

import xarray

from driving import InFolder, document, interrupted, run, sized

REFERENCES = Path(sys.argv.pop(1)).resolve()
STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
CHATTER = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"
GOLDEN = (math.sqrt(5) - 1) / 2


class MeasuredRegimes(InFolder):
    """One oracle per regime, with 1 % of noise: what the measures and the spectrum must say."""

    def setUp(self):
        super().setUp()
        noise = random.Random(3)
        n = 2000
        logistic, x = [], 0.4
        for _ in range(n):
            x = 4 * x * (1 - x)
            logistic.append(x)
        clean = {
            "periodic": [[-1.0, 0.2, 0.9, 0.5][i % 4] for i in range(n)],
            "quasi-periodic": [math.cos(2 * math.pi * GOLDEN * i) for i in range(n)],
            "chaotic": logistic,
            "transient": [math.exp(-i / 100) for i in range(n)],
        }
        self.clean = {k: self.series(f"{k}.csv", v) for k, v in clean.items()}
        self.noisy = {k: self.series(f"{k}-noisy.csv", [v + noise.gauss(0, 0.01) for v in values])
                      for k, values in clean.items()}
        self.fixed = self.series("fixed.csv", [0.25] * n)

    def test_recurrence(self):
        for files in sized((self.clean, self.noisy), (self.noisy,)):
            found = {k: document(f"recurrence --series {f} --threshold-std 0.1 --min-diagonal 5")
                     for k, f in files.items()}
            self.assertAlmostEqual(found["periodic"]["RC"], 0.25, delta=0.001)
            self.assertGreater(found["periodic"]["DET"], 0.99)
            self.assertLess(found["chaotic"]["DET"], 0.4)
            self.assertGreater(found["transient"]["LAM"], 0.8)  # it stays where it has come to
            self.assertLess(found["chaotic"]["LAM"], 0.5)
        # Lines of rotation by the golden mean never break off: the longest is cut by the matrix alone.
        quasi = document(f"recurrence --series {self.clean['quasi-periodic']} --threshold-std 0.1 --dimension 2")
        self.assertGreater(quasi["Lmax"], 900)
        self.assertEqual(document(f"recurrence --series {self.fixed} --threshold 1e-6")["RR"], 1)

    def test_spectrum(self):
        self.assertEqual(document(f"spectrum --series {self.fixed}")["spectrum_outcome"], "constant")
        for files, off in ((self.clean, 1e-7), (self.noisy, 1e-4)):
            found = {k: document(f"spectrum --series {f}") for k, f in files.items()}
            self.assertEqual(found["periodic"]["verdict"], "lines")
            self.assertAlmostEqual(found["periodic"]["peaks"][0]["frequency"], 0.25, delta=off)
            self.assertAlmostEqual(found["periodic"]["peaks"][1]["frequency"], 0.5, delta=off)
            self.assertEqual(found["quasi-periodic"]["verdict"], "lines")
            self.assertAlmostEqual(found["quasi-periodic"]["peaks"][0]["frequency"], 1 - GOLDEN, delta=off)
            self.assertAlmostEqual(found["quasi-periodic"]["peaks"][0]["power"], 0.5, delta=0.005)
            self.assertEqual(found["chaotic"]["verdict"], "continuum")
            self.assertGreater(found["chaotic"]["entropy"], 0.9)  # r = 4: white
            self.assertEqual(found["transient"]["verdict"], "nonstationary")

    def test_the_integral_of_the_power_is_the_variance(self):
        for file in (*self.clean.values(), *self.noisy.values())[::sized(1, 3)]:
            values = [float(v) for v in file.read_text().split()[1:]]
            mean = math.fsum(values) / len(values)
            variance = math.fsum((v - mean) ** 2 for v in values) / len(values)
            for flags in ("", "--window rectangular --segments 1",
                          "--window blackman-harris --segments 5 --overlap 0.3"):
                found = document(f"spectrum --series {file} {flags}")
                integral = math.fsum(found["power"]) * (found["frequency"][1] - found["frequency"][0])
                self.assertAlmostEqual(integral / variance, 1, delta=1e-12)

    def test_a_rectangular_window_gives_the_periodogram_of_parseval_without_rescaling(self):
        found = document(f"spectrum --series {self.clean['chaotic']} --window rectangular --segments 1")
        self.assertAlmostEqual(found["variance_scale"], 1, delta=1e-12)


class Motion(InFolder):
    """Lost rows, angles and positions."""

    TURNS = 2 * math.pi

    def rows(self, name, header, rows):
        return self.file(name, "\n".join([header] + [",".join(repr(v) for v in row) for row in rows]) + "\n")

    def test_a_lost_frame_is_a_gap_and_changes_no_verdict(self):
        rows = [(i / 30, math.sin(0.31 * i) + 0.5 * math.sin(0.31 * (1 + GOLDEN) * i)) for i in range(3600)]
        for lost in sized(([], [1700], [900, 901, 2600]), ([900, 901, 2600],)):
            file = self.rows("s.csv", "t,S", [row for i, row in enumerate(rows) if i not in lost])
            found = document(f"classify --series {file}")
            self.assertEqual((found["mode"], found["settings"]["rows"]), ("quasi-steady", "samples"), lost)
            series = found["series"]
            self.assertEqual((series["column"], series["rows"], series["missing"], series["even"]),
                             ("S", 3600 - len(lost), len(lost), True))
            self.assertEqual(series["gaps"], {0: 0, 1: 1, 3: 2}[len(lost)])
            self.assertAlmostEqual(series["spacing"], 1 / 30, delta=1e-12)
            for command in ("classify", "recurrence", "spectrum"):
                text = run(f"{command} --series {file}").stdout
                self.assertIn(f"series: column S, {3600 - len(lost)} rows, spacing 0.0333333, ", text)
                self.assertIn(f"{len(lost)} samples missing" if lost else "no gaps", text)

    def test_uneven_times_stay_as_they_are(self):
        times = [0.0]
        for i in range(200):
            times.append(times[-1] + [0.4, 1.3, 0.8, 2.1][i % 4])
        file = self.series("u.csv", [[-1.0, 0.2, 0.9, 0.5][i % 4] for i in range(201)], times)
        series = document(f"classify --series {file}")["series"]
        self.assertEqual((series["gaps"], series["samples"], series["even"]), (0, 201, False))

    def test_an_angle_gives_S_however_it_is_wrapped(self):
        rate, dt, count = 6.0, 1 / 30, 900
        spin = [-0.7 + 0.4 * math.sin(0.05 * i) for i in range(count)]
        angle = [0.3]
        for s in spin:
            angle.append(angle[-1] + rate * s * dt)
        degrees = 180 / math.pi
        columns = {"unwound": (angle, ""), "wrapped": ([math.remainder(a, self.TURNS) for a in angle], ""),
                   "degrees": ([a * degrees % 360 for a in angle], "--degrees"),
                   "sixth": ([a * degrees % 60 for a in angle], "--degrees --symmetry 6")}
        for name, (values, flags) in columns.items():
            file = self.rows(f"{name}.csv", "t,theta", [(i * dt, a) for i, a in enumerate(values)])
            record = self.folder / "r.h5"
            found = document(f"recurrence --series {file} --angle theta --swirl-rate {rate} {flags} --threshold 0.1 "
                             f"-o {record}")
            with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
                values = data["value"].values  # one by one they take a second a thousand
                self.assertEqual(len(values), len(spin))
                for found_, expected in zip(values, spin):
                    self.assertAlmostEqual(found_, expected, delta=1e-11, msg=name)
                self.assertAlmostEqual(float(data["time"][0]), dt / 2, delta=1e-15)
            record.unlink()
            series = found["series"]
            self.assertEqual((series["quantity"], series["swirl_rate"], series["rows"]), ("S of an angle", rate, count + 1))
            half = math.pi / (6 if name == "sixth" else 1)
            self.assertAlmostEqual(series["largest_turn"], rate * 1.1 * dt / half, delta=1e-3)

    def test_a_position_gives_its_distance(self):
        rows = [(0.1 * i, 3 * math.cos(i), 4 * math.sin(i)) for i in range(200)]
        file = self.rows("p.csv", "t,x,y", rows)
        record = self.folder / "r.h5"
        found = document(f"recurrence --series {file} --position x y --threshold 0.1 -o {record}")
        self.assertEqual((found["series"]["column"], found["series"]["quantity"]), ("x, y", "distance of a position"))
        with xarray.open_dataset(record, group="series", engine="h5netcdf") as data:
            values = data["value"].values
            self.assertEqual(len(values), len(rows))
            for found_, (_, x, y) in zip(values, rows):
                self.assertAlmostEqual(found_, math.hypot(x, y), delta=1e-14)
        verdict = document(f"classify --series {file} --position x y")
        self.assertIsNone(verdict["mean_S"])
        # It swings along every flight of a steady mode, too: which of the two regular modes it is cannot be told.
        self.assertEqual((verdict["mode"], verdict["kind"]), ("undecided", None))
        self.assertIn("steady or quasi-steady", verdict["evidence"][-1]["says"])

    def test_a_long_flight_of_impacts_is_no_lost_frame(self):
        times = [0.0]
        for i in range(1999):
            times.append(times[-1] + (2 if i % 11 == 10 else 1))
        spins = [0.1, 0.5, -0.3, 0.8, 0.2, 0.9, -0.5, 0.4, 0.0, 0.7]
        file = self.series("i.csv", [spins[i % 10] for i in range(2000)], times)
        for flags in ("", "--rows impacts"):
            found = document(f"classify --series {file} {flags}")
            self.assertEqual((found["kind"], found["period"], found["series"]["gaps"]), ("cycle", 10, 0), flags)
        result = run(f"classify --series {file} --rows samples")
        self.assertEqual(result.returncode, 2)
        self.assertIn("between 181 gaps has 11 samples; 64 or more are needed (--rows impacts", result.stderr)

    def test_a_record_of_an_angle_is_judged_as_the_file(self):
        noise = random.Random(8)
        rows = [(i / 30, math.degrees(-6 * i / 30 + noise.gauss(0, 0.002)) % 360) for i in range(900) if i % 100 != 50]
        file = self.rows("a.csv", "t,theta", rows)
        record = self.folder / "a.h5"
        choice = f"--series {file} --angle theta --degrees --swirl-rate 6"
        self.assertEqual(run(f"recurrence {choice} --threshold 0.1 --quiet -o {record}").returncode, 0)
        direct, kept = document(f"classify {choice}"), document(f"classify {record}")
        self.assertEqual(direct, kept)
        self.assertEqual((kept["mode"], kept["settings"]["samples_bridged"]), ("steady", 9))

    def test_flags_of_a_record_are_heeded_or_refused(self):
        file = self.series("s.csv", [[-1.0, 0.2, 0.9][i % 3] for i in range(600)], [0.5 * i for i in range(600)])
        record = self.folder / "s.h5"
        self.assertEqual(run(f"recurrence --series {file} --quiet -o {record}").returncode, 0)
        found = document(f"classify {record} --transient 100 --collisions 300")
        self.assertEqual((found["settings"]["samples_used"], found["settings"]["first_time_used"]), (300, 50))
        for flags in ("--column S", "--position a b", "--symmetry 6", "--degrees", "--time t", "--angle S",
                      "--swirl-rate 2", "--transient 400 --collisions 300"):
            result = run(f"classify {record} {flags}")
            self.assertEqual((result.returncode, result.stdout), (2, ""), flags)
            self.assertEqual(len(result.stderr.splitlines()), 1)

    def test_the_noise_of_an_angle_is_not_that_of_S(self):
        # An angle at impacts: S from flight to flight, with the noise of two angles over the flight's time.
        noise = random.Random(9)
        rows = [(0.5 * i, -0.3 * i + noise.gauss(0, 0.01)) for i in range(300)]
        file = self.rows("n.csv", "t,theta", rows)
        found = document(f"classify --series {file} --angle theta --rows impacts --noise 0.01")
        limit = {e["name"]: e["threshold"] for e in found["evidence"]}["residual about the phase means"]
        self.assertAlmostEqual(limit, 1.5 * 0.01 * math.sqrt(2) / 0.5, delta=1e-12)

    def test_flags_that_do_not_go_together(self):
        file = self.rows("p.csv", "t,x,y", [(0.1 * i, math.cos(i), math.sin(i)) for i in range(200)])
        for flags, said in (("--angle x --column y", "give one"), ("--degrees", "--angle COLUMN is missing"),
                            ("--swirl-rate 3", "it is of an angle (--angle COLUMN)"), ("--angle x --swirl-rate 0", "swirl-rate = 0"),
                            ("--angle z", "--angle = 'z'"), ("--angle x --symmetry 0", "symmetry"),
                            ("--angle x --alpha 0.4", "a scene and --series"), ("--angle x --spin 1", "a scene and --series")):
            for command in ("classify", "recurrence", "spectrum"):
                result = run(f"{command} --series {file} {flags}")
                self.assertEqual((result.returncode, result.stdout), (2, ""), (command, flags))
                self.assertEqual(len(result.stderr.splitlines()), 1)
                self.assertIn(said, result.stderr)

    def test_flags_of_an_angle_go_with_each_body(self):
        rows = [(i, body, round(math.degrees(0.02 * (body + 1) * i), 6)) for i in range(300) for body in (0, 1)]
        file = self.rows("bodies.csv", "frame,particle,theta", rows)
        for command in ("classify", "recurrence", "spectrum"):
            whole = run(f"{command} --series {file} --angle theta --degrees --symmetry 2 --fps 30 --each particle --json")
            self.assertEqual(whole.returncode, 0, whole.stderr)
            for number, found in enumerate(json.loads(whole.stdout)["bodies"]):
                alone = document(f"{command} --series {file} --angle theta --degrees --symmetry 2 --fps 30 --where particle={number}")
                self.assertEqual({**found, "swirl_version": 0}, {**alone, "swirl_version": 0}, command)
            missing = run(f"{command} --series {file} --degrees --fps 30 --each particle")
            self.assertEqual((missing.returncode, missing.stdout), (2, ""), command)
            self.assertIn("--angle COLUMN is missing", missing.stderr)
        proposed = next(line for line in run(f"inspect {file} --fps 30").stdout.splitlines() if line.startswith("command"))
        self.assertEqual(run(proposed.split("swirl ", 1)[1]).returncode, 0, proposed)

    def test_an_angle_known_up_to_a_side_is_noted(self):
        for sides, turn, flags in ((6, 360, "--degrees"), (4, 2 * math.pi, "")):
            angles = [0.03 * i % (2 * math.pi / sides) * turn / (2 * math.pi) for i in range(600)]
            file = self.rows("sides.csv", "t,angle", [(0.1 * i, a) for i, a in enumerate(angles)])
            self.assertIn(f"--symmetry {sides}", run(f"classify --series {file} --angle angle {flags}").stdout)
            self.assertNotIn("stays within", run(f"classify --series {file} --angle angle {flags} --symmetry {sides}").stdout)
        for name, angles in (("unwound", [0.03 * i for i in range(600)]), ("swinging", [0.7 * math.sin(0.2 * i) for i in range(600)]),
                             ("whole turns", [0.03 * i % (2 * math.pi) for i in range(600)])):
            file = self.rows("whole.csv", "t,angle", [(0.1 * i, a) for i, a in enumerate(angles)])
            self.assertNotIn("--symmetry", run(f"classify --series {file} --angle angle").stdout, name)

    def test_degrees_that_are_guessed_are_noted(self):
        for header, noted in (("t,angle", True), ("t,angle (deg)", False)):
            file = self.rows("span.csv", header, [(0.1 * i, 0.1 * i) for i in range(400)])
            said = " ".join(run(f"inspect {file}").stdout.split())
            self.assertIn("--degrees", said)
            self.assertEqual("of unwound radians leave --degrees out" in said, noted, header)

    def test_stretches_of_one_value_are_no_series(self):
        file = self.rows("holes.csv", "S", [(i / 7,) if i % 2 == 0 else (math.nan,) for i in range(400)])
        result = run(f"classify --series {file}")
        self.assertEqual(result.returncode, 2)
        self.assertIn("the longest of its stretches between 199 gaps has 1 sample; 64 or more are needed", result.stderr)


class ClassifySeries(InFolder):
    def test_each_regime_by_its_series_alone(self):
        noise = random.Random(5)
        n = 2000
        henon, (a, b) = [], (0.1, 0.1)
        for _ in range(n):
            a, b = 1 - 1.4 * a * a + b, 0.3 * a
            henon.append(a)
        regimes = {("quasi-steady", "cycle"): [[-1.0, 0.2, 0.9, 0.5][i % 4] for i in range(n)],
                   ("quasi-steady", "quasi-periodic"): [math.cos(2 * math.pi * GOLDEN * i) for i in range(n)],
                   ("chaotic", "chaotic"): henon,
                   ("undecided", "transient"): [math.exp(-i / 100) for i in range(n)]}
        for size in sized((0, 0.01), (0.01,)):
            for expected, values in regimes.items():
                file = self.series("s.csv", [v + noise.gauss(0, size) for v in values])
                found = document(f"classify --series {file}")
                self.assertEqual((found["mode"], found["kind"]), expected, size)
                self.assertEqual(found["period"], 4 if found["kind"] == "cycle" else None)
                self.assertEqual(found["largest_exponent"] is None, found["mode"] != "chaotic")
                self.assertIsNone(found["mean_S"])  # no times, no mean over time
        # Noise lowers the rate at which neighbours part: 10 % of 0.41922 (Sprott 2003, tests/references/README.md).
        found = document(f"classify --series {self.series('h.csv', henon)}")
        self.assertAlmostEqual(found["largest_exponent"], 0.41922, delta=0.02)

    def test_a_noisy_constant_is_steady_only_for_who_knows_the_noise(self):
        noise = random.Random(6)
        file = self.series("c.csv", [0.25 + noise.gauss(0, 0.0025) for _ in range(1000)])
        self.assertEqual(document(f"classify --series {file}")["mode"], "undecided")
        known = document(f"classify --series {file} --noise 0.0025")
        self.assertEqual((known["mode"], known["kind"], known["period"]), ("steady", "fixed-point", 1))

    def test_a_record_is_judged_whatever_its_start(self):
        record = self.folder / "o.h5"
        for begin in ("", "--seed 3 --speed 0.2", "--x 0.45 --vx 0.1 --spin 0.3",
                      "--point -0.0839222884192122,0.0279667948111745,-0.554206442503235,"
                      "0.889793543857900,-0.97926606"):
            self.assertEqual(run(f"simulate {STEADY} {begin} --collisions 600 --quiet -o {record}").returncode, 0)
            found = document(f"classify {record}")
            self.assertEqual(found, document(f"classify {STEADY} {begin} --transient 300 --collisions 300"))

    def test_a_record_without_a_scene_is_a_series(self):
        file = self.series("s.csv", [[-1.0, 0.2, 0.9][i % 3] for i in range(300)], [0.5 * i for i in range(300)])
        record = self.folder / "r.h5"
        run(f"recurrence --series {file} --quiet -o {record}")
        for flags in ("", "--rows impacts"):
            direct, kept = document(f"classify --series {file} {flags}"), document(f"classify {record} {flags}")
            self.assertEqual(direct, kept)
        self.assertEqual((kept["mode"], kept["period"]), ("quasi-steady", 3))
        again = self.folder / "again.h5"
        self.assertEqual(run(f"classify {record} --quiet -o {again}").returncode, 0)
        with xarray.open_dataset(again, group="mode", engine="h5netcdf") as data:
            self.assertEqual(data.attrs["mode"], "quasi-steady")

    def test_bad_input(self):
        short = self.series("short.csv", [float(i) for i in range(20)])
        series = self.series("s.csv", [float(i % 5) for i in range(100)])
        for flags, mention in ((f"--series {short}", "20 samples"),
                               (f"--series {series} --noise -1", "noise = -1: must"),
                               (f"--series {series} --rows both", "impacts, samples"),
                               (f"--series {series} --sides 6", "one"), ("--column S", "--series"),
                               (f"{series}", "--series"), (f"--series {self.folder}", "directory"),
                               (f"--series {series} --transient 99", "100 samples")):
            result = run(f"classify {flags}")
            self.assertEqual((result.returncode, result.stdout), (2, ""), flags)
            self.assertIn(mention, result.stderr, flags)


class BadInput(InFolder):
    def check(self, arguments, *mentions, commands=("recurrence", "spectrum"), **options):
        for command in commands:
            result = run(f"{command} {arguments}", **options)
            self.assertEqual(result.returncode, 2, (command, arguments, result.stderr))
            self.assertEqual(result.stdout, "", arguments)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            for mention in mentions:
                self.assertIn(mention, result.stderr)

    def test_files(self):
        self.check(f"--series {self.folder}/none.csv", "none.csv", "No such file")
        self.check(f"--series {self.folder}", "directory")
        self.check(f"--series {self.file('empty.csv', '')}", "no rows")
        self.check(f"{self.folder}/none.h5", "none.h5", "No such file")
        self.check(f"{self.folder}", "directory")
        self.check(f"{self.file('text.h5', 'hello')}", "not an HDF5 file", "--series")
        text = self.file("text.csv", "t,S\n0,1\n1,abc\n")
        self.check(f"--series {text}", "text.csv", "line 3", "abc")
        again = self.file("again.csv", "t,S\n0,1\n0,2\n")
        self.check(f"--series {again}", "line 3", "repeats")
        record = self.folder / "steady.h5"
        run(f"spectrum {STEADY} --quiet -o {record}")
        self.check(f"{record}", "holds no impacts")

    def test_columns(self):
        file = self.file("c.csv", "t,S,x\n0,1,2\n1,2,3\n2,4,1\n")
        self.check(f"--series {file} --column spin", "spin", "t, S, x")
        self.check(f"--series {file} --time 7", "--time", "7", "t, S, x")
        self.check("--column S", "--series")
        self.check(f"--series {file} --column S {STEADY}", "one")
        self.check(f"--series {file} somewhere.h5", "one")
        self.check("", "nothing to analyse")

    def test_recurrence_options(self):
        file = REFERENCES / "rossler_250.txt"
        for flags, mentions in {
                "--threshold -1": ("threshold", "-1"), "--threshold nan": ("threshold", "nan"),
                "--threshold 0.1,x": ("threshold", "x"), "--threshold-std inf": ("threshold-std", "inf"),
                "--recurrence-rate 0": ("recurrence-rate", "0"), "--recurrence-rate 1.5": ("recurrence-rate", "1.5"),
                "--threshold 1 --threshold-std 0.1": ("only one",), "--dimension 0": ("dimension", "0"),
                "--delay 0": ("delay", "0"), "--dimension 40 --delay 7": ("250", "273"),
                "--theiler 250": ("theiler", "250"), "--theiler -1": ("theiler", "-1"),
                "--min-diagonal 0": ("min-diagonal", "0"), "--norm taxi": ("norm", "taxi", "manhattan"),
                "--convention R": ("convention", "pyunicorn"), "--image 10": ("--image", "-o"),
                "--image 999 --json": ("--image", "999", "1 to 250"),
                "--image 3 --json --threshold 0.1,0.2": ("--image takes one threshold",),
                "--image 3 --json --threshold-std 0.1 --threshold-std 0.2": ("--image takes one threshold",),
                "--resample 0": ("resample", "0"),
                "--observable psi": ("observable", "--column"), "--cross no.csv": ("no.csv",),
                "--period -1": ("period", "-1")}.items():
            self.check(f"--series {file} {flags}", *mentions, commands=["recurrence"])
        self.check(f"{STEADY} --observable zeta", "zeta", "psi", commands=["recurrence"])
        self.check(f"{CHATTER} --observable chi", "chi", commands=["recurrence"])

    def test_spectrum_options(self):
        file = REFERENCES / "rossler_250.txt"
        for flags, mentions in {
                "--window boxcar": ("window", "boxcar", "hann"), "--overlap 1": ("overlap", "1"),
                "--overlap nan": ("overlap", "nan"), "--segments 0": ("segments", "0"),
                "--segments 200": ("segments", "200"), "--bins 64": ("--bins",),
                "--detrend cubic": ("detrend", "cubic"),
                "--resample 1e-9": ("spacing = 1e-09: must be at least 9.", "e-07"),
                "--frame container": ("frame", "orbit"),
                "--resample -1": ("resample", "-1"), "--observable x": ("observable", "--column")}.items():
            self.check(f"--series {file} {flags}", *mentions, commands=["spectrum"])
        for bins in ("1", "7", "16777217", "268435456"):
            self.check(f"{STEADY} --bins {bins}", "--bins", bins, "8 to 16777216", commands=["spectrum"])
        self.check(f"{STEADY} --frame moon", "frame", "moon", "laboratory", commands=["spectrum"])
        self.check(f"{STEADY} --observable psi", "psi", "position", commands=["spectrum"])
        self.check(f"--series {self.series('short.csv', [1.0, 2.0, 3.0])}", "3 samples", commands=["spectrum"])
        record = self.folder / "thin.h5"
        run(f"simulate {STEADY} --every 2 --quiet -o {record}")
        self.check(f"{record}", "every 2", commands=["spectrum"])

    def test_counts_beyond_what_there_is(self):
        file = self.series("s.csv", [float(i % 7) for i in range(100)])
        self.check(f"--series {file} --transient 99", "100 samples")
        self.check(f"--series {file} --transient 50 --collisions 51", "100 samples", "need 101")
        record = self.folder / "o.h5"
        run(f"simulate {STEADY} --collisions 50 --quiet -o {record}")
        self.check(f"{record} --transient 50", "50 impacts")

    def test_nothing_is_written(self):
        file = self.file("bad.csv", "1\nx\n")
        self.check(f"--series {file} -o {self.folder}/out.h5", "line 2")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["bad.csv"])


class Input(InFolder):
    def test_a_series_comes_from_standard_input_too(self):
        values = (REFERENCES / "rossler_250.txt").read_text()
        piped = document("recurrence --series - --threshold 1", input=values)
        from_file = document(f"recurrence --series {REFERENCES / 'rossler_250.txt'} --threshold 1")
        self.assertEqual(piped["RR"], from_file["RR"])

    def test_accuracy_belongs_to_the_orbit(self):
        flags = f"{STEADY} --transient 500 --collisions 100 --threshold 1e-6"
        self.assertEqual(document(f"recurrence {flags} --accuracy quad")["RC"], 1)
        self.assertEqual(run(f"recurrence --series {REFERENCES / 'rossler_250.txt'} --accuracy quad").returncode, 2)

    def test_an_interrupted_orbit_leaves_nothing_half_done(self):
        for command in ("recurrence", "spectrum"):
            arguments = f"{command} {CHAOTIC} --collisions 100000000 --quiet -o {self.folder}/long.h5"
            self.assertEqual(interrupted(arguments, 0.5), 130)
            self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
