"""What a camera's noise and rounding leave of a mode: camera_test.py SWIRL [--table]

Angles at 30 frames a second of four scenes, by noise, length and the swirl's frequency. --table prints all verdicts: none
may be wrong, and of a steady body, or where ten minutes were filmed, none undecided. By default the shortest recordings,
with times and angles as coarsely rounded as trackers write them, with and without noise, with lost frames."""

import math
import random
import sys
import unittest

import xarray

from driving import InFolder, document, run

FRAMES = 30
SCENES = {
    "steady": "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9",
    "8-cycle": "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95",
    "torus": "--sides 4 --alpha 0.52 --beta 0.46 --mu 0.6 --restitution 0.75",
    "chaotic": "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1",
}
MODES = {"steady": "steady", "8-cycle": "quasi-steady", "torus": "quasi-steady", "chaotic": "chaotic"}
SETTLED = 2000  # time units that are waited for


class Camera(InFolder):
    def angles(self, scene, frequency, minutes):
        """θ at the frames, in radians, after what it takes to settle."""
        step = 2 * math.pi * frequency / FRAMES
        count = 60 * FRAMES * minutes
        record = self.folder / "film.h5"
        result = run(f"simulate {SCENES[scene]} --time {SETTLED + step * (count + 2)} --sample {step} --quiet "
                     f"-o {record}")
        self.assertEqual(result.returncode, 0, result.stderr)
        with xarray.open_dataset(record, group="samples", engine="h5netcdf") as data:
            settled = int((data["t"].values < SETTLED).sum())
            angles = data["angle"].values[settled:settled + count]
        record.unlink()
        return angles

    def verdict(self, angles, frequency, degrees, noise, digits=4, time_digits=4, lost=()):
        """Wrapped, in degrees, with noise, as a tracker writes them."""
        rows = [f"{i / FRAMES:.{time_digits}f},{(math.degrees(a) + noise.gauss(0, degrees)) % 360:.{digits}f}"
                for i, a in enumerate(angles) if i not in lost]
        file = self.file("film.csv", "\n".join(["t,theta"] + rows) + "\n")
        return document(f"classify --series {file} --angle theta --degrees --swirl-rate {2 * math.pi * frequency!r}")

    def check(self, frequencies, noises, lengths, table=None):
        """None wrong; undecided only what is shorter than ten minutes and not steady."""
        noise = random.Random(1)
        wrong = []
        for scene, expected in MODES.items():
            for frequency in frequencies:
                angles = self.angles(scene, frequency, max(lengths))
                for degrees in noises:
                    found = [self.verdict(angles[:60 * FRAMES * minutes], frequency, degrees, noise)["mode"]
                             for minutes in lengths]
                    if table:
                        table(scene, frequency, degrees, found)
                    wrong += [(scene, frequency, degrees, minutes, mode) for minutes, mode in zip(lengths, found)
                              if mode != expected and (mode != "undecided" or scene == "steady" or minutes >= 10)]
        self.assertEqual(wrong, [])


class Minute(Camera):
    def test_a_minute_is_enough(self):
        self.check((1,), (0.1, 2), (1,))

    def test_the_rate_and_the_noise_are_measured(self):
        angles = self.angles("steady", 1, 1)
        found = self.verdict(angles, 1, 1, random.Random(2))
        count, step = 60 * FRAMES, 2 * math.pi / FRAMES
        error = math.radians(1) * math.sqrt(12) / (step * count**1.5)  # of the slope
        self.assertAlmostEqual(found["mean_S"], (angles[-1] - angles[0]) / (step * (count - 1)), delta=5 * error)
        self.assertAlmostEqual(math.degrees(found["evidence"][0]["value"]), 1, delta=0.2)  # of 150 powers: 3 sigma
        self.assertEqual(found["evidence"][0]["name"], "white level of the angle in radians")

    def test_rounding_makes_no_mode(self):
        noise = random.Random(3)
        decided = 0
        for scene, expected in MODES.items():
            angles = self.angles(scene, 1, 1)
            for digits, time_digits, degrees in ((12, 12, 0), (12, 3, 0), (2, 2, 0), (1, 3, 0), (0, 3, 0), (0, 2, 0.1),
                                                 (1, 2, 0.1), (2, 3, 0.1), (0, 3, 1)):
                found = self.verdict(angles, 1, degrees, noise, digits, time_digits)
                self.assertIn(found["mode"], (expected, "undecided"), (scene, digits, time_digits, degrees))
                decided += found["mode"] == expected
                if scene == "steady":
                    self.assertEqual(found["mode"], "steady", (digits, time_digits, degrees))
                    # The line's ends are known to the last digit of the angle and of the time, or to the noise.
                    ends = math.radians(10.0**-digits + degrees) / (2 * math.pi * 60) + 10.0**-time_digits / 60
                    self.assertAlmostEqual(found["mean_S"], (angles[-1] - angles[0]) / (2 * math.pi / FRAMES * 1799),
                                           delta=ends + 1e-9)
        self.assertGreaterEqual(decided, 30)  # of 36: it is not all left open

    def test_lost_frames_are_bridged(self):
        noise = random.Random(4)
        lost = {i for i in range(2, 1798) if noise.random() < 0.01}
        for scene, expected in MODES.items():
            found = self.verdict(self.angles(scene, 1, 1), 1, 0.1, noise, lost=lost)
            self.assertIn(found["mode"], (expected, "undecided"), scene)
            self.assertEqual(found["settings"]["samples_used"], 1800, scene)
            self.assertEqual(found["settings"]["samples_bridged"], len(lost), scene)
            if scene != "torus":
                self.assertEqual(found["mode"], expected)

    def test_a_pause_parts_a_film(self):
        angles = self.angles("steady", 1, 2)
        found = self.verdict(angles, 1, 0.1, random.Random(5), lost=set(range(700, 2900)))
        self.assertEqual((found["mode"], found["settings"]["samples_used"]), ("steady", 700))
        self.assertEqual(found["series"]["gaps"], 1)

    def test_turns_of_nearly_half_a_period_are_no_verdict(self):
        noise = random.Random(6)
        angles = [0.97 * math.pi * i + noise.gauss(0, 0.05) for i in range(1800)]
        found = self.verdict(angles, 1, 0, noise)
        self.assertEqual((found["mode"], found["mean_S"]), ("undecided", None))
        self.assertGreater(found["series"]["largest_turn"], 0.99)
        text = run(f"classify --series {self.folder / 'film.csv'} --angle theta --degrees").stdout
        self.assertIn("their direction is a guess", text)
        self.assertIn("which way is a guess", text)

    def test_a_film_of_few_frames_is_undecided(self):
        found = self.verdict(self.angles("8-cycle", 1, 1)[:400], 1, 0, random.Random(7))
        self.assertEqual(found["mode"], "undecided")
        self.assertEqual(found["evidence"][-1]["value"], 400)


class Table(Camera):
    def test_every_length_noise_and_swirl(self):
        lengths = (1, 3, 10, 30)
        print(f"{'scene':8} {'Hz':>4} {'noise':>6}  " + "".join(f"{minutes:>3} min        " for minutes in lengths))
        self.check((0.5, 1, 2, 3), (0.1, 0.5, 1, 2), lengths,
                   lambda scene, hertz, degrees, found:
                   print(f"{scene:8} {hertz:>4} {degrees:>5}°  " + "".join(f"{mode:15}" for mode in found), flush=True))


if __name__ == "__main__":
    table = "--table" in sys.argv
    if table:
        sys.argv.remove("--table")
    unittest.main(defaultTest="Table" if table else "Minute")
