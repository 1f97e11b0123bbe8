"""`swirl simulate --camera`: what a tracker would write of a known orbit, and what is read of it: film_test.py SWIRL ROOT"""

import csv
import json
import math
import shlex
import sys
import unittest
from pathlib import Path

from driving import InFolder, document, run
from shown_commands import in_blocks

PAGE = (Path(sys.argv.pop(1)).resolve() / "docs" / "film-to-verdict.md").read_text(encoding="utf-8")

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
#: A steady scene in a dish of 10 cm, swirled once a second.
IN_METRES = ("--sides 6 --container-radius 0.1 --swirl-radius 0.05 --polygon-radius 0.04 --swirl-rate 6.283185307179586 "
             "--mu 0.5 --restitution 0.9")


class Films(InFolder):
    def film(self, name, flags, scene=STEADY):
        path = self.folder / name
        result = run(f"simulate {scene} {flags} -o {path}")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        with open(path, newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertIn(f"film: {len(rows)} frames in {path}, ", result.stdout)
        return path, rows

    def samples(self, flags, scene=STEADY):
        return document(f"simulate {scene} {flags}")["samples"]

    def test_a_film_without_noise_is_the_orbit_rounded(self):
        _, rows = self.film("f.csv", "--time 40 --camera 5")
        samples = self.samples("--time 40 --sample 0.2")
        self.assertEqual(len(rows), len(samples))
        for row, sample in zip(rows, samples):
            number = {key: float(value) for key, value in row.items()}
            self.assertAlmostEqual(number["t"], sample["t"], delta=5.01e-4)
            self.assertAlmostEqual(number["x"], sample["x"], delta=5.01e-5)
            self.assertAlmostEqual(number["y"], sample["y"], delta=5.01e-5)
            self.assertAlmostEqual(number["mark_x"], sample["x"] + 0.4 * math.cos(sample["angle"]), delta=5.01e-5)
            self.assertAlmostEqual(number["mark_y"], sample["y"] + 0.4 * math.sin(sample["angle"]), delta=5.01e-5)
            self.assertAlmostEqual(math.remainder(number["angle"] - sample["angle"], 2 * math.pi), 0, delta=5.01e-5)
            self.assertEqual(int(row["frame"]), round(5 * sample["t"]))

    def test_noise_and_lost_frames_are_as_many_as_asked_for_and_the_seeds(self):
        clean = {row["frame"]: row for row in self.film("c.csv", "--time 800 --camera 5 --x 0.5 --vx 0.1")[1]}
        path, rows = self.film("n.csv", "--time 800 --camera 5 --noise 0.01 --lose 0.05 --x 0.5 --vx 0.1 --seed 4")
        count = len(clean)
        # Binomial: 5 standard deviations of 4001 frames.
        self.assertAlmostEqual((count - len(rows)) / count, 0.05, delta=5 * math.sqrt(0.05 * 0.95 / count))
        for key in ("x", "y", "mark_x", "mark_y"):
            off = [float(row[key]) - float(clean[row["frame"]][key]) for row in rows]
            deviation = math.sqrt(sum(v * v for v in off) / len(off))
            self.assertAlmostEqual(deviation, 0.01, delta=5 * 0.01 / math.sqrt(2 * len(off)))
            self.assertAlmostEqual(sum(off) / len(off), 0, delta=5 * 0.01 / math.sqrt(len(off)))
        again, _ = self.film("a.csv", "--time 800 --camera 5 --noise 0.01 --lose 0.05 --x 0.5 --vx 0.1 --seed 4")
        other, _ = self.film("o.csv", "--time 800 --camera 5 --noise 0.01 --lose 0.05 --x 0.5 --vx 0.1 --seed 5")
        self.assertEqual(path.read_bytes(), again.read_bytes())
        self.assertNotEqual(path.read_bytes(), other.read_bytes())

    def test_the_mean_of_S_comes_back_from_the_film(self):
        """Through angle and marks, metres and pixels, noise and lost frames; the truth is the orbit's own."""
        truth = document(f"classify {STEADY}")["mean_S"]
        plain, _ = self.film("p.csv", "--time 600 --camera 5 --noise 0.002 --lose 0.01")
        metres, _ = self.film("m.csv", "--time 100 --camera 30 --noise 0.0002 --lose 0.01", IN_METRES)
        image, rows = self.film("i.csv", "--time 100 --camera 30 --noise 0.0002 --pixels 400", IN_METRES)
        self.assertTrue(all(0 < float(row[key]) < 1300 for row in rows for key in ("x", "y", "mark_x", "mark_y")))
        settled = "--transient 1800"  # it settles after some 300 units of time
        for file, flags in ((plain, "--angle angle"), (plain, "--marks x y mark_x mark_y"),
                            (metres, "--marks x y mark_x mark_y --swirl-rate 1Hz"),
                            (metres, "--angle angle --fps 30 --time frame --swirl-rate 60rpm"),
                            (image, "--marks x y mark_x mark_y --swirl-rate 1Hz --y-down"),
                            (image, "--angle angle --swirl-rate 1Hz --y-down")):
            found = document(f"classify --series {file} {flags} {settled}")
            self.assertEqual(found["mode"], "steady", flags)
            self.assertAlmostEqual(found["mean_S"], truth, delta=1e-3, msg=flags)
        notes = "".join(document(f"classify --series {image} --angle angle --swirl-rate 1Hz {settled}")["series"]["notes"])
        self.assertIn("--y-down", notes)

    def test_marks_are_two_places_of_one_body(self):
        path, _ = self.film("m.csv", "--time 200 --camera 5 --noise 0.002")
        same = run(f"classify --series {path} --marks x y x y")
        self.assertEqual((same.returncode, same.stdout, same.stderr.count("\n")), (2, "", 1), same.stderr)
        self.assertIn("two places of the body", same.stderr)
        for flags, noted in (("x y mark_x mark_y", False), ("x y frame mark_x", True)):
            notes = "".join(document(f"classify --series {path} --marks {flags}")["series"]["notes"])
            self.assertEqual("keep theirs" in notes, noted, flags)

    def test_the_page_for_laboratories_runs_as_it_stands(self):
        commands = list(in_blocks(PAGE))
        self.assertEqual([command.split()[1] for command in commands],
                         ["simulate", "inspect", "classify", "plot", "classify", "fit"])
        for command in commands:
            result = run(command.removeprefix("swirl "), cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""), command)
        found = json.loads(run("inspect film.csv --swirl-rate 1Hz --json", cwd=self.folder).stdout)
        self.assertIn("--marks x y mark_x mark_y --y-down", found["command"])
        self.assertEqual(run(shlex.split(found["command"])[1:], cwd=self.folder).returncode, 0)
        film, truth = (json.loads(run(command.removeprefix("swirl ") + " --json", cwd=self.folder).stdout)
                       for command in (commands[2].split(" -o")[0], commands[4]))
        self.assertEqual((film["mode"], truth["mode"]), ("steady", "steady"))
        self.assertAlmostEqual(film["mean_S"], truth["mean_S"], delta=1e-3)

    def test_a_disk_has_a_mark_on_its_rim(self):
        _, rows = self.film("d.csv", "--time 10 --camera 10", "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1")
        for row in rows:
            reach = math.hypot(float(row["mark_x"]) - float(row["x"]), float(row["mark_y"]) - float(row["y"]))
            self.assertAlmostEqual(reach, 0.3, delta=2e-4)

    def test_what_is_refused(self):
        path = self.folder / "f.csv"
        for flags, said in (("--camera 5", "-o FILE.csv is missing"), (f"--camera 0 -o {path}", "camera = 0"),
                            (f"--camera 5 --sample 1 -o {path}", "give one"), (f"--camera 5 --lose 1 -o {path}", "lose = 1"),
                            (f"--camera 5 --noise -1 -o {path}", "noise = -1"), (f"--camera 5 --pixels 0 -o {path}", "pixels = 0"),
                            ("--noise 0.1", "give --camera"), ("--lose 0.1", "give --camera"),
                            (f"--camera 5 -o {self.folder}/none/f.csv", "none")):
            result = run(f"simulate {STEADY} {flags}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(said, result.stderr)
            self.assertEqual(list(self.folder.iterdir()), [])
        path.write_text("mine")
        result = run(f"simulate {STEADY} --camera 5 --time 3 -o {path}")
        self.assertEqual((result.returncode, path.read_text()), (2, "mine"))
        self.assertEqual(run(f"simulate {STEADY} --camera 5 --time 3 -o {path} --force --quiet").returncode, 0)
        self.assertTrue(path.read_text().startswith("frame,t,x,y,angle,mark_x,mark_y\n0,0.000,"))

    def test_its_document_names_what_it_depends_on(self):
        found = document(f"simulate {STEADY} --time 10 --camera 5 --noise 0.1 --seed 7 -o {self.folder}/f.csv")
        self.assertNotIn("samples", found)
        self.assertEqual({key: found["settings"][key] for key in ("camera", "noise", "lose", "seed")},
                         {"camera": 5, "noise": 0.1, "lose": 0, "seed": 7})


if __name__ == "__main__":
    unittest.main()
