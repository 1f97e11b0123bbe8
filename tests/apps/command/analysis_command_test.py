"""`swirl recurrence` and `swirl spectrum` as a user drives them. Arguments: the binary, the folder of references."""

import json
import math
import random
import shlex
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import xarray

SWIRL, SHARED = (str(Path(sys.argv.pop(1)).resolve()) for _ in range(2))
ORACLE = Path(SHARED) / "oracle"
STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # of period 8
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
CHATTER = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"
MEASURES = "RR DET L Lmax DIV ENTR LAM TT Vmax VENTR MRT RTE TREND RC".split()
GOLDEN = (math.sqrt(5) - 1) / 2


def run(arguments, **options):
    return subprocess.run([SWIRL, *shlex.split(arguments)], capture_output=True, text=True, timeout=120, **options)


def document(arguments, code=0, **options):
    result = run(arguments + " --json", **options)
    assert result.returncode == code, (arguments, result.returncode, result.stderr)
    return json.loads(result.stdout, parse_constant=lambda name: (_ for _ in ()).throw(ValueError(name)))


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def series(self, name, values, times=None):
        rows = [f"{v!r}" if times is None else f"{times[i]!r},{v!r}" for i, v in enumerate(values)]
        return self.file(name, "\n".join((["S"] if times is None else ["t,S"]) + rows) + "\n")


class PublishedRecurrence(unittest.TestCase):
    """RecurrenceAnalysis.jl's tests, which were checked against the CRP Toolbox (references.md)."""

    def check(self, arguments, published):
        found = document(f"recurrence {arguments} --dimension 3 --delay 6 --threshold 1.2")
        for name, value in published.items():
            # 16 printed digits of a sum of some hundred terms: a few tens of epsilon.
            self.assertLessEqual(abs(found[name] - value), 50 * sys.float_info.epsilon * abs(value), (arguments, name))
        return found

    def test_rossler_250(self):
        file = ORACLE / "rossler_250.txt"
        found = self.check(f"--series {file}", {
            "RR": 0.03808105520689288, "DET": 0.9990689013035382, "L": 18.1864406779661, "Lmax": 237,
            "ENTR": 3.044979404476836, "LAM": 0.9548417132216015, "TT": 3.8408239700374533})
        self.assertEqual(set(MEASURES) - set(found), set())
        self.assertEqual(found["settings"]["theiler"], 1)
        self.check(f"--series {file} --norm maximum", {
            "RR": 0.05485232067510549, "DET": 0.9941822882999354, "L": 17.477272727272727,
            "ENTR": 3.1418178182603116, "LAM": 0.9786683904330963, "TT": 4.791139240506329})

    def test_rossler_3000(self):
        file = ORACLE / "rossler_3000.txt"
        self.check(f"--series {file}", {
            "RR": 0.034497548278147744, "DET": 0.998194195442617, "L": 18.085206543485935, "Lmax": 758,
            "ENTR": 3.6108687203622942, "LAM": 0.9889573102606075, "TT": 5.380358341873697})
        self.check(f"--series {file} --rate-pairs all", {"RR": 0.034486002913931495})

    def test_rossler_has_one_answer_whatever_the_threads_and_the_file_looks_like(self):
        values = (ORACLE / "rossler_250.txt").read_text().split()
        arguments = "--dimension 3 --delay 6 --threshold 1.2"
        expected = document(f"recurrence --series {ORACLE / 'rossler_250.txt'} {arguments} --threads 1")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.csv"
            file.write_bytes("".join(f'"{i * 0.5}";"{v}";text\r\n' for i, v in enumerate(values)).encode())
            found = document(f"recurrence --series {file} --column 2 {arguments} --threads 2")
        for name in MEASURES:
            self.assertEqual(found[name], expected[name], name)


class RecurrenceOfOrbits(InFolder):
    def test_a_cycle_of_k_values_has_rc_one_over_k(self):
        found = document(f"recurrence {CYCLE} --collisions 2000 --threshold 1e-6")
        self.assertAlmostEqual(found["RC"], 1 / 8, delta=1e-15)
        self.assertEqual((found["DET"], found["Lmax"], found["outcome"]), (1, 2000 - 8, "completed"))
        whole = document(f"recurrence {CYCLE} --collisions 2000 --threshold 1e-6 --theiler 0")
        self.assertEqual(whole["MRT"], 7)  # single points 8 apart: 7 between them, as RecurrenceAnalysis.jl counts

    def test_a_steady_orbit_recurs_everywhere_and_the_document_says_which_threshold_that_was(self):
        found = document(f"recurrence {STEADY} --collisions 500")
        self.assertEqual((found["RR"], found["RC"], found["LAM"]), (1, 1, found["DET"]))
        self.assertTrue(found["settings"]["threshold_is_rounding_floor"])
        self.assertEqual(document(f"recurrence {STEADY} --collisions 500 --threshold 1e-6")["RR"], 1)

    def test_chaos_has_short_lines(self):
        found = document(f"recurrence {CHAOTIC} --collisions 2000 --observable psi,chi,vn,vt,S")
        self.assertLess(found["DET"], 0.5)
        self.assertLess(found["Lmax"], 100)

    def test_a_record_gives_what_its_scene_gives(self):
        record = self.folder / "orbit.h5"
        self.assertEqual(run(f"simulate {CHAOTIC} --collisions 600 --quiet -o {record}").returncode, 0)
        for rest in ("", "--observable psi,vt --threshold 0.2", "--observable x --dimension 2 --delay 3"):
            scene = document(f"recurrence {CHAOTIC} --transient 100 --collisions 500 {rest}")
            for way in (f"{record}", f"--record {record}"):
                found = document(f"recurrence {way} --transient 100 {rest}")
                for key in (*MEASURES, "scene", "start"):
                    self.assertEqual(found[key], scene[key], (rest, key))

    def test_angles_are_compared_as_angles(self):
        turned = [((i * GOLDEN) % 1) * 360 for i in range(300)]
        across = self.series("angle.csv", turned)
        shifted = self.series("shifted.csv", [(v + 180) % 360 for v in turned])
        for name in ("RR", "DET", "LAM", "RC"):
            found = [document(f"recurrence --series {f} --period 360 --threshold 10")[name] for f in (across, shifted)]
            self.assertAlmostEqual(found[0], found[1], delta=1e-12)
        plain = document(f"recurrence --series {across} --threshold 10")
        self.assertLess(plain["RR"], document(f"recurrence --series {across} --period 360 --threshold 10")["RR"])

    def test_chatter_is_told_with_exit_3_and_what_there_was_is_quantified(self):
        none = document(f"recurrence {CHATTER}", 3)
        self.assertEqual(none["outcome"], "in-contact")
        self.assertTrue(all(none[name] is None for name in MEASURES))
        some = document(f"recurrence {CHATTER} --transient 0", 3)
        self.assertEqual((some["outcome"], some["settings"]["points"]), ("in-contact", some["impacts"]))
        self.assertIsNotNone(some["RR"])

    def test_several_thresholds_in_one_pass_are_those_one_by_one(self):
        file = ORACLE / "rossler_250.txt"
        for flag in ("threshold", "threshold-std", "recurrence-rate"):
            together = document(f"recurrence --series {file} --{flag} 0.3,0.1 --{flag} 0.05")
            self.assertEqual(len(together["thresholds"]), 3)
            for i, value in enumerate(("0.3", "0.1", "0.05")):
                alone = document(f"recurrence --series {file} --{flag} {value}")
                self.assertEqual([together[name][i] for name in MEASURES], [alone[name] for name in MEASURES])
                self.assertEqual(together["thresholds"][i], alone["settings"]["threshold"])
        rate = document(f"recurrence --series {file} --recurrence-rate 0.05")
        self.assertAlmostEqual(rate["RR"], 0.05, delta=1 / (250 * 249 / 2))

    def test_conventions_are_the_packages(self):
        file, flags = ORACLE / "rossler_250.txt", "--dimension 3 --delay 6 --threshold 1.2"
        ours = document(f"recurrence --series {file} {flags}")
        same = document(f"recurrence --series {file} {flags} --convention recurrenceanalysis.jl")
        self.assertEqual([ours[m] for m in MEASURES], [same[m] for m in MEASURES])
        pyunicorn = document(f"recurrence --series {file} {flags} --convention pyunicorn")
        # All points over n^2: the diagonal's n are among them. No distance equals the threshold.
        n = ours["settings"]["points"]
        self.assertAlmostEqual(pyunicorn["RR"], ours["RC"], delta=1e-15)
        self.assertAlmostEqual(ours["RC"], (ours["RR"] * n * (n - 1) + n) / n**2, delta=1e-15)
        self.assertTrue(pyunicorn["settings"]["strict"])

    def test_a_series_against_itself_is_its_recurrence_matrix(self):
        values = (ORACLE / "rossler_250.txt").read_text().split()
        two = self.file("two.csv", "a b\n" + "".join(f"{v} {v}\n" for v in values))
        flags = f"--series {two} --column a --threshold 1 --theiler 1"
        whole = document(f"recurrence {flags}")
        for cross in ("--cross-column b", f"--cross {two} --cross-column 2"):
            found = document(f"recurrence {flags} {cross}")
            for name in ("RR", "DET", "L", "Lmax", "ENTR", "LAM", "TT", "MRT"):
                self.assertEqual(found[name], whole[name], name)
            self.assertIsNone(found["RC"])

    def test_the_record_opens_in_xarray_and_holds_counts_and_plot(self):
        for name in ("a.h5", "b.h5"):
            self.assertEqual(run(f"recurrence {CYCLE} --transient 3000 --collisions 400 --threshold 1e-6 --image 50 "
                                 f"--quiet -o {self.folder / name}").returncode, 0)
        self.assertEqual((self.folder / "a.h5").read_bytes(), (self.folder / "b.h5").read_bytes())
        found = document(f"recurrence {CYCLE} --transient 3000 --collisions 400 --threshold 1e-6")
        with xarray.open_dataset(self.folder / "a.h5", group="recurrence", engine="h5netcdf") as data:
            for name in MEASURES:
                value = float(data[name].values[0])
                self.assertEqual(None if math.isnan(value) else value, found[name], name)
            self.assertEqual(data["image"].shape, (50, 50))
            self.assertAlmostEqual(float(data["image"].mean()), found["RC"], delta=1e-12)
            lengths = data["diagonal_lines"].values[0]
            self.assertEqual(len(lengths) - 1, found["Lmax"])
        for group in ("/", "scene", "start", "settings"):
            xarray.open_dataset(self.folder / "a.h5", group=group, engine="h5netcdf").close()


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
        for files in (self.clean, self.noisy):
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
        for file in (*self.clean.values(), *self.noisy.values()):
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


class Spectra(InFolder):
    def test_of_a_cycle_are_lines_at_multiples_of_its_frequency(self):
        cycle = document(f"classify {CYCLE}")
        orbit = document(f"simulate {CYCLE} --collisions 4008 --skip 4000")["collisions"]
        frequency = 2 * math.pi / sum(row["flight_time"] for row in orbit)
        self.assertEqual(cycle["period"], 8)
        found = document(f"spectrum {CYCLE}")
        self.assertEqual((found["verdict"], found["outcome"]), ("lines", "completed"))
        for peak in found["peaks"][:5]:
            ratio = peak["frequency"] / frequency
            self.assertAlmostEqual(ratio, round(ratio), delta=1e-4)

    def test_of_an_orbit_integrate_to_the_variance_of_its_bins(self):
        for rest in ("", "--observable x", "--observable y --frame container", "--observable x --frame corotating"):
            found = document(f"spectrum {CHAOTIC} --collisions 1000 --bins 4096 {rest}")
            integral = math.fsum(found["power"]) * (found["frequency"][1] - found["frequency"][0])
            self.assertAlmostEqual(integral / found["variance"], 1, delta=1e-12)
            self.assertGreater(found["variance"], 0)

    def test_the_mean_square_of_S_is_that_of_its_steps(self):
        # So fine that the bins lose nothing: a bin holds at most one of the 200 steps of S(t).
        record = self.folder / "o.h5"
        self.assertEqual(run(f"simulate {CHAOTIC} --collisions 201 --quiet -o {record}").returncode, 0)
        rows = document(f"simulate {CHAOTIC} --collisions 201")["collisions"]
        whole = rows[-1]["t"] - rows[0]["t"]
        square = sum(a["spin"] ** 2 * (b["t"] - a["t"]) for a, b in zip(rows, rows[1:])) / whole
        found = document(f"spectrum {record} --bins 4194304 --detrend none --segments 1 --window rectangular")
        self.assertAlmostEqual(found["variance"] / square, 1, delta=200 / 4194304)

    def test_of_a_steady_disk_is_the_swirl_itself(self):
        found = document(f"spectrum {STEADY} --observable position")
        self.assertTrue(found["two_sided"])
        self.assertAlmostEqual(found["peaks"][0]["frequency"], 1, delta=1e-4)
        self.assertEqual(document(f"spectrum {STEADY}")["spectrum_outcome"], "constant")

    def test_uneven_times_are_resampled_and_gaps_stay_open(self):
        noise = random.Random(1)
        times = [0.0]
        for _ in range(3999):
            times.append(times[-1] + 0.01 * noise.uniform(0.5, 1.5))
        file = self.series("uneven.csv", [math.sin(2 * math.pi * 3 * t) for t in times], times)
        found = document(f"spectrum --series {file}")
        self.assertFalse(found["series"]["even"])
        self.assertIn("spacing", found["resampled"])
        self.assertAlmostEqual(found["peaks"][0]["frequency"], 3, delta=1e-3)  # in the times' unit
        lines = file.read_text().splitlines()
        gap = self.file("gap.csv", "\n".join(lines[:2000] + lines[2300:]) + "\n")
        found = document(f"spectrum --series {gap} --resample 0.01")
        self.assertEqual(found["resampled"]["gaps"], 1)
        self.assertGreater(found["segments_skipped"], 0)
        self.assertAlmostEqual(found["peaks"][0]["frequency"], 3, delta=1e-3)

    def test_chatter_is_told_with_exit_3(self):
        found = document(f"spectrum {CHATTER}", 3)
        self.assertEqual((found["outcome"], found["power"], found["peaks"]), ("in-contact", [], []))
        self.assertEqual(document(f"spectrum {CHATTER} --transient 0", 3)["outcome"], "in-contact")

    def test_the_record_opens_in_xarray(self):
        record = self.folder / "s.h5"
        found = document(f"spectrum {CYCLE} -o {record}")
        with xarray.open_dataset(record, group="spectrum", engine="h5netcdf") as data:
            self.assertEqual(list(data["frequency"].values), found["frequency"])
            self.assertEqual(list(data["power"].values), found["power"])
        with xarray.open_dataset(record, group="peaks", engine="h5netcdf") as data:
            self.assertEqual(data.sizes["peak"], len(found["peaks"]))


class UnevenRecurrence(InFolder):
    def test_what_was_done_is_said(self):
        times = [i + (0.3 if i % 2 else 0) for i in range(400)]
        file = self.series("uneven.csv", [math.sin(0.3 * t) for t in times], times)
        plain = document(f"recurrence --series {file}")
        self.assertFalse(plain["series"]["even"])
        self.assertTrue(any("uneven" in note for note in plain["notes"]))
        even = document(f"recurrence --series {file} --resample 1")
        self.assertEqual((even["notes"], even["resampled"]["spacing"], even["settings"]["points"]), ([], 1, 400))

    def test_gaps_leave_out_the_points_that_embed_across_them(self):
        values = [f"{math.sin(0.3 * i)!r}" for i in range(400)]
        whole = self.file("whole.csv", "\n".join(values) + "\n")
        values[100] = values[101] = "nan"
        holed = self.file("holed.csv", "\n".join(values) + "\n")
        found = document(f"recurrence --series {holed} --dimension 3 --delay 5")
        self.assertEqual(found["series"]["missing"], 2)
        self.assertEqual(found["settings"]["points_left_out"], 6)  # each sample is in three points
        self.assertEqual(found["settings"]["points"], 400 - 10 - 6)
        self.assertTrue(any("gap" in note for note in found["notes"]))
        self.assertEqual(document(f"recurrence --series {whole} --dimension 3 --delay 5")["notes"], [])


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
        for size in (0, 0.01):
            for expected, values in regimes.items():
                file = self.series("s.csv", [v + noise.gauss(0, size) for v in values])
                found = document(f"classify --series {file}")
                self.assertEqual((found["mode"], found["kind"]), expected, size)
                self.assertEqual(found["period"], 4 if found["kind"] == "cycle" else None)
                self.assertEqual(found["largest_exponent"] is None, found["mode"] != "chaotic")
                self.assertIsNone(found["mean_S"])  # no times, no mean over time
        # Noise lowers the rate at which neighbours part: 10 % of 0.41922 (references.md).
        found = document(f"classify --series {self.series('h.csv', henon)}")
        self.assertAlmostEqual(found["largest_exponent"], 0.41922, delta=0.02)

    def test_a_noisy_constant_is_steady_only_for_who_knows_the_noise(self):
        noise = random.Random(6)
        file = self.series("c.csv", [0.25 + noise.gauss(0, 0.0025) for _ in range(1000)])
        self.assertEqual(document(f"classify --series {file}")["mode"], "undecided")
        known = document(f"classify --series {file} --noise 0.0025")
        self.assertEqual((known["mode"], known["kind"], known["period"]), ("steady", "fixed-point", 1))

    def test_a_record_is_followed_on_from_its_scene_and_start(self):
        record = self.folder / "o.h5"
        for start in ("", "--seed 3 --speed 0.2", "--x 0.45 --vx 0.1 --spin 0.3",
                      "--point -0.0839222884192122,0.0279667948111745,-0.554206442503235,"
                      "0.889793543857900,-0.97926606"):
            self.assertEqual(run(f"simulate {STEADY} {start} --collisions 5 --quiet -o {record}").returncode, 0)
            found, scene = document(f"classify {record}"), document(f"classify {STEADY} {start}")
            found.pop("swirl_version"), scene.pop("swirl_version")
            self.assertEqual(found, scene)
        self.assertIn("followed", run(f"classify {record}").stderr)

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
        for flags, mention in ((f"--series {short}", "20 samples"), (f"--series {series} --noise -1", "noise"),
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
        file = ORACLE / "rossler_250.txt"
        for flags, mentions in {
                "--threshold -1": ("threshold", "-1"), "--threshold nan": ("threshold", "nan"),
                "--threshold 0.1,x": ("threshold", "x"), "--threshold-std inf": ("threshold-std", "inf"),
                "--recurrence-rate 0": ("recurrence-rate", "0"), "--recurrence-rate 1.5": ("recurrence-rate", "1.5"),
                "--threshold 1 --threshold-std 0.1": ("only one",), "--dimension 0": ("dimension", "0"),
                "--delay 0": ("delay", "0"), "--dimension 40 --delay 7": ("250", "273"),
                "--theiler 250": ("theiler", "250"), "--theiler -1": ("theiler", "-1"),
                "--min-diagonal 0": ("min-diagonal", "0"), "--norm taxi": ("norm", "taxi", "manhattan"),
                "--convention R": ("convention", "pyunicorn"), "--image 10": ("--image", "-o"),
                "--image 999 --json": ("pixels", "999"), "--resample 0": ("resample", "0"),
                "--observable psi": ("observable", "--column"), "--cross no.csv": ("no.csv",),
                "--period -1": ("period", "-1")}.items():
            self.check(f"--series {file} {flags}", *mentions, commands=["recurrence"])
        self.check(f"{STEADY} --observable zeta", "zeta", "psi", commands=["recurrence"])
        self.check(f"{CHATTER} --observable chi", "chi", commands=["recurrence"])
        constant = self.series("constant.csv", [1.5] * 20)
        self.check(f"--series {constant}", "constant", "--threshold", commands=["recurrence"])

    def test_spectrum_options(self):
        file = ORACLE / "rossler_250.txt"
        for flags, mentions in {
                "--window boxcar": ("window", "boxcar", "hann"), "--overlap 1": ("overlap", "1"),
                "--overlap nan": ("overlap", "nan"), "--segments 0": ("segments", "0"),
                "--segments 200": ("segments", "200"), "--bins 64": ("--bins",),
                "--detrend cubic": ("detrend", "cubic"),
                "--resample -1": ("resample", "-1"), "--observable x": ("observable", "--column")}.items():
            self.check(f"--series {file} {flags}", *mentions, commands=["spectrum"])
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
        values = (ORACLE / "rossler_250.txt").read_text()
        piped = document("recurrence --series - --threshold 1", input=values)
        self.assertEqual(piped["RR"], document(f"recurrence --series {ORACLE / 'rossler_250.txt'} --threshold 1")["RR"])

    def test_accuracy_belongs_to_the_orbit(self):
        flags = f"{STEADY} --transient 500 --collisions 100 --threshold 1e-6"
        self.assertEqual(document(f"recurrence {flags} --accuracy quad")["RC"], 1)
        self.assertEqual(run(f"recurrence --series {ORACLE / 'rossler_250.txt'} --accuracy quad").returncode, 2)

    def test_an_interrupted_orbit_leaves_nothing_half_done(self):
        for command in ("recurrence", "spectrum"):
            process = subprocess.Popen([SWIRL, *shlex.split(f"{command} {CHAOTIC} --collisions 100000000 --quiet -o "
                                                            f"{self.folder}/long.h5")])
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            self.assertEqual(list(self.folder.iterdir()), [])

    def test_examples_of_the_help_run(self):
        for command in ("recurrence", "spectrum"):
            examples = [line.split("swirl ", 1)[1] for line in run(f"{command} --help").stdout.splitlines()
                        if line.startswith("  swirl ")]
            self.assertEqual(len(examples), 2)
            for example in examples:
                self.assertEqual(run(example, cwd=self.folder).returncode, 0, example)


if __name__ == "__main__":
    unittest.main()
