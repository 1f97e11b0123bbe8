"""The paper's claims, run again: paper_claims_test.py SWIRL ROOT"""

import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import numpy

from driving import SWIRL

ROOT = Path(sys.argv.pop(1)).resolve()
sys.path.insert(0, str(ROOT / "notebooks-export"))

from swirl_claims import claims
from swirl_claims.sampling import attractors, interval


def point(mean, error=0.01, impact=None):
    values = {"time": mean, "impact": mean if impact is None else impact}
    return claims.Point(0.1, "chaotic", 1.0, values, {k: v - 2 * error for k, v in values.items()},
                        {k: v + 2 * error for k, v in values.items()},
                        {k: int(v > 3 * error) - int(v < -3 * error) for k, v in values.items()})


class Verdicts(unittest.TestCase):
    def test_a_sign_holds_per_impact_only_or_fails(self):
        def verdict(points, sign):
            return claims.verdict_on_sign(points, sign)[0]
        self.assertEqual(verdict([point(-0.1)] * 9, -1), "holds")
        self.assertEqual(verdict([point(-0.1)] * 8 + [point(0.0)], -1), "holds")  # at one place nobody can say
        self.assertEqual(verdict([point(-0.1)] * 8 + [point(0.1)], -1), "fails")
        self.assertEqual(verdict([point(0.1, impact=-0.1)] * 9, -1), "holds per impact only")
        self.assertEqual(verdict([point(0.0)] * 9, +1), "fails")

    def test_the_size_of_friction(self):
        def verdict(means):
            return claims.verdict_on_size({mu: [point(mean)] * 10 for mu, mean in zip(claims.MU, means)})[0]
        self.assertEqual(verdict([1.0] + [-0.1] * 10), "holds")
        self.assertEqual(verdict([1.0, -0.3] + [-0.1] * 9), "fails")  # 18 % of the step
        self.assertEqual(verdict([1.0, 0.01] + [-0.01] * 9), "fails")  # it changes sign
        self.assertIn("13 % of the step", claims.verdict_on_size(
            {mu: [point(mean)] * 10 for mu, mean in zip(claims.MU, [1.03, 0.074] + [-0.07] * 9)})[1])

    def test_an_interval_holds_the_mean_as_often_as_it_says(self):
        random = numpy.random.default_rng(3)
        inside = sum(low <= 0 <= high for low, high in (interval(random.normal(size=50)) for _ in range(400)))
        self.assertGreater(inside, 400 * 0.95 - 4 * (400 * 0.95 * 0.05) ** 0.5)
        self.assertEqual(interval(numpy.array([1.0])), (-numpy.inf, numpy.inf))


class Runs(unittest.TestCase):
    def test_without_friction_the_hexagon_turns_with_the_swirl_once_a_turn(self):
        group = attractors(SWIRL, 30, sides=6, alpha=0.3, beta=0.1, mu=0, restitution=1)[0]
        low, high = interval(group.by_time, 0.9999)
        self.assertTrue(low < 1 < high, (low, high))
        self.assertEqual(len(group.by_time), 30)

    def test_a_disk_without_friction_keeps_its_rotation(self):
        group = attractors(SWIRL, 8, sides="disk", alpha=0.3, beta=0.1, mu=0, restitution=1)[0]
        self.assertEqual(set(group.by_time), {0.0})

    def test_attractors_are_told_apart(self):
        groups = attractors(SWIRL, 16, sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95)
        self.assertEqual([group.kind for group in groups], ["cycle", "fixed-point"])
        self.assertAlmostEqual(sum(group.share for group in groups), 1)
        self.assertLess(abs(groups[0].recurrence - 1 / 8).max(), 2 / claims.IMPACTS)


class Script(unittest.TestCase):
    def test_every_claim_has_a_verdict_and_a_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, ROOT / "notebooks-export/paper_claims.py", SWIRL, "-o", folder, "--runs", "8"],
                                  capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            told = json.loads((Path(folder) / "claims.json").read_text())["claims"]
            self.assertEqual(list(told), ["without-friction", "ergodic", "with-friction", "size-of-friction", "proportion", "recurrence"])
            for claim in told.values():
                for verdict in claim["verdicts"].values():
                    self.assertIn(verdict["verdict"], ("holds", "holds per impact only", "fails"))
                    self.assertIn(f"{verdict['verdict']}; {verdict['numbers']}", done.stdout)
            self.assertEqual(told["recurrence"]["verdicts"]["6"]["verdict"], "holds")
            self.assertEqual(told["without-friction"]["verdicts"]["disk"]["verdict"], "fails")  # S is what the start had
            self.assertEqual({path.name for path in Path(folder).glob("*.png")},
                             {f"{name}.png" for name in ("without-friction", "with-friction", "size-of-friction", "recurrence")})

    def test_too_few_runs_are_refused(self):
        done = subprocess.run([sys.executable, ROOT / "notebooks-export/paper_claims.py", SWIRL, "-o", "/nonexistent", "--runs", "7"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--runs 7: 8 or more", done.stderr)


if __name__ == "__main__":
    unittest.main()
