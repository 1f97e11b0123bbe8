"""What a camera's noise leaves of a mode: camera_test.py SWIRL [--table]

Angles at 30 frames a second of four scenes, by noise, length and the swirl's frequency. --table prints all verdicts, which
the nightly test wants right; the default test takes the shortest recordings."""

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

    def verdict(self, angles, frequency, degrees, noise):
        """Wrapped, in degrees, with noise, as a tracker writes them."""
        rows = [f"{i / FRAMES:.4f},{(math.degrees(a) + noise.gauss(0, degrees)) % 360:.4f}"
                for i, a in enumerate(angles)]
        file = self.file("film.csv", "\n".join(["t,theta"] + rows) + "\n")
        return document(f"classify --series {file} --angle theta --degrees --swirl-rate {2 * math.pi * frequency!r}")

    def check(self, frequencies, noises, lengths, table=None):
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
                    wrong += [(scene, frequency, degrees, mode) for mode in found if mode != expected]
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
        self.assertEqual(found["evidence"][0]["name"], "noise of the angle in radians")


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
