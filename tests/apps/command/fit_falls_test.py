"""swirl fit --falls, from outside: fit_falls_test.py SWIRL

Films of bodies that fall on a plate: parabolas in closed form, impacts by Routh's diagram in plain Python (impact_tables.py),
a tracker's noise and digits."""

import math
import os
import signal
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import h5py
import numpy
from driving import InFolder, Refusing, document, run, sized, start
from impact_tables import after

E, MU, TILT, SIDE, SIDES = 0.6, 0.2, 0.05, 0.06, 4
RADIUS = SIDE / (2 * math.sin(math.pi / SIDES))
INERTIA = SIDE * SIDE / 6
GRAVITY, FPS = 9.81, 250


def at(body, time):
    (x, y, angle), (vx, vy, spin) = body
    return (x + vx * time, y + vy * time - GRAVITY * time * time / 2, angle + spin * time), (vx, vy - GRAVITY * time, spin)


def lowest(place):
    """Height of the lowest vertex above the plate through the origin, and where it is from the centre."""
    arms = [(RADIUS * math.cos(a), RADIUS * math.sin(a)) for a in (place[2] + 2 * math.pi * i / SIDES for i in range(SIDES))]
    return min((math.cos(TILT) * (place[1] + arm[1]) - math.sin(TILT) * (place[0] + arm[0]), arm) for arm in arms)


def next_impact(body, step=5e-4):
    if lowest(at(body, step)[0])[0] < 0:
        return math.inf  # it stays on the plate
    time = step
    while lowest(at(body, time + step)[0])[0] >= 0:
        time += step
    low, high = time, time + step
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (low, middle) if lowest(at(body, middle)[0])[0] < 0 else (middle, high)
    return low


def struck(body):
    place, (vx, vy, spin) = body
    c, s = math.cos(TILT), math.sin(TILT)
    arm = lowest(place)[1]
    r = (c * arm[0] + s * arm[1], c * arm[1] - s * arm[0])
    ahead, up, turn = after((c * vx + s * vy, c * vy - s * vx, spin), r, INERTIA, E, MU)
    return place, (c * ahead - s * up, s * ahead + c * up, turn)


def fall(seed, noise=5e-5, seconds=0.5):
    """Rows x, y, theta; it lies still where it does not leave the plate any more."""
    draw = numpy.random.Generator(numpy.random.Philox(seed))
    even = draw.uniform
    body = ((even(0, 0.1), RADIUS * even(2.5, 4), even(0, 6)), (even(-0.6, 0.6), even(-0.6, 0), even(-8, 8)))
    begin, end, rows = 0.0, next_impact(body), []
    for i in range(int(seconds * FPS)):
        while begin + end < i / FPS:
            body = struck(at(body, end))
            begin, end = begin + end, next_impact(body)
        place = body[0] if math.isinf(end) else at(body, i / FPS - begin)[0]
        x, y, angle = (p + s * draw.normal() for p, s in zip(place, (noise, noise, 20 * noise)))
        rows.append(f"{x:.6f},{y:.6f},{angle:.5f}")
    return rows


FLAGS = f"--position x y --angle theta --fps {FPS} --sides {SIDES} --side {SIDE}"
FEW = sized("--resamples 40", "--resamples 20")


class WithFalls:
    def written(self, count, name="fall", **options):
        paths = []
        for seed in range(count):
            path = self.folder_of_falls() / f"{name}{seed}.csv"
            path.write_text("x,y,theta\n" + "\n".join(fall(seed, **options)) + "\n")
            paths.append(str(path))
        return " ".join(paths)


class Truth(WithFalls, InFolder):
    def folder_of_falls(self):
        return self.folder

    def test_gravity_plate_and_law(self):
        files = self.written(8)
        found = document(f"fit --falls {files} {FLAGS} {FEW}")
        falls = found["falls"]
        self.assertEqual(falls["falls"], 8)
        self.assertAlmostEqual(-falls["gravity"][1], GRAVITY, delta=4 * falls["gravity_error"][1])
        self.assertLess(falls["gravity_error"][1], 0.05)
        self.assertAlmostEqual(falls["plate_tilt"], TILT, delta=0.003)
        self.assertAlmostEqual(falls["polygon_radius"], RADIUS, delta=1e-9)
        self.assertAlmostEqual(falls["place_noise"], 5e-5, delta=1e-5)
        for name, truth in (("restitution", E), ("friction", MU), ("inertia", INERTIA)):
            number = found[name]
            room = number["high"] - number["low"]
            self.assertLess(abs(number["value"] - truth), 1.5 * room, (name, number))
            self.assertLess(room, 0.15 * number["value"], name)
        self.assertGreater(found["predicted"], 0.7)
        self.assertEqual([part["part"] for part in found["subsets"]],
                         ["odd falls", "even falls", "first half", "second half", "first impacts", "later impacts"]
                         + [f"division {division}" for division in (1, 3, 10, 30) if division != falls["division"]])
        self.assertFalse(falls["angle_turned"])
        self.assertLess(found["energy_ratio"], 0.9)
        self.assertEqual(found["energy_rises"], 0)
        given = document(f"fit --falls {files} {FLAGS} {FEW} --gravity 9.81 --inertia-factor {INERTIA / RADIUS ** 2}")
        self.assertEqual(given["falls"]["gravity_error"], [0, 0])
        self.assertAlmostEqual(given["inertia"]["low"], INERTIA, delta=1e-12)
        shown = run(f"fit --falls {files} {FLAGS} {FEW}").stdout
        for words in ("8 falls", "gravity", "plate", "by clear impacts", "of a uniform body", "parts of the impacts"):
            self.assertIn(words, shown)

    def test_the_answer_is_the_same_whatever_threads_and_environment(self):
        """A longer environment moves the stack, where what nobody has set would be read."""
        files = self.written(6, name="same")
        answers = {run(f"fit --falls {files} {FLAGS} {FEW} --json --threads {threads}", env={**os.environ, "LONGER": 17 * threads * "x"}).stdout
                   for threads in sized((1, 2, 3), (1, 3))}
        self.assertEqual(len(answers), 1)
        self.assertIn("restitution", answers.pop())

    def test_neither_order_nor_origin_count(self):
        files = self.written(6, name="order").split()
        far = []
        for path in files:
            rows = [line.split(",") for line in Path(path).read_text().splitlines()[1:]]
            far.append(self.folder / f"far{len(far)}.csv")
            far[-1].write_text("x,y,theta\n" + "".join(f"{float(x) + 1e4:.6f},{float(y) - 1e4:.6f},{angle}\n" for x, y, angle in rows))
        here, backwards, there = (document(f"fit --falls {' '.join(map(str, falls))} {FLAGS} {FEW}")
                                  for falls in (files, files[::-1], far))
        for found in (backwards, there):
            for name in ("restitution", "friction", "inertia"):
                for end in ("value", "low", "high"):
                    # To the bit by order; a place beyond 1e4 has some 1e-12 of it left, a millionth of a digit.
                    self.assertAlmostEqual(found[name][end], here[name][end], delta=0 if found is backwards else 1e-6 * here[name][end])
        self.assertAlmostEqual(there["falls"]["plate_height"] - here["falls"]["plate_height"],
                               -1e4 * (math.cos(TILT) + math.sin(TILT)), delta=30)  # its tilt is known to 0.003

    def test_an_angle_in_the_other_sense(self):
        files = self.written(6, name="sense").split()
        for k, change in enumerate(sized([lambda x, y, angle: (-x, y, angle), lambda x, y, angle: (x, y, -angle)],
                                         [lambda x, y, angle: (-x, y, angle)])):
            mirrored = []
            for path in files:
                rows = [tuple(map(float, line.split(","))) for line in Path(path).read_text().splitlines()[1:]]
                mirrored.append(self.folder / f"mirrored{k}_{len(mirrored)}.csv")
                mirrored[-1].write_text("x,y,theta\n" + "".join("%.6f,%.6f,%.5f\n" % change(*row) for row in rows))
            found = document(f"fit --falls {' '.join(map(str, mirrored))} {FLAGS} {FEW}")
            self.assertTrue(found["falls"]["angle_turned"])
            self.assertTrue(any("other sense" in note for note in found["notes"]), found["notes"])
            self.assertAlmostEqual(found["restitution"]["value"], E, delta=0.03)
            self.assertAlmostEqual(found["friction"]["value"], MU, delta=0.03)

    def test_an_image_has_its_axis_down(self):
        for path in map(Path, self.written(6, name="down").split()):
            rows = [line.split(",") for line in path.read_text().splitlines()[1:]]
            path.write_text("x,y,theta\n" + "".join(f"{x},{0.2 - float(y)},{-float(angle)}\n" for x, y, angle in rows))
        files = " ".join(str(self.folder / f"down{i}.csv") for i in range(6))
        wrong = run(f"fit --falls {files} {FLAGS} {FEW}")
        self.assertEqual(wrong.returncode, 2)
        self.assertIn("give --y-down", wrong.stderr)
        upright = run(f"fit --falls {self.written(6, name='up')} {FLAGS} {FEW} --y-down")
        self.assertEqual(upright.returncode, 2)
        self.assertIn("leave out --y-down", upright.stderr)
        found = document(f"fit --falls {files} {FLAGS} {FEW} --y-down")
        self.assertAlmostEqual(found["restitution"]["value"], E, delta=0.03)
        self.assertAlmostEqual(found["friction"]["value"], MU, delta=0.03)

    def test_a_record_has_frames_arcs_kinks_and_parts(self):
        run(f"fit --falls {self.written(6)} {FLAGS} {FEW} -o fit.h5", check=True, cwd=self.folder)
        shown = run("show fit.h5", cwd=self.folder).stdout
        for group in ("falls", "frames", "arcs", "kinks", "subsets", "impacts", "laws"):
            self.assertIn(group, shown)
        with h5py.File(self.folder / "fit.h5") as record:
            arcs, falls = record["arcs"], record["falls"].attrs
            self.assertEqual(len(arcs["time"]), falls["arcs"])
            for k in range(len(arcs["time"])):  # parabolas through the frames
                seen = ((record["frames/fall"][()] == arcs["fall"][k]) & (record["frames/time"][()] >= arcs["start"][k])
                        & (record["frames/time"][()] <= arcs["end"][k]))
                tau = record["frames/time"][()][seen] - arcs["time"][k]
                height = arcs["y"][k] + arcs["vy"][k] * tau + falls["gravity"][1] * tau ** 2 / 2
                if len(tau) > 8 and abs(arcs["vy"][k]) > 0.3:
                    self.assertLess(numpy.abs(record["frames/y"][()][seen] - height).max(), 6 * falls["place_noise"], k)
        for name, width in (("arcs.png", ""), ("narrow.png", "--width aps")):
            run(f"plot fit.h5 -o {name} --kind arcs {width}", check=True, cwd=self.folder)
            self.assertGreater((self.folder / name).stat().st_size, 10_000)

    def test_interrupted_it_says_so_and_leaves_nothing(self):
        files = self.written(6)
        for flags, said in (("", "swirl: interrupted\n"), ("--quiet", "")):
            process = start(f"fit --falls {files} {FLAGS} --resamples 100000 --json {flags} -o {self.folder}/a.h5",
                            stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
            time.sleep(1)
            process.send_signal(signal.SIGINT)
            self.assertEqual((*process.communicate(timeout=60), process.returncode), ("", said, 130))
            self.assertEqual([path.name for path in self.folder.iterdir() if path.suffix != ".csv"], [])

    def test_the_side_that_the_impacts_show(self):
        files = self.written(12, name="side")
        falls = document(f"fit --falls {files} {FLAGS} {FEW}")["falls"]
        self.assertLess(falls["radius_on_plate_high"] - falls["radius_on_plate_low"], 0.05 * RADIUS)
        self.assertAlmostEqual(falls["radius_on_plate"], RADIUS,
                               delta=1.5 * (falls["radius_on_plate_high"] - falls["radius_on_plate_low"]))
        columns = f"--position x y --angle theta --fps {FPS}"
        for flags, mention in ((f"--sides {SIDES} --side {2 * SIDE}", "vertices lie on the plate with --side 0.0"),
                               (f"--sides {SIDES} --side {SIDE / 2}", "vertices lie on the plate with --side 0.0"),
                               (f"--sides 6 --side {SIDE}", f"--sides {SIDES} --side 0.0")):
            wrong = run(f"fit --falls {files} {columns} {flags} {FEW}")
            self.assertEqual((wrong.returncode, wrong.stdout), (2, ""), (flags, wrong.stderr))
            self.assertEqual(len(wrong.stderr.splitlines()), 1, wrong.stderr)
            self.assertIn(mention, wrong.stderr)


class WrongInput(WithFalls, Refusing):
    def folder_of_falls(self):
        return self.other

    def setUp(self):
        super().setUp()
        other = tempfile.TemporaryDirectory()
        self.addCleanup(other.cleanup)
        self.other = Path(other.name)

    def test_wrong_input(self):
        one = self.written(1)
        columns = f"--position x y --angle theta --fps {FPS}"
        for flags, mention in (
                (f"{columns} --side 0.06", "--sides is missing"), (f"{columns} --sides 4", "--side L"),
                (f"{columns} --sides 4 --side 0", "side = 0"), (f"{columns} --sides 4 --side x", "side"),
                (f"{columns} --sides disk --side 1", "disk"), (f"{FLAGS} --polygon-radius 1", "give one"),
                (f"{FLAGS} --gravity -9.81", "gravity = -9.81"), (f"{FLAGS} --alpha 0.3", "--alpha is a dish's"),
                (f"{FLAGS} --floor table", "--floor is a dish's"), (f"{FLAGS} --inertia 1", "--inertia-factor"),
                (f"{FLAGS} --vertex inf", "vertex = inf"), (f"{FLAGS} --impacts {one}", "give one"),
                ("--sides 4 --side 0.06 --position x y", "the angle is missing")):
            self.refused(f"fit --falls {one} {flags}", mention)
        self.refused(f"fit --falls {self.other}/none.csv {FLAGS}", "none.csv")
        self.refused("fit --side 0.06", "--")
        self.refused(f"fit --series {one} {FLAGS}", "--side is of falls")

    def test_a_fall_counts_once(self):
        files = self.written(3).split()
        self.refused(f"fit --falls {' '.join(files)} {files[1]} {FLAGS}", "fall1.csv' is given twice")
        same, part, other, own = (self.other / name for name in ("same.csv", "part.csv", "other.csv", "own.csv"))
        rows = Path(files[1]).read_text().splitlines()
        same.write_text("\n".join(rows))  # one byte less, the same rows
        part.write_text("\n".join(rows[:1] + rows[20:80]) + "\n")
        other.write_text("\n".join(rows[:-1] + ["0,0,0"]) + "\n")  # of which one row is its own
        for path, count in ((same, 125), (part, 60), (other, 124)):
            self.refused(f"fit --falls {' '.join(files)} {path} {FLAGS}",
                         f"'{files[1]}' and '{path}' have {count} rows in common; each fall counts once")
        for change in (lambda i, x, y, angle: (round(x, 4), round(y, 4), round(angle, 3)),
                       lambda i, x, y, angle: (x - 0.01, y, angle + 2 * math.pi)):
            other = self.rewritten(files[1], change)
            self.refused(f"fit --falls {' '.join(files)} {other} {FLAGS}", f"'{files[1]}' and '{other}' are one motion")
        again = Path(self.written(9, name="own").split()[-1]).read_text().splitlines()
        own.write_text("\n".join(again[:4] + rows[4:7] + again[7:]) + "\n")  # three alike, by chance
        self.assertNotIn("counts once", run(f"fit --falls {' '.join(files)} {own} {FLAGS}").stderr)

    def rewritten(self, path, change):
        """A fall of which change(i, x, y, theta) gives each row."""
        rows = [tuple(map(float, line.split(","))) for line in Path(path).read_text().splitlines()[1:]]
        other = self.other / f"other{len(list(self.other.iterdir()))}.csv"
        other.write_text("x,y,theta\n" + "".join("%.6f,%.6f,%.5f\n" % change(i, *row) for i, row in enumerate(rows)))
        return str(other)

    def test_a_file_that_is_none_of_the_others_is_named(self):
        files = self.written(4).split()
        for change in (lambda i, x, y, angle: (1000 * x, 1000 * y, angle), lambda i, x, y, angle: (x, 0.2 - y, -angle)):
            other = self.rewritten(files[1], change)
            self.refused(f"fit --falls {files[0]} {other} {files[2]} {files[3]} {FLAGS}", f"falls '{other}' fall by ")
        coarse = []  # right ones, of which few frames tell their own gravity
        for path in self.written(5, name="coarse").split():
            rows = Path(path).read_text().splitlines()
            coarse.append(self.other / f"few{len(coarse)}.csv")
            coarse[-1].write_text("\n".join(rows[:1] + rows[1::4]) + "\n")
        said = run(f"fit --falls {' '.join(map(str, coarse))} {FLAGS.replace(str(FPS), str(FPS / 4))} {FEW}").stderr
        self.assertNotIn("fall by", said)
        half = self.other / "half.csv"  # every other row
        rows = Path(files[1]).read_text().splitlines()
        half.write_text("\n".join(rows[:1] + rows[1::2]) + "\n")
        self.refused(f"fit --falls {files[0]} {half} {files[2]} {files[3]} {FLAGS}", f"falls '{half}' fall by ")

    def test_what_is_given_is_what_the_falls_show(self):
        files = self.written(6, name="given")
        for flag, mention in (("--gravity 98", "tell a gravity of 9."), ("--gravity 10.5", "--gravity says 10.5"),
                              ("--vertex 0.5", "rad from --vertex 0.5")):
            self.refused(f"fit --falls {files} {FLAGS} {FEW} {flag}", mention)
        found = document(f"fit --falls {files} {FLAGS} {FEW} --vertex {5 * math.pi}")  # as good as 0
        self.assertAlmostEqual(found["falls"]["vertex_of_impacts"], 5 * math.pi, delta=0.01)
        found = document(f"fit --falls {files} {FLAGS} {FEW} --gravity 9.65")
        self.assertAlmostEqual(found["falls"]["gravity_of_arcs"], GRAVITY, delta=0.05)
        self.assertTrue(any("--gravity says 9.65" in note for note in found["notes"]), found["notes"])

    def test_a_film_that_runs_backwards(self):
        turned = []
        for path in self.written(8, name="back").split():
            rows = Path(path).read_text().splitlines()
            turned.append(self.other / f"turned{len(turned)}.csv")
            turned[-1].write_text("\n".join(rows[:1] + rows[:0:-1]) + "\n")
        self.refused(f"fit --falls {' '.join(map(str, turned))} {FLAGS} {FEW}", "time runs backwards")
        files = self.written(8, name="back").split()  # the seeds' impacts that can be used: 1 to 5 a fall
        used = [k["fall"] for k in self.kinks_of(files) if k["use"] == "used"]
        most = max(set(used), key=used.count)
        self.assertGreater(used.count(most), 2)
        one = files[:most] + [str(turned[most])] + files[most + 1:]
        self.refused(f"fit --falls {' '.join(one)} {FLAGS} {FEW}", f"falls '{turned[most]}': energy surely rises at all of its")

    def kinks_of(self, files):
        run(f"fit --falls {' '.join(files)} {FLAGS} {FEW} -o {self.other}/kinks.h5 --force", check=True)
        with h5py.File(self.other / "kinks.h5") as record:
            return [{"fall": int(fall), "use": use.decode() if isinstance(use, bytes) else str(use)}
                    for fall, use in zip(record["kinks/fall"][()], record["kinks/use"].asstr()[()])]

    def test_a_fall_that_is_elsewhere_is_noted(self):
        files = self.written(8, name="place").split()
        files[2] = self.rewritten(files[2], lambda i, x, y, angle: (x, y + 0.01, angle))
        notes = document(f"fit --falls {' '.join(files)} {FLAGS} {FEW}")["notes"]
        self.assertTrue(any(f"no impact of '{files[2]}' is on the plate" in note for note in notes), notes)

    def test_falls_that_no_law_fits(self):
        still = self.other / "still.csv"
        still.write_text("x,y,theta\n" + "0,0.03,0.785\n" * 100)
        self.refused(f"fit --falls {still} {FLAGS}", "--gravity G")
        short = self.other / "short.csv"
        short.write_text("x,y,theta\n0,1,0\n0.1,1,0\n")
        self.refused(f"fit --falls {short} {FLAGS}", "short.csv")
        self.refused(f"fit --falls {self.written(1, seconds=0.2)} {FLAGS}", "falls: ")


if __name__ == "__main__":
    unittest.main()
