"""One oracle per regime for classify, lyapunov, recurrence and spectrum, from the command line: regimes_test.py SWIRL

Fixed, periodic, quasi-periodic, chaotic, transient, and each measured with 1 % noise. (lyapunov has no measured series:
its counterpart there is the exponent of classify --series.)
"""

import math
import random
import tempfile
import unittest
from pathlib import Path

from driving import document, run

FIXED = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # of period 8
TORUS = "--sides 4 --alpha 0.52 --beta 0.46 --mu 0.6 --restitution 0.75"  # attracts
CHAOS = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
GROWS = "--sides 4 --alpha 0.625 --beta 0.493 --mu 0.475 --restitution 1"  # accelerated for ever: no mean


def impacts(scene, count, skip):
    return document(f"simulate {scene} --collisions {count + skip} --skip {skip}")["collisions"]


def line_at(values, frequency):
    """Share of the variance in a line at this frequency, cycles per sample (Hann window, all of its main lobe)."""
    n = len(values)
    mean = math.fsum(values) / n
    weights = [math.sin(math.pi * (i + 0.5) / n) ** 2 for i in range(n)]
    x = [w * (v - mean) for w, v in zip(weights, values)]
    re = math.fsum(v * math.cos(2 * math.pi * frequency * i) for i, v in enumerate(x))
    im = math.fsum(v * math.sin(2 * math.pi * frequency * i) for i, v in enumerate(x))
    amplitude = 2 * math.hypot(re, im) / math.fsum(weights)
    variance = math.fsum((v - mean) ** 2 for v in values) / n
    return amplitude**2 / 2 / variance


class QuasiPeriodic(unittest.TestCase):
    def test_classify_finds_the_rotation_number_that_the_impacts_have(self):
        found = document(f"classify {TORUS}")
        self.assertEqual((found["mode"], found["kind"], found["period"]), ("quasi-steady", "quasi-periodic", None))
        rotation = found["rotation_number"]
        spins = [row["spin"] for row in impacts(TORUS, 4000, 4000)]
        share = line_at(spins, rotation)
        self.assertGreater(share, 0.3)
        # Two bins away the window has nothing left: the line is there to a few parts in 10 000, and it is S's own.
        for off in (-2.5 / 4000, 2.5 / 4000):
            self.assertLess(line_at(spins, rotation + off), 1e-2 * share)
        combinations = math.fsum(line_at(spins, m * rotation) for m in range(1, 31))
        self.assertGreater(combinations, 0.99)
        self.assertEqual(document(f"classify {TORUS} --seed 2")["kind"], "quasi-periodic")

    def test_a_torus_round_an_attracting_fixed_point_is_not_taken_for_it(self):
        found = document("classify --sides 6 --alpha 0.71148787443208794 --beta 0.32971519551788647 "
                         "--mu 0.33155311847740321 --restitution 1 --seed 1588")
        self.assertEqual((found["kind"], found["period"]), ("quasi-periodic", None))

    def test_a_torus_near_a_rational_one_is_no_cycle(self):
        # Nothing attracts there (mu = 0, e = 1), and Newton's method finds a cycle beside each.
        for alpha, beta, seed in ((0.3, 0, 1), (0.6739, 1.45501, 460), (0.3, 0.001, 3), (0.7784, 0.00134, 185),
                                  (0.4665, 0.00174, 768)):
            scene = f"--sides disk --alpha {alpha} --beta {beta} --mu 0 --restitution 1 --seed {seed}"
            found = document(f"classify {scene}")
            self.assertEqual((found["kind"], found["period"]), ("quasi-periodic", None), scene)

    def test_lyapunov_has_one_zero_the_rest_attracts(self):
        found = document(f"lyapunov {TORUS} --collisions 20000")
        self.assertEqual(found["signs"], ["neutral"] + 4 * ["negative"])
        self.assertLess(abs(found["exponents"][0]), 1e-10)
        self.assertLess(found["exponents"][1], -0.1)

    def test_recurrence_has_lines_that_end_at_the_border_only(self):
        found = document(f"recurrence {TORUS} --collisions 2000 --threshold-std 0.1 --observable psi,chi,vn,vt,S")
        # A return within the threshold stays one for ever, as the torus turns rigidly: but for those at its rim.
        self.assertGreater(found["DET"], 0.9)
        self.assertGreater(found["Lmax"], 1900)

    def test_spectrum_has_lines_at_multiples_of_the_rotation(self):
        rotation = document(f"classify {TORUS}")["rotation_number"]
        rows = impacts(TORUS, 20000, 4000)
        impact_rate = 2 * math.pi * len(rows) / math.fsum(row["flight_time"] for row in rows)
        found = document(f"spectrum {TORUS}")
        self.assertEqual(found["verdict"], "lines")
        for peak in found["peaks"][:6]:
            nearest = min(abs(peak["frequency"] / impact_rate - (k + m * rotation))
                          for k in range(-2, 4) for m in range(-12, 13))
            self.assertLess(nearest, 2e-4, peak)


class Chaotic(unittest.TestCase):
    def test_all_four_say_so(self):
        verdict = document(f"classify {CHAOS}")
        self.assertEqual(verdict["mode"], "chaotic")
        lyapunov = document(f"lyapunov {CHAOS} --collisions 20000")
        self.assertEqual(lyapunov["signs"][0], "positive")
        error = math.hypot(lyapunov["standard_errors"][0], verdict["largest_exponent_error"])
        self.assertAlmostEqual(lyapunov["exponents"][0], verdict["largest_exponent"], delta=5 * error)
        self.assertLess(document(f"recurrence {CHAOS} --collisions 2000")["DET"], 0.5)
        self.assertEqual(document(f"spectrum {CHAOS}")["verdict"], "continuum")


class Transient(unittest.TestCase):
    def test_what_is_accelerated_for_ever_has_no_mean(self):
        speeds = [math.hypot(row["vx"], row["vy"]) for row in impacts(GROWS, 20000, 0)[99::100]]
        self.assertGreater(min(speeds[100:]), max(speeds[:3]))
        found = document(f"classify {GROWS}")
        self.assertEqual((found["mode"], found["kind"], found["mean_S"]), ("quasi-steady", "accelerated", None))
        self.assertLess(found["growth_exponent"]["low"], found["growth_exponent"]["high"])
        self.assertGreater(found["growth_exponent"]["low"], 0)
        self.assertNotIn("positive", document(f"lyapunov {GROWS} --collisions 20000")["signs"])

    def test_what_hardly_attracts_is_no_torus(self):
        """Just before a Neimark-Sacker point, at alpha = 0.66614416, a fixed point attracts, with 1 - |m| of 1.9e-5 and 1.1e-6."""
        start = "--point=-0.023186593972248915,0.007728710755045552,-0.3070506531500751,0.7538021988692216,-0.3811150550226311"
        for alpha, limits in ((0.6661391577905945, "--transient 500 --collisions 500"), (0.6661438577905945, "")):
            verdict = document(f"classify --sides 6 --alpha {alpha} --beta 0.5 --mu 0.5 --restitution 0.95 {start} {limits}")
            self.assertEqual((verdict["mode"], verdict["period"]), ("steady", 1), limits)

    def test_what_settles_is_told_from_what_has_settled(self):
        early, late = f"{FIXED} --transient 0 --collisions 600", f"{FIXED} --transient 2000 --collisions 600"
        self.assertEqual(document(f"spectrum {early}")["verdict"], "nonstationary")
        self.assertEqual(document(f"spectrum {late}")["spectrum_outcome"], "constant")
        settling = document(f"recurrence {early} --threshold 1e-6")
        self.assertLess(settling["RR"], 1)
        self.assertGreater(settling["LAM"], 0.9)  # it stays where it has come to
        self.assertEqual(document(f"recurrence {late} --threshold 1e-6")["RR"], 1)
        # The fixed point's own exponent (cycles.json: its largest multiplier).
        exact = math.log(math.hypot(0.603654650944, 0.745364501151))
        plain = document(f"lyapunov {early}")["plain_means"][0], document(f"lyapunov {late}")["plain_means"][0]
        self.assertGreater(abs(plain[0] - exact), abs(plain[1] - exact))


class InContact(unittest.TestCase):
    """Cycles that land: mean S, spectrum and samples go through the contact as through the flights."""

    LANDING = "--sides 5 --alpha 0.6433 --beta 0.5562 --mu 2 --restitution 0 --seed 803"  # of period 1
    OTHERS = ("--sides 3 --alpha 0.8 --beta 0.9 --mu 0.5 --restitution 0",
              "--sides 12 --alpha 0.5899 --beta 0.971 --mu 2 --restitution 0",
              "--sides 4 --alpha 0.7373 --beta 1.3231 --mu 1.5 --restitution 0 --seed 237")

    def test_mean_S_is_that_of_the_angle(self):
        for scene in (self.LANDING, *self.OTHERS):
            found = document(f"classify {scene} --transient 3000 --collisions 2000")
            self.assertEqual((found["mode"], found["kind"]), ("quasi-steady", "landing"), scene)
            rows = impacts(scene, found["period"] * 10 + 1, 4000)
            mean = (rows[-1]["angle"] - rows[0]["angle"]) / (rows[-1]["t"] - rows[0]["t"])
            self.assertAlmostEqual(found["mean_S"], mean, delta=1e-8, msg=scene)

    def test_the_changes_of_J_add_up(self):
        scene = "--sides 3 --alpha 0.1999 --beta 0.224 --mu 3 --restitution 0.2 --law newton --seed 8878"
        found = document(f"simulate {scene} --collisions 300")
        largest = 0
        for before, after in zip(found["collisions"], found["collisions"][1:]):
            change = after["jacobi_restitution"] + after["jacobi_friction"]
            for contact in found["contacts"]:  # those between the two, but for the rounding of t
                if before["t"] - 1e-12 <= contact["t_start"] and contact["t_end"] <= after["t"] + 1e-12:
                    change += contact["jacobi_friction"] + contact["landing_jacobi"]
            largest = max(largest, abs(after["jacobi"] - before["jacobi"] - change))
        self.assertLess(largest, 1e-12)  # contact is integrated to some 1e-14 a piece

    def test_what_contact_annihilates_has_no_exponent(self):
        found = document(f"lyapunov {self.LANDING} --transient 200 --collisions 400")
        self.assertEqual(found["exponents"][2:], [None, None, None])
        orbit, = (o for o in document(f"orbits {self.LANDING} --period 1 --starts 60 --trajectories 4 --collisions 300")["orbits"]
                  if o["word"][0].get("through_contact"))
        self.assertEqual([m for m in orbit["multipliers"][2:]], [[0, 0]] * 3)

    def test_chatter_counts_once(self):
        """However many rebounds rounding can tell apart: the pentagon that lands from one vertex to the next has period 1."""
        scene = "--sides 5 --alpha 0.6433 --beta 0.5562 --mu 2 --seed 803"
        for e in (0, 0.02, 0.05, 0.1):
            found = document(f"classify {scene} --restitution {e} --transient 500 --collisions 300")
            self.assertEqual((found["kind"], found["period"], found["recurrence_rate"]), ("landing", 1, 1), e)
            self.assertEqual(found["mean_S_per_impact"], found["point"][-1], e)
            orbit, = (o for o in document(f"orbits {scene} --restitution {e} --starts 60 --trajectories 4 --collisions 300")["orbits"]
                      if o["word"][0].get("through_contact") and o["stability"] == "stable")
            self.assertAlmostEqual(orbit["points"][0]["S"], found["point"][-1], delta=1e-9, msg=e)
            self.assertAlmostEqual(orbit["mean_S"], found["mean_S"], delta=1e-9, msg=e)
            self.assertEqual(len(orbit["word"]), 1)

    def test_a_landing_has_a_branch(self):
        scene = "--sides 5 --alpha 0.6433 --beta 0.5562 --mu 2 --seed 803"
        points = {e: document(f"classify {scene} --restitution {e} --transient 500 --collisions 300")["point"] for e in (0.02, 0.05)}
        near = ",".join(map(repr, points[0.05]))
        branch = document(f"continue {scene.split(' --seed')[0]} --restitution 0.05 --from={near} --along restitution=0.02:0.08")["branches"][0]
        ends = {p["parameter"]: p for p in branch["points"]}
        self.assertEqual((branch["period"], min(ends), max(ends)), (1, 0.02, 0.08))
        self.assertAlmostEqual(ends[0.02]["point"]["S"], points[0.02][-1], delta=1e-9)

    def test_a_landing_without_restitution_has_a_branch(self):
        """At e = 0 impacts end on the wall, here (triangle) with an edge on it; beside that surface the map is another."""
        scene = {"alpha": 0.7415, "beta": 1.4442, "mu": 0.5}

        def flags(numbers):
            return "--sides 3 --restitution 0 " + " ".join(f"--{name} {value!r}" for name, value in numbers.items())

        def attractor(numbers):
            found = document(f"classify {flags(numbers)} --transient 500 --collisions 300")
            self.assertEqual((found["kind"], found["period"]), ("landing", 1), numbers)
            return found["point"]

        begin = ",".join(map(repr, attractor(scene)))
        for name, low, high in (("alpha", 0.6, 0.88), ("beta", 1.2, 1.7)):
            branch, = document(f"continue {flags(scene)} --from={begin} --along {name}={low}:{high}")["branches"]
            self.assertEqual((branch["begins"], branch["ends"], branch["special"]), ("range", "range", []))
            self.assertLess(len(branch["points"]), 400)
            for end in (branch["points"][0], branch["points"][-1]):
                direct = attractor({**scene, name: end["parameter"]})
                for coordinate, value in zip(end["point"].values(), direct):
                    self.assertAlmostEqual(coordinate, value, delta=1e-12, msg=(name, end["parameter"]))

    def test_what_rocks_with_strong_friction_has_a_branch(self):
        # On an edge's end that sticks while the other leaves: a slip of one side, however small, jams.
        for scene, begin, ranges in (
                ("--sides 6 --alpha 0.6111 --beta 1.7111 --mu 2.3602 --law stronge",
                 "0.0019764215037905318,0.21308277552672883,-0.0762961841778097,2.07935008844366,-0.6165516369235937",
                 (("alpha", 0.598878, 0.623322), ("beta", 1.676878, 1.745322))),
                ("--sides 5 --alpha 0.6735 --beta 1.2148 --mu 2.2911 --law poisson",
                 "-0.06448063485701153,0.2212998098734161,-0.1412877595726626,1.4923432730559238,-0.42623395283885324",
                 (("beta", 1.190504, 1.239096),)),
                ("--sides 4 --alpha 0.7080 --beta 1.6696 --mu 1.7637 --law stronge",
                 "-0.060217409210692685,0.2610699240181944,-0.15097879894967892,1.85559591379238,-0.2763444711004449",
                 (("mu", 1.710804, 1.816627),))):
            for name, low, high in ranges:
                branch, *_ = document(f"continue {scene} --restitution 0 --along {name}={low}:{high} --from={begin} --switch 0")["branches"]
                ends = {branch["points"][0]["parameter"], branch["points"][-1]["parameter"]}
                self.assertEqual((branch["begins"], branch["ends"], ends), ("range", "range", {low, high}), scene)
                self.assertLess(len(branch["points"]), 60, scene)

    def test_rounding_is_no_neimark_sacker_point(self):
        # A multiplier of -2e6 beside others near zero: products of pairs pass 1 by rounding alone. Steps in more digits:
        # those of double err by 2e-9 here (rms of 60 by 113 bits), and which of Newton's last points closes is chance: of
        # twelve starts within 1e-9 of the cycle none closed so, and one in 113 bits. This start, drawn within 3e-10 of the
        # cycle until one closed in 64 bits, does so to 4e-10.
        scene = "--sides 4 --alpha 0.2151 --beta 0.6809 --mu 0.4347287571273213 --restitution 0"
        near = "-0.9258337522686458,0.6327068624190595,-0.5366611488125189,1.094454095648315,0.05865953800769097"
        branch, = document(f"continue {scene} --along mu=0.4347286:0.434729 --from={near} --accuracy extended")["branches"]
        self.assertNotIn("neimark-sacker", {special["kind"] for special in branch["special"]})
        self.assertGreater(abs(branch["points"][0]["multipliers"][0][0]), 1e6)

    def test_the_spectrum_has_the_variance_of_the_samples(self):
        scene = f"{self.LANDING} --transient 500 --collisions 501"
        found = document(f"spectrum {scene} --bins 65536 --window rectangular --segments 1")
        rows = impacts(self.LANDING, 501, 500)
        begin, end = rows[0]["t"], rows[-1]["t"]
        width = (end - begin) / 65536
        step = width / 2  # two samples a bin: S jumps in few of them
        samples = document(f"simulate {self.LANDING} --collisions 1001 --skip 500 --sample {step!r}")["samples"]
        spins = [row["spin"] for row in samples if begin <= row["t"] <= end]
        mean = math.fsum(spins) / len(spins)
        variance = math.fsum((v - mean) ** 2 for v in spins) / len(spins)
        self.assertAlmostEqual(found["variance"] / variance, 1, delta=0.01)
        self.assertTrue(0.6 < sum(row["in_contact"] for row in samples) / len(samples) < 0.7)

    def test_a_record_has_the_spectrum_of_its_scene(self):
        with tempfile.TemporaryDirectory() as folder:
            whole, late, thin = (f"{folder}/{name}.h5" for name in ("whole", "late", "thin"))
            for flags, record in (("", whole), ("--skip 100", late), ("--every 4", thin)):
                done = run(f"simulate {self.OTHERS[0]} --collisions 300 {flags} --quiet -o {record}")
                self.assertEqual(done.returncode, 0)
            direct = document(f"spectrum {self.OTHERS[0]} --transient 100 --collisions 200 --quiet")
            for arguments in (f"{whole} --transient 100", late):
                found = document(f"spectrum {arguments} --quiet")
                for key in ("frequency", "power", "variance"):
                    self.assertEqual(found[key], direct[key], arguments)
            refused = run(f"spectrum {thin}")
            self.assertEqual((refused.returncode, refused.stdout), (2, ""))
            self.assertIn("every 4th", refused.stderr)

    def test_a_period_that_only_rounding_closes_is_none(self):
        # Double returns after 48 impacts, 80 bits after 127: chaos between superstable landings (DF nilpotent).
        found = document("classify --sides 3 --alpha 0.3259 --beta 0.2656 --mu 1 --restitution 0 --law newton --seed 150")
        self.assertEqual((found["mode"], found["kind"], found["period"]), ("undecided", None, None))
        self.assertIn("growth of rounding along the period", [e["name"] for e in found["evidence"]])

    def test_no_sample_comes_before_what_is_skipped(self):
        scene = "--sides disk --alpha 0.3 --beta 0.3 --mu 0.4 --restitution 0.5"
        found = document(f"simulate {scene} --collisions 1000 --skip 900 --sample 50", 3)
        self.assertEqual((found["collisions"], found["samples"]), ([], []))

    def test_the_place_follows_its_spectrum(self):
        """Its mean square over the bins is that of the samples."""
        scene = f"{self.OTHERS[0]} --transient 50 --collisions 101"
        found = document(f"spectrum {scene} --observable position --frame corotating --bins 4096 --detrend none "
                         "--window rectangular --segments 1")
        rows = impacts(self.OTHERS[0], 101, 50)
        samples = document(f"simulate {self.OTHERS[0]} --collisions 151 --skip 50 --sample 0.001")["samples"]
        inside = [row for row in samples if rows[0]["t"] <= row["t"] <= rows[-1]["t"]]
        turned = [complex(r["x"], r["y"]) * complex(math.cos(r["t"]), -math.sin(r["t"])) for r in inside]
        square = math.fsum(abs(z) ** 2 for z in turned) / len(turned)
        self.assertAlmostEqual(found["variance"] / square, 1, delta=1e-3)


class Measured(unittest.TestCase):
    """S of 2,000 impacts with 1 % noise: of its deviation, or of its size where it is constant."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.noise = random.Random(3)

    def series(self, scene):
        spins = [row["spin"] for row in impacts(scene, 2000, 4000)]
        mean = math.fsum(spins) / len(spins)
        deviation = math.sqrt(math.fsum((s - mean) ** 2 for s in spins) / len(spins))
        size = 0.01 * (deviation if deviation > 1e-9 else abs(mean))
        path = self.folder / "s.csv"
        path.write_text("S\n" + "".join(f"{s + self.noise.gauss(0, size)!r}\n" for s in spins))
        return f"--series {path}", size

    def test_fixed(self):
        series, noise = self.series(FIXED)
        known = document(f"classify {series} --noise {noise}")
        self.assertEqual((known["mode"], known["kind"]), ("steady", "fixed-point"))
        self.assertEqual(document(f"classify {series}")["mode"], "undecided")  # noise of unknown size alone
        self.assertGreater(document(f"recurrence {series} --threshold {6 * noise}")["RR"], 0.99)
        self.assertEqual(document(f"spectrum {series}")["verdict"], "continuum")  # the noise's

    def test_periodic(self):
        series, _ = self.series(CYCLE)
        found = document(f"classify {series}")
        self.assertEqual((found["kind"], found["period"]), ("cycle", 8))
        peaks = document(f"spectrum {series}")["peaks"]
        for peak in peaks[:3]:
            self.assertAlmostEqual(8 * peak["frequency"], round(8 * peak["frequency"]), delta=1e-4)
        self.assertEqual(document(f"recurrence {series} --threshold-std 0.1")["Lmax"], 2000 - 8)

    def test_quasi_periodic(self):
        series, _ = self.series(TORUS)
        self.assertEqual(document(f"classify {series}")["kind"], "quasi-periodic")
        rotation = document(f"classify {TORUS}")["rotation_number"]
        spectrum = document(f"spectrum {series}")
        self.assertEqual(spectrum["verdict"], "lines")
        self.assertAlmostEqual(spectrum["peaks"][0]["frequency"], rotation, delta=1e-5)
        self.assertGreater(document(f"recurrence {series} --threshold-std 0.2 --dimension 2")["Lmax"], 1000)

    def test_chaotic(self):
        series, _ = self.series(CHAOS)
        found = document(f"classify {series}")
        # So wild that no embedding predicts it: not enough evidence for chaos, and never taken for regular.
        self.assertIn(found["mode"], ("chaotic", "undecided"))
        self.assertIsNone(found["period"])
        self.assertEqual(document(f"spectrum {series}")["verdict"], "continuum")
        self.assertLess(document(f"recurrence {series}")["DET"], 0.4)


if __name__ == "__main__":
    unittest.main()
