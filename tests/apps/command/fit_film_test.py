"""swirl fit --series, from outside, on films whose truth is known: fit_film_test.py SWIRL [--all] [--coverage [FITS [SEED]]]

--all: also what takes longer. --coverage: 20 scenes at 30 and 120 frames a second, noise of 0.1 to 1 % of R_c, 1 to 10 minutes;
how often the truth lies in the 95 % intervals. FITS of them, 60 unless given, of films whose seeds follow SEED."""

import cmath
import json
import math
import random
import re
import sys
import time
import unittest

import h5py

FITS, SEED = 60, 1
ALL = "--all" in sys.argv
if ALL:
    sys.argv.remove("--all")
COVERAGE = "--coverage" in sys.argv
if COVERAGE:
    place = sys.argv.index("--coverage")
    sys.argv.pop(place)
    if place < len(sys.argv) and sys.argv[place].isdigit():
        FITS = int(sys.argv.pop(place))
    if place < len(sys.argv) and sys.argv[place].isdigit():
        SEED = int(sys.argv.pop(place))

from driving import InFolder, Refusing, document, examples_in, run

RATE = 6.283185307179586
SHAPE = "--sides 6 --alpha 0.4 --beta 0.5"
MARKS = "--marks x y mark_x mark_y"
FEW = "--resamples 40"
LONG = unittest.skipUnless(ALL, "takes longer: --all")


def motion(shape, mu, e, seconds):
    """Flags of the body swirled once a second; lengths in R_c."""
    shape = shape.replace("--alpha", "--polygon-radius").replace("--beta", "--swirl-radius")
    return (f"simulate {shape} --container-radius 1 --swirl-rate {RATE} --mu {mu} --restitution {e} --time {seconds} "
            "--speed 1 --quiet")


def filmed(path, shape=SHAPE, mu=0.2, e=0.7, seconds=60, frames=30, noise=0.003, more=""):
    result = run(f"{motion(shape, mu, e, seconds)} --camera {frames} --noise {noise} --force {more} -o {path}")
    assert result.returncode in (0, 3), result.stderr
    return path


def reaches(scene, impact, time):
    """How far the vertices reach beyond the wall so long after an impact, the farthest first; of a disk one."""
    sides, alpha, beta, _, _ = scene
    place = complex(impact["x"] + impact["vx"] * time, impact["y"] + impact["vy"] * time) - cmath.rect(beta, impact["t"] + time)
    if sides == "disk":
        return [abs(place) + alpha - 1, -1]
    angle = impact["angle"] + impact["spin"] * time
    return sorted((abs(place + cmath.rect(alpha, angle + 2 * math.pi * k / sides)) - 1 for k in range(sides)), reverse=True)


def clear_impacts(scene, seconds, frames, noise, seed):
    """Impacts of the true orbit between two flights of four frames or more, each clear of the wall in its middle by 1.5 times
    what the fit asks for (11 errors of the mean of its frames), at which the next vertex is clear of it by 1.5 times 4 errors
    of a place from both flights, 2 σ²/n."""
    sides, alpha, beta, mu, e = scene
    shape = f"--sides {sides} --alpha {alpha} --beta {beta}"
    result = run(f"{motion(shape, mu, e, seconds)} --seed {seed} --json")
    orbit = json.loads(result.stdout)
    impacts = orbit["collisions"]
    lasting = iter(orbit["contacts"] + [{"t_start": math.inf}])
    contact, flights = next(lasting), []
    for before, after in zip(impacts, impacts[1:]):
        time = after["t"] - before["t"]
        while contact["t_start"] < before["t"]:
            contact = next(lasting)
        count = time * frames / (2 * math.pi)
        error = noise * (1 if sides == "disk" else 3 ** 0.5) / max(count, 1) ** 0.5
        clear = contact["t_start"] > after["t"] and count >= 4 and -reaches(scene, before, time / 2)[0] > 1.5 * 11 * error
        flights.append((clear, error))
    return sum(before and after and -reaches(scene, impact, 0)[1] > 1.5 * 4 * 2 ** 0.5 * max(error, next_error)
               for impact, (before, error), (after, next_error) in zip(impacts[1:], flights, flights[1:]))


def filmed_on_a_floor(path, drag=0.1, alpha=0.1, beta=0.5, e=0.95, seconds=60, frames=30, noise=0.003):
    """A disk without friction in a dish whose floor drags it, X" = -drag (X' - V), and turns it evenly for ever: flights in closed
    form, impacts by bisection. Time in turns of the swirl."""
    draw = random.Random(5)
    start, place, velocity = 0.0, complex(beta + 0.1, 0.2), complex(0.9, 0.4)
    carried = drag * beta / complex(drag, 1)

    def at(time):
        since = time - start
        free = velocity - 1j * carried * cmath.rect(1, start)
        left = math.exp(-drag * since)
        return (place + free * (1 - left) / drag + carried * (cmath.rect(1, time) - cmath.rect(1, start)),
                free * left + 1j * carried * cmath.rect(1, time))

    def gap(time):
        return abs(at(time)[0] - cmath.rect(beta, time)) - (1 - alpha)

    def next_impact():
        late = start + 0.004
        while gap(late) < 0:
            late += 0.002
        early = late - 0.002
        for _ in range(40):
            middle = (early + late) / 2
            early, late = (early, middle) if gap(middle) > 0 else (middle, late)
        return early

    end, lines = next_impact(), ["frame,t,x,y,mark_x,mark_y"]
    for frame in range(seconds * frames):
        time = 2 * math.pi * frame / frames
        while end < time:
            here, before = at(end)
            normal = (here - cmath.rect(beta, end)) / (1 - alpha)
            approach = ((before - cmath.rect(beta, end) * 1j) * normal.conjugate()).real
            start, place, velocity = end, here, before - (1 + e) * approach * normal
            end = next_impact()
        centre = at(time)[0]
        points = (centre, centre + cmath.rect(alpha, 2 * time))
        numbers = [part + draw.gauss(0, noise) for point in points for part in (point.real, point.imag)]
        lines.append(",".join([f"{frame},{frame / frames:.4f}"] + [f"{number:.5f}" for number in numbers]))
    path.write_text("\n".join(lines) + "\n", encoding="ascii")
    return path


class OfFilms(InFolder):
    def found(self, flags=MARKS, shape=SHAPE, **film):
        path = filmed(self.folder / "film.csv", shape, **film)
        return document(f"fit --series {path} {flags} {shape} --swirl-rate 1Hz {FEW}")

    def holds(self, number, truth):
        self.assertLessEqual(number["low"], truth, number)
        if number["high"] is not None:
            self.assertGreaterEqual(number["high"], truth, number)


class Truth(OfFilms):
    def test_a_film_gives_restitution_friction_and_where_the_dish_was(self):
        found = self.found(more="--lose 0.01")
        self.holds(found["restitution"], 0.7)
        self.holds(found["friction"], 0.2)
        self.assertLess(found["restitution"]["high"] - found["restitution"]["low"], 0.03)
        self.assertLess(found["friction"]["high"] - found["friction"]["low"], 0.03)
        self.holds(found["drag"], 0)
        self.assertLess(found["drag"]["high"] - found["drag"]["low"], 0.03)
        self.assertEqual((found["film"]["arcs_drag"], found["drag"]["floor"], found["drag"]["floor_decided"]),
                         (0, "dish", False))
        self.holds(found["spin_drag"], 0)
        self.assertEqual(found["film"]["arcs_spin_drag"], 0)
        film = found["film"]
        self.assertLess(abs(film["alpha_on_wall"] - 0.4), 4 * film["alpha_on_wall_error"])
        self.assertAlmostEqual(film["place_noise"], 0.003, delta=0.0003)
        self.assertAlmostEqual(film["angle_noise"], 2 ** 0.5 * 0.003 / 0.4, delta=0.001)
        self.assertLess(max(map(abs, film["origin"])), 0.005)
        self.assertAlmostEqual(film["swirl_rate"], RATE, delta=0.001 * RATE)
        self.assertLess(abs(film["swirl_phase"]), 0.03)
        self.assertLess(abs(film["vertex"]), 0.03)
        used = found["impacts"] + sum(found["kinks_left_out"].values())
        self.assertEqual(used, film["kinks"])
        self.assertGreater(found["impacts"] + found["kinks_left_out"]["alike"], 200)
        self.assertGreater(found["impacts"], 30)  # of which the others differ by noise alone

    @LONG
    def test_the_angle_alone_and_an_image_with_y_down_give_the_same(self):
        marks = self.found()
        angle = self.found("--position x y --angle angle")
        for name in ("restitution", "friction"):
            self.assertAlmostEqual(angle[name]["value"], marks[name]["value"], delta=0.005)
        image = self.found(f"{MARKS} --y-down --scale 0.0025", noise=0.003, more="--pixels 400")
        for name, truth in (("restitution", 0.7), ("friction", 0.2)):
            self.holds(image[name], truth)

    def test_exact_frames_are_fitted_with_the_noise_of_their_rounding(self):
        for noise in (0, 1e-6, 1e-4):
            found = self.found(noise=noise, seconds=30)
            rounding = math.hypot(noise, 1e-4 / 12 ** 0.5)  # places are written to 1e-4 R_c
            self.assertAlmostEqual(found["film"]["place_noise"], rounding, delta=0.1 * rounding)
            for name, truth in (("restitution", 0.7), ("friction", 0.2)):
                self.holds(found[name], truth)
                self.assertLess(found[name]["high"] - found[name]["low"], 0.01)

    def test_a_floor_is_told_by_the_places_and_one_that_is_given_is_compared(self):
        path = filmed_on_a_floor(self.folder / "film.csv")
        fit = f"fit --series {path} {MARKS} --sides disk --alpha 0.1 --beta 0.5 --swirl-rate 1Hz {FEW}"
        found = document(fit)
        self.assertEqual((found["drag"]["floor"], found["drag"]["floor_decided"]), ("dish", True))
        self.holds(found["drag"], 0.1)
        self.holds(found["spin_drag"], 0)
        self.holds(found["restitution"], 0.95)
        self.assertTrue(any("the spin decays by" in note for note in found["notes"]), found["notes"])
        told = [note for note in found["notes"] if "--floor" in note]
        self.assertEqual(told, [])
        wrong = document(f"{fit} --floor table")
        self.assertEqual((wrong["drag"]["floor"], wrong["drag"]["floor_decided"]), ("table", False))
        self.assertTrue(any("--floor table is not what the film shows" in note for note in wrong["notes"]), wrong["notes"])
        right = document(f"{fit} --floor dish")
        self.assertEqual((right["drag"]["floor"], right["drag"]["floor_decided"]), ("dish", True))
        self.holds(right["restitution"], 0.95)
        self.assertFalse(any("--floor" in note for note in right["notes"]), right["notes"])

    def test_contacts_that_always_stick_tell_no_friction(self):
        found = self.found(mu=0.5, e=0.9, noise=0.001)
        self.holds(found["restitution"], 0.9)
        self.holds(found["friction"], 0.5)
        self.assertIsNone(found["friction"]["high"])
        self.assertTrue(any("friction can't be told" in note for note in found["notes"]), found["notes"])

    def test_a_body_of_another_size_is_told(self):
        path = filmed(self.folder / "film.csv", seconds=30)
        given = "--sides 6 --alpha 0.39 --beta 0.5"
        found = document(f"fit --series {path} {MARKS} {given} --swirl-rate 1Hz {FEW}")
        film = found["film"]
        self.assertLess(abs(film["alpha_on_wall"] - 0.4), 4 * film["alpha_on_wall_error"])
        self.assertTrue(any("not with 0.39" in note for note in found["notes"]), found["notes"])
        far = run(f"fit --series {path} {MARKS} {given.replace('0.39', '0.36')} --swirl-rate 1Hz {FEW}")
        self.assertEqual(far.returncode, 2, far.stdout)
        self.assertRegex(far.stderr, r"lies on the wall with alpha = 0\.(399|400|401)\d* \+- \S+, not with 0\.36")

    def test_the_size_of_a_disk_that_stays_on_the_wall_is_told(self):
        shape = "--sides disk --alpha 0.4 --beta 0.5"
        path = filmed(self.folder / "film.csv", shape, e=0.8, seconds=20)
        fit = f"fit --series {path} {MARKS} --swirl-rate 1Hz {FEW} --beta 0.5 --sides disk"
        for given, where in (("0.398", "leaves it clear of the wall by"), ("0.402", "puts it beyond the wall by")):
            result = run(f"{fit} --alpha {given}")
            self.assertEqual(result.returncode, 2, result.stdout)
            told = re.search(rf"lies on the wall with alpha = (\S+) \+- (\S+), not with {given}, which {where} (\S+) R_c",
                             result.stderr)
            self.assertIsNotNone(told, result.stderr)
            alpha, error, clearance = map(float, told.groups())
            self.assertLess(abs(alpha - 0.4), 4 * error)
            self.assertLess(error, 0.0004)
            self.assertAlmostEqual(clearance, abs(alpha - float(given)), delta=0.0001)
            self.assertIn("stays on the wall", result.stderr)
        right = run(f"{fit} --alpha 0.4")
        self.assertEqual(right.returncode, 2, right.stdout)
        self.assertIn("stays on the wall", right.stderr)
        self.assertNotIn("not with", right.stderr)

    @LONG
    def test_an_inertia_that_is_not_the_body_s_is_told(self):
        shape = "--sides 6 --alpha 0.3 --beta 0.1"
        film = dict(shape=shape, mu=0.1, e=1.0, seconds=120, noise=0.001, more="--inertia-factor 0.7")
        path = filmed(self.folder / "film.csv", **film)
        fit = f"fit --series {path} {MARKS} {shape} --swirl-rate 1Hz {FEW}"
        lamina = run(fit)  # 0.417: no law describes the impacts
        self.assertEqual(lamina.returncode, 2, lamina.stdout)
        told = re.search(r"momentum contradicts I/m = \S+ kappa = 0\.4167: it alone gives kappa = (\S+) \[(\S+), (\S+)\] "
                         r"\(--inertia-factor\)", lamina.stderr)
        self.assertIsNotNone(told, lamina.stderr)
        value, low, high = map(float, told.groups())
        self.assertAlmostEqual(value, 0.7, delta=0.01)
        self.assertTrue(low <= 0.7 <= high, told.groups())
        near = document(f"{fit} --inertia-factor 0.68")
        self.assertTrue(any("momentum contradicts inertia" in note for note in near["notes"]), near["notes"])
        right = document(f"{fit} --inertia-factor 0.7")
        self.assertFalse(any("momentum contradicts" in note for note in right["notes"]), right["notes"])
        self.holds(right["friction"], 0.1)


class Outputs(OfFilms):
    def test_table_record_figures_and_the_commands_that_it_prints(self):
        path = filmed(self.folder / "film.csv", seconds=30)
        result = run(f"fit --series {path} {MARKS} {SHAPE} --swirl-rate 1Hz --resamples 20 -o {self.folder}/fit.h5")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for word in ("frames", "arcs", "used", "left out", "restitution e", "friction mu", "as much noise"):
            self.assertIn(word, result.stdout)
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 100)
        classify, sweep = examples_in(result.stdout)[-2:]  # before them stands the row "swirl"
        self.assertEqual(run(f"{classify} --collisions 200").returncode, 0)
        self.assertEqual(run(f"{sweep} --collisions 100 --quiet").returncode, 0)
        with h5py.File(self.folder / "fit.h5") as record:
            time, spin = record["simulated/time"][()], record["simulated/S"][()]
            self.assertGreater(len(record["frames/time"]), 800)
            self.assertEqual(len(record["arcs/S"]), record["film"].attrs["arcs"])
            # The simulated orbit begins with the spin of an arc, and ends with the film.
            arc = list(record["arcs/time"][()]).index(time[0])
            self.assertEqual(record["arcs/S"][arc], spin[0])
            self.assertLess(record["arcs/end"][-1] - time[-1], 3)
        figure = run(f"plot {self.folder}/fit.h5 -o {self.folder}/arcs.png --kind arcs")
        self.assertEqual((figure.returncode, figure.stderr), (0, ""))

    @LONG
    def test_equal_work_gives_equal_records_whatever_the_threads(self):
        path = filmed(self.folder / "film.csv", seconds=20)
        for name, threads in (("a", 1), ("b", 4)):
            result = run(f"fit --series {path} {MARKS} {SHAPE} --swirl-rate 1Hz {FEW} --threads {threads} --quiet "
                         f"-o {self.folder}/{name}.h5")
            self.assertEqual(result.returncode, 0, result.stderr)
        a, b = ((self.folder / f"{name}.h5").read_bytes() for name in "ab")
        self.assertEqual(a, b)


class WrongInput(Refusing):
    def test_wrong_input(self):
        import tempfile
        from pathlib import Path

        other = tempfile.TemporaryDirectory()
        self.addCleanup(other.cleanup)
        path = filmed(Path(other.name) / "film.csv", seconds=20)
        film = f"fit --series {path}"
        self.refused(f"{film} {SHAPE}", "--angle")
        self.refused(f"{film} --angle angle {SHAPE}", "--position")
        self.refused(f"{film} {MARKS} --sides 6 --alpha 0.4", "beta")
        self.refused(f"{film} {MARKS} --alpha 0.4 --beta 0.5", "--sides is missing")
        self.refused(f"{film} {MARKS} --sides 2 --alpha 0.4 --beta 0.5", "sides")
        self.refused(f"{film} {MARKS} --sides 6 --alpha 1.4 --beta 0.5", "alpha = 1.4 is outside its range: 0 < alpha < 1")
        self.refused(f"{film} {MARKS} --sides 6 --polygon-radius 0.4 --beta 0.5", "--container-radius")
        self.refused(f"{film} {MARKS} {SHAPE} --scale 0", "scale = 0 is outside its range: scale > 0")
        self.refused(f"{film} {MARKS} {SHAPE} --resamples 3", "resamples")
        self.refused(f"{film} {MARKS} {SHAPE} --vertex nan", "vertex")
        self.refused(f"{film} {MARKS} {SHAPE} --impacts {path}", "give one")
        self.refused(f"{film} {MARKS} {SHAPE} --inertia 0.1", "--inertia-factor")
        self.refused(f"{film} {MARKS} {SHAPE} --each frame", "--where")
        self.refused(f"fit --impacts {path} --alpha 0.4", "--series")
        self.refused(f"{film} {MARKS} {SHAPE} --floor ice", "floor")
        self.refused(f"fit --impacts {path} --floor dish", "--floor is a film's; give --series FILE")
        self.refused(f"fit --impacts {path} --vertex 0", "--vertex is a film's; give --series FILE")
        self.refused(f"{film} {MARKS} --sides 6 --alpha 0.4 --beta 0.1 --swirl-rate 1Hz", "wall")


#: sides, alpha, beta, mu, e
SCENES = [(6, .4, .5, .5, .9), (6, .4, .5, .2, .7), (3, .5, .5, .3, .8), (4, .3, .6, .1, .9), (5, .5, .3, .8, .95),
          (3, .3, .8, .15, .6), (4, .6, .4, .4, .85), ("disk", .4, .5, .2, .8), (8, .35, .5, .25, .9), (6, .4, 1.0, .05, .8),
          (4, .52, .46, .6, .75), (6, .3, .1, .1, 1.0), (6, .635, .5, .5, .95), (5, .4, .3, .3, .7), (3, .4, .2, .5, .9),
          (7, .5, .6, .1, .6), (12, .4, .5, .3, .9), ("disk", .3, .4, .1, .95), (4, .4, .8, .2, .8), (3, .2, .3, .25, .95)]


class Coverage(OfFilms):
    @unittest.skipUnless(COVERAGE, "minutes; --coverage")
    def test_intervals_hold_the_truth(self):
        draw = random.Random(SEED)
        inside, told, refused, slowest = {"restitution": 0, "friction": 0}, 0, 0, 0
        drags, spin_drags, alphas = [], [], []
        for fit in range(FITS):
            scene = SCENES[fit % len(SCENES)]
            sides, alpha, beta, mu, e = scene
            shape = f"--sides {sides} --alpha {alpha} --beta {beta}"
            frames, noise = draw.choice((30, 120)), draw.choice((0.001, 0.003, 0.01))
            minutes = draw.choice((1, 2, 4, 10)) if frames == 30 else draw.choice((1, 2))
            path = filmed(self.folder / "film.csv", shape, mu=mu, e=e, frames=frames, noise=noise, seconds=60 * minutes,
                          more=f"--seed {SEED + fit}")
            begun = time.monotonic()
            result = run(f"fit --series {path} {MARKS} {shape} --swirl-rate 1Hz --json")
            slowest = max(slowest, time.monotonic() - begun)
            self.assertIn(result.returncode, (0, 2), result.stderr)
            if result.returncode == 2:  # too few impacts, contact that lasts: it says so
                refused += 1
                clear = clear_impacts(scene, 60 * minutes, frames, noise, SEED + fit)
                what = (f"{shape} mu {mu} e {e}, {minutes} min, {frames} frames, noise {noise}: {clear} clear impacts; "
                        f"{result.stderr.strip()[:150]}")
                print(what, flush=True)
                # Eight are needed, and of clear ones half are used at least (two impacts may lie within a few frames).
                self.assertLess(clear, 16, what)
                continue
            found = json.loads(result.stdout)
            told += found["friction"]["high"] is not None
            if found["drag"]["value"] is not None:
                drags.append(found["drag"]["low"] <= 0 <= found["drag"]["high"])
            if found["spin_drag"]["value"] is not None:
                spin_drags.append(found["spin_drag"]["low"] <= 0 <= found["spin_drag"]["high"])
            alphas.append(not any("not with" in note for note in found["notes"]))
            for name, truth in (("restitution", e), ("friction", mu)):
                number = found[name]
                holds = number["low"] <= truth and (number["high"] is None or truth <= number["high"])
                inside[name] += holds
                if not holds:
                    print(f"{shape} mu {mu} e {e}, {minutes} min, {frames} frames, noise {noise}: {name} {number}", flush=True)
        done = FITS - refused
        print(f"{FITS} films, {refused} refused; inside: {inside} of {done}; mu is told in {told}; the slowest took {slowest:.1f} s")
        print(f"the drag, 0: inside in {sum(drags)} of {len(drags)}, the spin's in {sum(spin_drags)} of {len(spin_drags)}; alpha is not said to be another in {sum(alphas)} of {len(alphas)}")
        self.assertGreaterEqual(sum(drags), 0.85 * len(drags))
        self.assertGreaterEqual(sum(spin_drags), 0.85 * len(spin_drags))
        self.assertGreaterEqual(sum(alphas), 0.95 * len(alphas))
        # 95 % of 45: below 0.85 less often than once in a hundred times.
        for name, count in inside.items():
            self.assertGreaterEqual(count, 0.85 * done, name)


if __name__ == "__main__":
    unittest.main()
