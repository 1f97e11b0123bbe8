"""Scenes drawn from the whole space of numbers: whatever they are, `simulate` and `classify` end with a name, within
seconds, pressed inwards by every impulse, with all vertices inside.

random_space_test.py SWIRL [SCENES [FIRST]]: scenes FIRST … FIRST + SCENES − 1 (8 from 0 by default). A scene has a
generator of its own, so that any of them can be followed alone; a failure prints its command."""

import json
import math
import random
import resource
import subprocess
import sys
import unittest
from collections import Counter

from driving import SWIRL

SCENES = int(sys.argv.pop(1)) if len(sys.argv) > 1 else 8
FIRST = int(sys.argv.pop(1)) if len(sys.argv) > 1 else 0
MOST_SECONDS = 10  # of one core
IMPACTS = 2000
SIMULATED = {"completed", "no-contact", "in-contact", "contact-cut-short", "resting", "diverged", "unresolved"}
KINDS = set("""fixed-point family cycle quasi-periodic rolling rolling-librating rolling-circulating sliding two-vertex
    landing chaotic transient""".split())
EPSILON = sys.float_info.epsilon


def log_between(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def scene_of(number):
    """The flags of a scene and its start: log-uniform where there is a smallest scale, special values mixed in."""
    draw = random.Random(f"swirl {number}")
    signed = lambda low, high: draw.choice((-1, 1)) * log_between(draw, low, high)
    many = round(log_between(draw, 3, 1e6))
    alpha = draw.choice((draw.uniform(0.02, 0.98), log_between(draw, 1e-9, 1), 1 - log_between(draw, 1e-9, 1)))
    flags = {
        "sides": draw.choice(("disk", many, draw.randint(3, 12), draw.randint(3, 12))),
        "alpha": min(max(alpha, 1e-9), 1 - 1e-9),
        "beta": draw.choice((log_between(draw, 1e-70, 10), log_between(draw, 1e-3, 5))),
        "mu": draw.choice((0, log_between(draw, 1e-12, 1e3), log_between(draw, 1e-12, 1e3), draw.uniform(0, 2))),
        "restitution": draw.choice((0, 1, 1 - log_between(draw, 1e-12, 1), 1 - log_between(draw, 1e-12, 1),
                                    draw.random())),
        "law": draw.choice(("poisson", "newton", "stronge")),
    }
    if draw.random() < 0.2:
        flags["inertia-factor"] = log_between(draw, 1e-3, 1)
    direction, speed = draw.uniform(-math.pi, math.pi), log_between(draw, 1e-12, 1e9)
    flags.update({"x": flags["beta"], "vx": speed * math.cos(direction), "vy": speed * math.sin(direction),
                  "angle": draw.uniform(-math.pi, math.pi), "spin": 0 if draw.random() < 0.3 else signed(1e-12, 1e9)})
    return flags


def words(command, flags, *more):
    return [SWIRL, command, *(f"--{name}={value!r}" if isinstance(value, float) else f"--{name}={value}"
                              for name, value in flags.items()), *more, "--json"]


def follow(command):
    """Its document and the seconds of one core that it took. A time-out, a crash or a wrong exit code is a failure."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    limit = lambda: resource.setrlimit(resource.RLIMIT_CPU, (2 * MOST_SECONDS, 2 * MOST_SECONDS))
    result = subprocess.run(command, capture_output=True, text=True, preexec_fn=limit)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if result.returncode not in (0, 3):
        raise AssertionError(f"exit {result.returncode} after {seconds:.1f} s: {result.stderr.strip()}")
    return json.loads(result.stdout), seconds


def outside(flags, row):
    """How far the vertex that struck and its neighbours are outside, or the disk, in units of 10⁻¹² + rounding."""
    beta, alpha = flags["beta"], flags["alpha"]
    x = row["x"] - beta * math.cos(row["t_phase"])
    y = row["y"] - beta * math.sin(row["t_phase"])
    rounding = 1e-12 + 16 * EPSILON * (1 + beta)
    if flags["sides"] == "disk":
        return (math.hypot(x, y) - (1 - alpha)) / rounding
    step = 2 * math.pi / flags["sides"]
    angles = [row["angle_phase"] + step * (row["vertex"] + k) for k in (-1, 0, 1)]
    return max(math.hypot(x + alpha * math.cos(a), y + alpha * math.sin(a)) - 1 for a in angles) / rounding


def troubles_of_orbit(flags, document):
    troubles = []
    if document["outcome"] not in SIMULATED:
        troubles.append(f"outcome {document['outcome']}")
    rows = document["collisions"]
    pulls = [row for row in rows if not row["impulse_normal"] >= 0]
    if pulls:
        troubles.append(f"{len(pulls)} impulses < 0, the first {pulls[0]['impulse_normal']} of impact {pulls[0]['number']}")
    far = max((outside(flags, row) for row in rows), default=0)
    if far > 1:
        troubles.append(f"a vertex is outside by {far:.3g} of the rounding allowed")
    if any(later["t"] < earlier["t"] for earlier, later in zip(rows, rows[1:])):
        troubles.append("t falls")
    return troubles


class RandomSpace(unittest.TestCase):
    def setUp(self):
        self.endings, self.slowest, self.failures = {"simulate": Counter(), "classify": Counter()}, {}, []

    def look_at(self, number, name, command, troubles_of):
        try:
            found, seconds = follow(command)
        except AssertionError as error:
            self.failures.append((number, str(error), command))
            return
        self.slowest[name] = max(self.slowest.get(name, (0, "")), (seconds, " ".join(command[1:])))
        ending = found["outcome"] if name == "simulate" else f"{found['mode']}, {found['kind']}"
        self.endings[name][ending] += 1
        if ending == "unresolved":
            print(f"scene {number}: unresolved\n  {' '.join(command[1:])}", flush=True)
        late = [f"{seconds:.1f} s"] if seconds > MOST_SECONDS else []
        self.failures.extend((number, trouble, command) for trouble in late + troubles_of(found))

    def test_every_scene_ends_with_a_name(self):
        for number in range(FIRST, FIRST + SCENES):
            flags = scene_of(number)
            self.look_at(number, "simulate", words("simulate", flags, f"--collisions={IMPACTS}"),
                         lambda found: troubles_of_orbit(flags, found))
            self.look_at(number, "classify", words("classify", flags),
                         lambda found: [] if found["kind"] in KINDS or found["mode"] == "undecided" else ["no kind"])
        for name, counts in self.endings.items():
            print(f"{name}: " + ", ".join(f"{ending} {n}" for ending, n in counts.most_common()))
        for name, (seconds, command) in self.slowest.items():
            print(f"slowest {name}: {seconds:.2f} s: {command}")
        for number, trouble, command in self.failures:
            print(f"scene {number}: {trouble}\n  {' '.join(command[1:])}")
        self.assertEqual([], [(number, trouble) for number, trouble, _ in self.failures])
        self.assertLessEqual(self.endings["simulate"]["unresolved"], SCENES // 1000)


class KnownEndings(unittest.TestCase):
    """Scenes that once had no end or no name."""

    HEXAGON = "--alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
    SCENES = {
        "a disk in a swirl of 1e-25": "--sides disk --alpha 0.2657459262765958 --beta 2.7329732946433905e-25 "
        "--mu 1.3408492443119426 --restitution 0.09300152205664036 --seed 12397497687982519376",
        "a polygon in a swirl of 1e-44": "--sides 3 --alpha 2.2653658627707902e-06 --beta 1.3833531105652338e-44 "
        "--mu 1.259709553248775 --restitution 0.05847851149036842 --law stronge --spin 455.1539480273448 --vx 2e-4",
        "a triangle that spins": f"--sides 3 {HEXAGON} --spin=1e9",
        "a pentagon that spins": f"--sides 5 {HEXAGON} --spin=1e9",
        "a slow hexagon that does not turn": "--sides 6 --alpha 0.93 --beta 0.012 --mu 1 --restitution 1 --vx 2e-10",
        "a body that all but fills the container": "--sides 9 --alpha 0.999999955722298 --beta 2.0402999464149567 "
        "--mu 0.9207453529742373 --restitution 0.5867378839787757 --law stronge --spin=-154",
        "a vertex that leaves with u_n = 0 in a swirl of 1e-47": "--sides 11 --alpha 0.49957939246289707 "
        "--beta 1.0017560457638324e-47 --mu 0.14836441258518107 --restitution 0 --law newton --vx=-8.09264e-10 "
        "--vy 5.07986e-11 --angle=-0.94 --spin=-3.401e-09",
        "two vertices that strike in turn": "--sides 7 --alpha 0.17776178042129986 --beta 1.4896002924307372 "
        "--mu 0.040393600711095434 --restitution 0.008257619868914046 --law newton --inertia-factor "
        "0.0019768110349642713 --speed 1.4157650109247994e-07 --seed 20",
        "a square that leaves an edge": "--sides 4 --alpha 0.00012533090045567497 --beta 1.3166111622180299e-05 --mu 0 "
        "--restitution 0 --law newton --speed 0.0013647990230596125 --seed 906593243",
        "a triangle that leaves an edge": "--sides 3 --alpha 0.00025113907267058856 --beta 1.3888465229049523e-12 "
        "--mu 0 --restitution 0 --law stronge --seed 766377158",
        "a million sides": "--sides 1000000 --alpha 0.999999 --beta 0.5 --mu 0.5 --restitution 0.9",
    }

    # Of the draw: vertices that leave with u_n = 0 in a weak swirl (16, 494, 537, 657, 723, 728), bodies that reach the
    # wall within rounding for longer than the swirl turns (96, 712, 868), an edge's two vertices striking in turn with
    # ever less (774), fast spin after a long flight (174, 593), a vertex that turns away just before the wall (587),
    # more turns of the swirl than a double can count (215, 425), bodies with so little room that they go along with the
    # container (5029, 7134, 8538), a neighbour that leaves the wall from within rounding outside it (5231, 6187, 8438,
    # 9499).
    DRAWN = (16, 96, 174, 215, 425, 494, 537, 587, 593, 657, 712, 723, 728, 774, 868, 5029, 5231, 6187, 7134,
             8438, 8538, 9499)

    def test_drawn_scenes_stay_inside_and_have_a_name(self):
        for number in self.DRAWN:
            flags = scene_of(number)
            found, seconds = follow(words("simulate", flags, f"--collisions={IMPACTS}"))
            self.assertEqual(troubles_of_orbit(flags, found), [], number)
            self.assertNotEqual(found["outcome"], "unresolved", number)
            self.assertLess(seconds, MOST_SECONDS, number)

    # Of the draw: long swings on the wall in a weak swirl, a landing at each impact (88, 186, 749), a body with little
    # room that spins fast (5667), contact of 10⁵ series after which there is no impact (8197).
    DEAR = (88, 186, 749, 5667, 8197)

    def test_verdicts_on_impacts_that_cost_much_come_within_seconds(self):
        for number in self.DEAR:
            judged, seconds = follow(words("classify", scene_of(number)))
            self.assertLess(seconds, MOST_SECONDS, number)
            self.assertIn(judged["mode"], ("chaotic", "quasi-steady", "steady", "undecided"), number)

    def test_they_have_a_name(self):
        for name, flags in self.SCENES.items():
            found, seconds = follow([SWIRL, "simulate", *flags.split(), f"--collisions={IMPACTS}", "--json"])
            self.assertNotEqual(found["outcome"], "unresolved", name)
            self.assertLess(seconds, MOST_SECONDS, name)

    def test_no_impulse_pulls_and_none_leaves_into_the_wall(self):
        alpha, beta = 0.9999220268810557, 1.010287041726456
        flags = {"sides": 8, "alpha": alpha, "beta": beta, "mu": 1.2633877151476074, "restitution": 1,
                 "seed": 14372809874713507692}
        found, _ = follow(words("simulate", flags, f"--collisions={IMPACTS}"))
        rows = found["collisions"]
        self.assertEqual(len(rows), IMPACTS)
        self.assertEqual([row["number"] for row in rows if not row["impulse_normal"] >= 0], [])
        normal = lambda row: row["vn"] - alpha * row["spin"] * math.sin(row["chi"]) - beta * math.sin(row["psi"])
        speed = lambda row: abs(row["vn"]) + abs(row["vt"]) + alpha * abs(row["spin"]) + beta
        self.assertEqual([row["number"] for row in rows if normal(row) > 64 * EPSILON * speed(row)], [])

    def test_contact_that_is_cut_short_is_said_to_be(self):
        found, _ = follow([SWIRL, "simulate", "--sides=disk", *self.HEXAGON.split(), "--spin=1e16", "--json"])
        self.assertLess(found["contacts"][-1]["t_end"], 1000)
        self.assertEqual(found["outcome"], "contact-cut-short")
        judged, _ = follow([SWIRL, "classify", "--sides=disk", *self.HEXAGON.split(), "--spin=1e16", "--json"])
        self.assertEqual((judged["mode"], judged["kind"]), ("undecided", "transient"))  # slip still takes energy

    def test_a_document_of_a_long_orbit_puts_vertices_on_the_wall(self):
        flags = {"sides": 5, "alpha": 0.4, "beta": 1e-3, "mu": 1, "restitution": 0.9, "x": 1e-3, "vx": 1e-11, "spin": 1e7}
        found, _ = follow(words("simulate", flags, "--collisions=50"))
        rows = found["collisions"]
        self.assertGreater(abs(rows[0]["angle"]), 1e11)
        self.assertLessEqual(max(outside(flags, row) for row in rows), 1)
        for row in rows:
            for name in ("t", "angle"):
                whole = row[f"{name}_phase"] + 2 * math.pi * row[f"{name}_turns"]
                self.assertAlmostEqual(row[name], whole, delta=2 * EPSILON * abs(whole))


if __name__ == "__main__":
    unittest.main()
