"""What of a measured series is there: gaps, uneven times, times that a clock rounded, constants: gaps_test.py SWIRL"""

import math
import random
import unittest

from driving import Refusing, document, run

TURN = 2 * math.pi


class Gaps(Refusing):
    def holed(self, name, n, lost):
        """A tone of amplitude 1 at 0.3/2π cycles a row, of which a share is lost at random."""
        noise = random.Random(1)
        rows = ["nan" if noise.random() < lost else repr(math.sin(0.3 * i)) for i in range(n)]
        return self.file(name, "S\n" + "\n".join(rows) + "\n")

    def tone(self, found, frequency, amplitude=1.0, off=1e-4):
        peak = found["peaks"][0]
        self.assertAlmostEqual(peak["frequency"], frequency, delta=off)
        self.assertAlmostEqual(peak["amplitude"], amplitude, delta=0.005 * amplitude)
        self.assertEqual(found["verdict"], "lines")

    def test_more_rows_never_give_a_spectrum_less(self):
        for n, lost in ((1000, 0.02), (20000, 0.002), (20000, 0.02)):
            found = document(f"spectrum --series {self.holed('h.csv', n, lost)}")
            self.tone(found, 0.3 / TURN)
            self.assertGreaterEqual(found["segments"], 15)
        for n, lost in ((5000, 0.1), (3000, 0.5)):  # stretches of some rows
            found = document(f"spectrum --series {self.holed('h.csv', n, lost)}")
            self.assertEqual(found["method"], "lomb-scargle")
            self.tone(found, 0.3 / TURN, off=1e-6)

    def test_so_many_segments_are_made_as_are_asked_for(self):
        for n, lost in ((1000, 0.0), (1000, 0.02), (20000, 0.002)):
            file = self.holed("h.csv", n, lost)
            for k in (1, 2, 7, 16, 30):
                self.assertEqual(document(f"spectrum --series {file} --segments {k}")["segments"], k)
        few = self.file("few.csv", "S\n" + "\n".join("" if i % 10 == 9 else str(i % 4) for i in range(200)) + "\n")
        self.assertIn("between the gaps; 8 or more", run(f"spectrum --series {few} --segments 50").stderr)

    def test_rows_without_a_value_at_either_end_are_cut_off(self):
        rows = [f"{i},{math.sin(0.3 * i)!r}" for i in range(120)]
        whole = self.file("whole.csv", "t,S\n" + "\n".join(rows) + "\n")
        ends = ["-2,nan", "-1,", *rows, "120,NA"]
        cut = self.file("cut.csv", "t,S\n" + "\n".join(ends) + "\n")
        for command in ("spectrum", "recurrence", "classify"):
            a, b = document(f"{command} --series {whole}"), document(f"{command} --series {cut}")
            self.assertEqual(b["series"]["notes"], ["cut off, for no value is there: 2 rows at the beginning, 1 row at the end"])
            for found in (a, b):
                del found["series"]
            self.assertEqual(a, b)

    def test_lines_of_recurrence_end_at_gaps(self):
        """A sine of period 20 over 100 and 280 rows with 20 lost between: at lag 20 the longer stretch has 260."""
        rows = [f"{i},{math.sin(TURN * i / 20):.6f}" for i in range(400) if not 100 <= i < 120]
        file = self.file("joined.csv", "t,S\n" + "\n".join(rows) + "\n")
        found = document(f"recurrence --series {file} --threshold 0.1")
        self.assertEqual((found["Lmax"], found["settings"]["join_gaps"]), (260, False))
        joined = document(f"recurrence --series {file} --threshold 0.1 --join-gaps")
        self.assertEqual((joined["Lmax"], joined["settings"]["join_gaps"]), (360, True))
        self.assertEqual(joined["RC"], found["RC"])
        self.assertEqual(joined["RR"], found["RR"])  # the same pairs, but for those of one row with itself

    def test_of_an_orbit_there_are_none_to_join(self):
        self.refused("recurrence --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --join-gaps", "--join-gaps")

    def test_measures_are_those_of_a_plain_count_over_the_rows(self):
        noise = random.Random(7)
        x = [None if noise.random() < 0.05 else math.sin(0.37 * i) + 0.3 * math.sin(0.11 * i) for i in range(300)]
        x[0] = x[-1] = 0.5
        file = self.file("x.csv", "S\n" + "\n".join("nan" if v is None else repr(v) for v in x) + "\n")
        found = document(f"recurrence --series {file} --threshold 0.2")
        lengths = []
        for lag in range(1, 300):
            run_length = 0
            for i in range(300 - lag + 1):
                a, b = (x[i], x[i + lag]) if i + lag < 300 else (None, None)
                if a is not None and b is not None and abs(a - b) <= 0.2:
                    run_length += 1
                elif run_length:
                    lengths.append(run_length)
                    run_length = 0
        there = [v for v in x if v is not None]
        self.assertAlmostEqual(found["RR"], 2 * sum(lengths) / (len(there) * (len(there) - 1)), delta=1e-12)
        long = [n for n in lengths if n >= 2]
        self.assertAlmostEqual(found["DET"], sum(long) / sum(lengths), delta=1e-12)
        self.assertAlmostEqual(found["L"], sum(long) / len(long), delta=1e-12)
        self.assertEqual(found["Lmax"], max(lengths))

    def test_a_spectrum_bridges_what_a_verdict_bridges(self):
        """An angle of even turns and a swing, three rows lost in a thousand: classify bridges them, spectrum does."""
        rows = [f"{i / 30!r},{2.0 * i / 30 + 0.2 * math.sin(TURN * 1.5 * i / 30)!r}" for i in range(1000)
                if i not in (200, 500, 501)]
        file = self.file("angle.csv", "t,th\n" + "\n".join(rows) + "\n")
        found = document(f"spectrum --series {file} --angle th")
        self.assertEqual(found["settings"]["samples_bridged"], 3)
        self.assertEqual(document(f"classify --series {file} --angle th")["settings"]["samples_bridged"], 3)
        self.assertEqual((found["segments"], found["segments_skipped"]), (16, 0))
        swing = 0.2 * 2 * 30 * math.sin(math.pi * 1.5 / 30)  # differences over a thirtieth of a second
        self.tone(found, 1.5, swing, 1e-3)


class Uneven(Refusing):
    def rows(self, n, jitter, signal):
        noise = random.Random(2)
        times = [i + noise.uniform(-jitter, jitter) for i in range(n)]
        return self.series("uneven.csv", [signal(t) for t in times], times)

    def test_a_tone_has_its_amplitude_and_its_variance(self):
        for jitter, frequency in ((0.2, 0.4), (0.45, 0.03), (0.3, 0.25)):
            file = self.rows(1000, jitter, lambda t: math.sin(TURN * frequency * t))
            found = document(f"spectrum --series {file}")
            self.assertEqual((found["verdict"], found["method"], found["spectrum_outcome"]), ("lines", "lomb-scargle", "completed"))
            self.assertAlmostEqual(found["peaks"][0]["frequency"], frequency, delta=1e-6)
            self.assertAlmostEqual(found["peaks"][0]["amplitude"], 1, delta=1e-4)
            values = [float(line.split(",")[1]) for line in file.read_text().splitlines()[1:]]
            mean = math.fsum(values) / 1000
            self.assertAlmostEqual(found["variance"], math.fsum((v - mean) ** 2 for v in values) / 1000, delta=1e-12)
            self.assertAlmostEqual(found["variance"], 0.5, delta=0.02)  # 0.5 but for what 1000 rows scatter
            integral = math.fsum(found["power"]) * found["frequency_step"]
            self.assertAlmostEqual(integral / found["variance"], 1, delta=1e-12)

    def test_the_power_is_lomb_and_scargles(self):
        """power = variance_scale 2 P / (n frequency_step), with P by its formula, term by term."""
        noise = random.Random(4)
        times = sorted(noise.uniform(0, 200) for _ in range(150))
        values = [noise.gauss(0, 1) for _ in times]
        found = document(f"spectrum --series {self.series('p.csv', values, times)}")
        mean = math.fsum(values) / 150
        for k in range(0, len(found["power"]), 7):
            w = TURN * found["frequency"][k]
            tau = math.atan2(math.fsum(math.sin(2 * w * t) for t in times), math.fsum(math.cos(2 * w * t) for t in times)) / (2 * w)
            c, s = [math.cos(w * (t - tau)) for t in times], [math.sin(w * (t - tau)) for t in times]
            x = [v - mean for v in values]
            power = (math.fsum(a * b for a, b in zip(x, c)) ** 2 / math.fsum(a * a for a in c) +
                     math.fsum(a * b for a, b in zip(x, s)) ** 2 / math.fsum(b * b for b in s)) / 2
            scale = found["variance_scale"] * 2 / (150 * found["frequency_step"])
            self.assertAlmostEqual(found["power"][k] / scale, power, delta=1e-9 * (1 + power))

    def test_noise_has_no_lines(self):
        noise = random.Random(6)
        self.assertEqual(document(f"spectrum --series {self.rows(1500, 0.3, lambda t: noise.gauss(0, 1))}")["verdict"], "continuum")

    def test_resampling_neither_folds_nor_repeats(self):
        file = self.rows(6000, 0.2, lambda t: math.sin(TURN * 0.05 * t) + math.sin(TURN * 0.31 * t))
        coarse = document(f"spectrum --series {file} --resample 2.5")  # up to 0.2: 0.31 would fold to 0.09
        self.assertAlmostEqual(coarse["resampled"]["low_pass"], 0.2, delta=1e-12)
        self.assertEqual([round(peak["frequency"], 3) for peak in coarse["peaks"] if peak["amplitude"] > 2e-3], [0.05])
        self.assertTrue(any("low-pass took out what is above 0.2" in note for note in coarse["notes"]))
        fine = document(f"spectrum --series {file} --resample 0.25")
        self.assertLess(max(peak["frequency"] for peak in fine["peaks"]), 0.5)
        self.assertAlmostEqual(fine["resampled"]["own_nyquist"], 0.5, delta=1e-3)
        same = document(f"spectrum --series {file} --resample 1")
        self.assertEqual((same["resampled"]["low_pass"], same["method"]), (0, "welch"))
        points = document(f"recurrence --series {file} --resample 2.5")
        self.assertTrue(any("low-pass" in note for note in points["notes"]))

    def test_what_is_of_even_times_is_refused(self):
        file = self.rows(300, 0.3, math.sin)
        for flags in ("--segments 4", "--overlap 0.3", "--window hamming"):
            result = run(f"spectrum --series {file} {flags}")
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertIn("--resample DT", result.stderr)
            self.assertEqual(run(f"spectrum --series {file} --resample 1 {flags}").returncode, 0)


class Clock(Refusing):
    def test_a_body_that_turns_evenly_is_constant_whatever_the_digits_of_the_clock(self):
        for digits in (2, 3, 4, 7):
            rows = [f"{i / 30:.{digits}f},{4.2 * i % (360 if digits % 2 else 1e9):.3f}" for i in range(900)]
            file = self.file("even.csv", "t,th\n" + "\n".join(rows) + "\n")
            choice = f"--series {file} --angle th --degrees"
            for way in ("", "--swirl-rate=-2.5"):
                self.assertEqual(document(f"spectrum {choice} {way}")["spectrum_outcome"], "constant", (digits, way))
            found = document(f"recurrence {choice}")
            self.assertEqual((found["RR"], found["settings"]["threshold_is_rounding_floor"]), (1, True))
            verdict = document(f"classify {choice}")
            self.assertEqual(verdict["mode"], "steady")
            self.assertAlmostEqual(verdict["mean_S"], math.radians(4.2) * 30, delta=1e-4)

    def test_a_clock_that_was_uneven_is_kept(self):
        """The body turned evenly, rows were taken up to 10 % out of step: their times say when."""
        noise = random.Random(3)
        times = [(i + noise.uniform(-0.1, 0.1)) / 30 for i in range(600)]
        file = self.file("jitter.csv", "t,th\n" + "\n".join(f"{t!r},{2.0 * t!r}" for t in times) + "\n")
        found = document(f"recurrence --series {file} --angle th --threshold 1e-9")
        self.assertEqual(found["RR"], 1)

    def test_a_rounded_clock_is_even(self):
        rows = [f"{i / 60:.2f},{math.sin(TURN * 3 * i / 60)!r}" for i in range(1200)]
        file = self.file("sixty.csv", "t,S\n" + "\n".join(rows) + "\n")
        found = document(f"spectrum --series {file}")
        self.assertTrue(found["series"]["even"])
        self.assertAlmostEqual(found["peaks"][0]["frequency"], 3, delta=1e-3)
        self.assertAlmostEqual(found["peaks"][0]["amplitude"], 1, delta=1e-3)


class Constants(Refusing):
    def test_constants_are_constant_in_every_command(self):
        for values in (["0.3"] * 500, ["0"] * 500, ["100000.1"] * 500, ["-7"] * 200 + ["nan"] * 3 + ["-7"] * 200):
            file = self.file("c.csv", "S\n" + "\n".join(values) + "\n")
            spectrum = document(f"spectrum --series {file}")
            self.assertEqual((spectrum["spectrum_outcome"], spectrum["verdict"]), ("constant", "constant"))
            self.assertEqual(document(f"classify --series {file}")["mode"], "steady")
            for flags in ("", "--convention pyunicorn", "--convention PyRQA --threshold-std 0.5"):
                found = document(f"recurrence --series {file} {flags}")
                self.assertEqual(found["RR"], 1, flags)
                self.assertTrue(any("constant" in note for note in found["notes"]))

    def test_a_series_against_itself_has_its_main_diagonal_whatever_the_convention(self):
        file = self.series("self.csv", [math.sin(0.1 * i) + math.sin(0.271 * i) for i in range(200)])
        for flags in ("", "--convention RecurrenceAnalysis.jl", "--convention pyunicorn", "--convention PyRQA",
                      '--convention "CRP Toolbox"'):
            found = document(f"recurrence --series {file} --cross {file} --threshold 0.1 {flags}")
            self.assertEqual((found["Lmax"], found["settings"]["theiler"]), (200, 0), flags)
            self.assertEqual(document(f"recurrence --series {file} --threshold 0.1 {flags}")["settings"]["theiler"], 1)
        found = document(f"recurrence --series {file} --cross {file} --threshold 0.1 --convention pyunicorn --theiler 1")
        self.assertEqual(found["settings"]["theiler"], 1)


if __name__ == "__main__":
    unittest.main()
