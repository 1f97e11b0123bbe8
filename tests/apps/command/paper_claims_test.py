"""The paper's claims, run again: paper_claims_test.py SWIRL ROOT [--all]

--all: the whole script, too, which takes a quarter of a minute, and more of the intervals."""

import dataclasses
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy

from driving import SWIRL

ROOT = Path(sys.argv.pop(1)).resolve()
ALL = "--all" in sys.argv and not sys.argv.remove("--all")
sys.path.insert(0, str(ROOT / "notebooks-export"))

import paper_claims
from swirl_claims import claims, sampling
from swirl_claims.sampling import Attractor, LEAST_RUNS, attractors, interval


def point(mean, error=0.01, impact=None, kind="chaotic"):
    values = {"time": mean, "impact": mean if impact is None else impact}
    ends = {way: (value - 3 * error, value + 3 * error) for way, value in values.items()}
    return claims.Point(0.1, kind, values, ends, ends if kind == "chaotic" else dict.fromkeys(ends, (-numpy.inf, numpy.inf)))


def runs(mean, deviation=0.02, count=50):
    """Of one attractor, the same by time and by impact."""
    values = mean + deviation * numpy.random.default_rng(7).normal(size=count)
    return Attractor("chaotic", 1.0, None, values, values, values)


def riding(count=50):
    """Of a body that goes along with the floor: no impacts."""
    return Attractor("riding", 1.0, None, numpy.zeros(count), numpy.full(count, numpy.nan), numpy.full(count, numpy.nan))


@mock.patch.object(sampling, "RESAMPLES", 1000)  # what is judged lies many errors from where it would be judged otherwise
class Verdicts(unittest.TestCase):
    def test_a_sign_holds_per_impact_only_or_fails(self):
        def verdict(points, sign):
            return claims.verdict_on_sign(points, sign)[0]
        self.assertEqual(verdict([point(-0.1)] * 9, -1), "holds")
        self.assertEqual(verdict([point(-0.1)] * 8 + [point(0.0)], -1), "holds")  # at one place nobody can say
        self.assertEqual(verdict([point(-0.1)] * 8 + [point(0.1)], -1), "fails")
        self.assertEqual(verdict([point(0.1, impact=-0.1)] * 9, -1), "holds per impact only")
        self.assertEqual(verdict([point(0.0)] * 9, +1), "undecided")
        self.assertEqual(verdict([point(0.0, error=0.0)] * 9, +1), "fails")  # surely 0 is not positive
        self.assertEqual(verdict([point(-0.1)] * 7 + [point(0.1, kind="transient")] * 2, -1), "holds")  # nothing to judge yet
        self.assertIn("still transient at 0.1", claims.verdict_on_sign([point(0.1, kind="transient")], -1)[1])

    def test_the_size_of_friction(self):
        def verdict(means):
            return claims.verdict_on_size({mu: [(omega, runs(mean)) for omega in claims.OMEGA] for mu, mean in zip(claims.MU, means)})
        self.assertEqual(verdict([1.0] + [-0.1] * 10)[0], "holds")
        self.assertEqual(verdict([1.0, -0.3] + [-0.1] * 9)[0], "fails")  # 18 % of the step
        self.assertNotEqual(verdict([1.0, 0.01] + [-0.01] * 9)[0], "holds")  # it changes sign
        self.assertIn("13 % of the step", verdict([1.03, 0.074] + [-0.07] * 9)[1])

    def test_proportion(self):
        grid = {mu: [(omega, runs(-0.1)) for omega in claims.OMEGA] for mu in claims.MU}
        self.assertEqual(claims.verdict_on_proportion(grid)[0], "holds")
        grid[0.5][3] = (4, runs(-0.2))
        self.assertEqual(claims.verdict_on_proportion(grid)[0], "fails")

    def test_where_the_body_rides_with_the_floor_there_is_nothing_to_claim(self):
        everywhere = {mu: [(omega, riding()) for omega in claims.OMEGA] for mu in claims.MU}
        self.assertEqual(claims.verdict_on_size(everywhere)[0], "does not apply")
        self.assertEqual(claims.verdict_on_proportion(everywhere)[0], "does not apply")
        self.assertEqual(claims.verdict_on_recurrence({"chaotic": riding()}), ("does not apply", "chaotic: is riding"))
        rides = claims.point_of(0.3, riding(), 0.99)
        self.assertEqual(claims.verdict_on_sign([rides], -1)[0], "does not apply")
        self.assertEqual(claims.verdict_on_one([rides])[0], "does not apply")
        verdict, numbers = claims.verdict_on_sign([rides, point(-0.1), point(-0.2)], -1)
        self.assertEqual(verdict, "holds")
        self.assertIn("2 yes, 0 no, 0 open", numbers)
        self.assertIn("rides with the floor at 0.3", numbers)
        self.assertEqual(claims.verdict_on_one([point(1.0, kind="transient")])[0], "undecided")  # no attractor to judge
        with_friction = {mu: [(omega, runs(1.0) if mu == 0 else riding()) for omega in claims.OMEGA] for mu in claims.MU}
        verdict, numbers = claims.verdict_on_size(with_friction)
        self.assertEqual(verdict, "undecided", numbers)  # by time S = 0 has no sign; by impact there is none
        self.assertIn("by impact S = +0.99", numbers)
        self.assertIn("none at mu = 0.1, none at mu = 0.2", numbers)

    def test_recurrence_is_what_the_attractor_has(self):
        chaos = Attractor("chaotic", 1.0, None, *[numpy.full(12, 5e-5)] * 3)
        cycle = Attractor("cycle", 1.0, 4, *[numpy.full(12, 0.25)] * 3)
        self.assertEqual(claims.verdict_on_recurrence({"chaotic": chaos, "quasi-steady": cycle})[0], "holds")
        self.assertEqual(claims.verdict_on_recurrence({"quasi-steady": dataclasses.replace(cycle, period=8)})[0], "fails")
        self.assertEqual(claims.verdict_on_recurrence({"chaotic": cycle, "steady": riding()})[0], "holds")


class Intervals(unittest.TestCase):
    def test_an_interval_holds_the_mean_as_often_as_it_says(self):
        """Within four standard errors of that count, at 50 runs; --all: at the fewest, and in the tails, too."""
        random = numpy.random.default_rng(3)
        for count, level, most in ((50, 0.95, 0.05), (LEAST_RUNS, 0.95, 0.05), (50, 0.994, 0.006))[:None if ALL else 1]:
            missed = sum(not low <= 0 <= high for low, high in
                         (interval(random.normal(size=count), level) for _ in range(100)))
            self.assertLess(missed, 100 * most + 4 * (100 * most) ** 0.5, (count, level))
        self.assertEqual(interval(numpy.ones(LEAST_RUNS - 1)), (-numpy.inf, numpy.inf))
        self.assertEqual(interval(numpy.ones(LEAST_RUNS)), (1, 1))


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
    @unittest.skipUnless(ALL, "takes a quarter of a minute: --all")
    def test_every_claim_has_a_verdict_and_a_figure(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, ROOT / "notebooks-export/paper_claims.py", SWIRL, "-o", folder, "--runs", "12"],
                                  capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            told = json.loads((Path(folder) / "claims.json").read_text())["claims"]
            self.assertEqual(list(told), ["without-friction", "ergodic", "with-friction", "size-of-friction", "proportion", "recurrence"])
            for claim in told.values():
                for verdict in claim["verdicts"].values():
                    self.assertIn(verdict["verdict"], claims.VERDICTS)
                    self.assertIn(f"{verdict['verdict']}; {verdict['numbers']}", done.stdout)
            self.assertEqual(told["recurrence"]["verdicts"]["6"]["verdict"], "holds")
            self.assertEqual(told["without-friction"]["verdicts"]["disk"]["verdict"], "fails")  # S is what the start had
            self.assertEqual({path.name for path in Path(folder).glob("*.png")},
                             {f"{name}.png" for name in ("without-friction", "with-friction", "size-of-friction", "recurrence")})

    def test_its_range_of_drag_is_the_programs(self):
        refused = subprocess.run([SWIRL, *"simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --drag 2000".split()],
                                 capture_output=True, text=True)
        self.assertIn(f"0, or {paper_claims.LEAST_DRAG:g} to {paper_claims.MOST_DRAG:g}", refused.stderr)

    def test_wrong_input_is_one_line(self):
        file = ROOT / "README.md"
        for arguments, mention in (((SWIRL, "-o", "/tmp", "--runs", "7"), "runs = 7: allowed are 12 to"),
                                   ((SWIRL, "-o", "/tmp", "--runs", "99999999999"), "runs = 99999999999"),
                                   (("/nonexistent", "-o", "/tmp"), "'/nonexistent' is no program"),
                                   ((SWIRL, "-o", "/tmp", "--drag", "-1"), "drag = -1: allowed are 1e-75 to 1000"),
                                   ((SWIRL, "-o", "/tmp", "--drag", "nan"), "drag = nan"),
                                   ((SWIRL, "-o", "/tmp", "--drag", "2000"), "drag = 2000: allowed are"),
                                   ((SWIRL, "-o", "/tmp", "--floor", "table"), "--floor asks for --drag"),
                                   ((SWIRL, "-o", file), "is no folder"), (("/bin/false", "-o", "/tmp"), "/bin/false classify")):
            done = subprocess.run([sys.executable, ROOT / "notebooks-export/paper_claims.py", *arguments], capture_output=True,
                                  text=True)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), done.stderr)
            self.assertIn(mention, done.stderr)


if __name__ == "__main__":
    unittest.main()
