"""Noise at impacts, from outside: noise_test.py SWIRL. --noise-restitution, --noise-mu, --noise-wall of simulate and ramp."""

import math
import statistics
import unittest

from driving import InFolder, document, run

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DISK = "--sides disk --alpha 0.3 --beta 0.5"
ALL = "--noise-restitution 0.02 --noise-mu 0.05 --noise-wall 0.02"


def restitutions(arguments):
    """By Newton's law, u_n after over u_n before, of a hexagon's impacts: u_n before is u_n after + B2 p + B3 q."""
    found = []
    for row in document(f"simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --law newton {arguments}")["collisions"]:
        sine, cosine, kappa = math.sin(row["chi"]), math.cos(row["chi"]), 5 / 12
        after = row["vn"] - 0.4 * row["spin"] * sine - 0.5 * math.sin(row["psi"])
        before = after + (1 + sine**2 / kappa) * row["impulse_normal"] + sine * cosine / kappa * row["impulse_tangential"]
        if before > 1e-3:
            found.append(-after / before)
    return found


class Noise(InFolder):
    def near_normal(self, values, mean, sigma):
        """Mean and standard deviation, each within five of its own errors."""
        count = len(values)
        self.assertAlmostEqual(statistics.fmean(values), mean, delta=5 * sigma / math.sqrt(count))
        self.assertAlmostEqual(statistics.pstdev(values), sigma, delta=5 * sigma / math.sqrt(2 * count))

    def test_none_changes_no_byte(self):
        for command in (f"simulate {HEXAGON} --collisions 50", f"simulate {HEXAGON} --collisions 20 --accuracy quad",
                        f"ramp {HEXAGON} --along beta=0.5:0.52 --rate 1e-3 --windows 3"):
            plain = run(f"{command} --json").stdout
            self.assertEqual(run(f"{command} --json --noise-restitution 0 --noise-mu 0 --noise-wall 0").stdout, plain)
            self.assertNotIn("noise", plain)

    def test_the_same_seed_gives_the_same_bytes(self):
        for command in (f"simulate {HEXAGON} --collisions 300 {ALL}", f"ramp {HEXAGON} --along beta=0.5:0.52 --rate 1e-3 --windows 3 {ALL}"):
            first = run(f"{command} --json --seed 5 --threads 1").stdout
            self.assertEqual(run(f"{command} --json --seed 5 --threads 2").stdout, first)
            self.assertNotEqual(run(f"{command} --json --seed 6 --threads 1").stdout, first)

    def test_restitution_is_distributed_as_asked(self):
        self.near_normal(restitutions("--restitution 0.7 --noise-restitution 0.05 --collisions 3000"), 0.7, 0.05)

    def test_restitution_stays_within_its_range(self):
        found = restitutions("--restitution 0.95 --noise-restitution 0.3 --collisions 3000")
        self.assertTrue(all(-1e-9 <= e <= 1 + 1e-9 for e in found))
        # Reflected at 1: of 0.95 + 0.3 xi (the few that are reflected at 0, too, change the mean by 1e-3).
        normal = statistics.NormalDist()
        z = 0.05 / 0.3
        mean = 0.95 + 2 * (0.05 * (1 - normal.cdf(z)) - 0.3 * normal.pdf(z))
        self.assertAlmostEqual(statistics.fmean(found), mean, delta=0.02)

    def test_friction_is_distributed_as_asked(self):
        fast = f"simulate {DISK} --restitution 1 --noise-mu 0.02 --collisions 400 --vx 0.4 --spin 600"
        rows = document(f"{fast} --mu 0.1")["collisions"][:200]
        self.assertEqual({row["contact_mode"] for row in rows}, {"sliding"})
        self.near_normal([abs(row["impulse_tangential"]) / row["impulse_normal"] for row in rows], 0.1, 0.02)
        rows = document(f"{fast} --mu 0")["collisions"]
        self.assertGreater(sum(row["impulse_tangential"] != 0 for row in rows), 390)

    def test_the_wall_is_turned_as_asked(self):
        """Without losses J changes by p (1 - alpha) sin eta at each impact, and by that alone."""
        rows = document(f"simulate {DISK} --mu 0 --restitution 1 --noise-wall 0.02 --collisions 4000 --vx 0.4 --vy 0.3")["collisions"]
        found = [math.asin(row["jacobi_restitution"] / row["impulse_normal"] / 0.7) for row in rows if row["impulse_normal"] > 0.3]
        self.assertGreater(len(found), 1000)
        self.near_normal(found, 0, 0.02)

    def test_j_is_balanced(self):
        for scene in (HEXAGON, f"{DISK} --mu 0.3 --restitution 0.95", f"{HEXAGON} --law stronge"):
            rows = document(f"simulate {scene} {ALL} --collisions 400")["collisions"]
            for before, row in zip(rows, rows[1:]):
                if row["number"] != before["number"] + 1 or row["flight_time"] < 1e-6:
                    continue
                self.assertAlmostEqual(row["jacobi"] - before["jacobi"], row["jacobi_restitution"] + row["jacobi_friction"], delta=1e-10)

    def test_what_it_does_not_do_is_refused(self):
        for flag in ("--noise-restitution", "--noise-mu", "--noise-wall"):
            for value in ("-0.1", "1.1", "nan", "inf"):
                result = run(f"simulate {HEXAGON} {flag} {value}")
                self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
                self.assertIn(flag[2:], result.stderr)
            self.assertEqual(run(f"simulate {HEXAGON} {flag} 0.1 --accuracy quad").returncode, 2)

    def test_it_ends_a_mode_before_its_end(self):
        """Noise leaves the cycle of two before its fold (0.38127), where without it the cycle is kept beyond."""
        ramp = ("ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --point=0.0579050729,0.2629593559,-0.5381775153,0.7252958927,-0.8956189008 "
                "--along beta=0.38:0.384 --rate 1e-6 --tolerance 0.1 --windows 4")
        self.assertGreater(document(ramp)["modes"][0]["left_at"], 0.38127)
        self.assertLess(document(f"{ramp} --noise-restitution 0.01 --seed 2")["modes"][0]["left_at"], 0.38127)


if __name__ == "__main__":
    unittest.main()
