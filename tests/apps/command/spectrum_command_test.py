"""swirl spectrum, from outside: spectrum_command_test.py SWIRL"""

import math
import random
import unittest

import xarray

from driving import InFolder, document, run

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # of period 8
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
CHATTER = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"


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

    def test_of_a_cycle_have_its_harmonics_and_nothing_else(self):
        """Bins divide the period: jumps of S fold onto harmonics. Between them is rounding, below 1e-20 of the strongest line."""
        found = document(f"spectrum {CYCLE}")
        harmonics = [peak["harmonic"] for peak in found["peaks"]]
        self.assertEqual(sorted(harmonics), list(range(1, len(harmonics) + 1)))
        self.assertTrue(all(not peak["folded"] for peak in found["peaks"]))
        strongest = max(found["power"])
        reach = 2.5 * found["frequency_step"]  # a line is three bins wide (Hann)
        between = [power for frequency, power in zip(found["frequency"], found["power"])
                   if abs(frequency - round(frequency / found["fundamental"]) * found["fundamental"]) > reach]
        self.assertGreater(len(between), 1000)
        self.assertLess(max(between), 1e-20 * strongest)
        period = found["settings"]["cycle_time"] / found["fundamental"]
        self.assertAlmostEqual(period / found["settings"]["spacing"], 64, delta=1e-9)  # eight bins an impact

    def test_in_bins_of_their_own_width_folded_harmonics_are_told(self):
        found = document(f"spectrum {CYCLE} --bins 65536")
        folded = [peak for peak in found["peaks"] if peak["folded"]]
        self.assertGreater(len(folded), 100)
        sampling = found["settings"]["cycle_time"] / found["settings"]["spacing"]
        for peak in folded[:20]:  # k f1 = m sampling ± f
            self.assertIsNone(peak["harmonic"])
            ways = [(m * sampling + sign * peak["frequency"]) / found["fundamental"] for m in range(1, 40) for sign in (1, -1)]
            step = found["frequency_step"] / found["fundamental"]
            self.assertLess(min(abs(way - round(way)) for way in ways), 0.05 * step)
        said = run(f"spectrum {CYCLE} --bins 65536").stdout
        self.assertIn(f"and {len(folded)} folded: harmonics of the cycle above", said)
        self.assertIsNone(document(f"spectrum {CHAOTIC} --collisions 1000")["fundamental"])

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

    def test_uneven_times_have_their_lines_and_gaps_stay_open(self):
        noise = random.Random(1)
        times = [0.0]
        for _ in range(3999):
            times.append(times[-1] + 0.01 * noise.uniform(0.5, 1.5))
        file = self.series("uneven.csv", [math.sin(2 * math.pi * 3 * t) for t in times], times)
        found = document(f"spectrum --series {file}")
        self.assertFalse(found["series"]["even"])
        self.assertNotIn("resampled", found)
        self.assertAlmostEqual(found["peaks"][0]["frequency"], 3, delta=1e-6)  # in the times' unit
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


if __name__ == "__main__":
    unittest.main()
