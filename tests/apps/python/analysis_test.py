"""swirl.analysis: maps that are Python functions, against closed forms and published values."""

import math
import unittest

import numpy as np

from imported import swirl
from swirl import analysis

HENON = analysis.Map(lambda z, a: (1 - a * z[0] ** 2 + z[1], 0.3 * z[0]), lambda z, a: [[-2 * a * z[0], 1], [0.3, 0]], dimension=2)
LOGISTIC = analysis.Map(lambda z, r: [r * z[0] * (1 - z[0])], dimension=1)


class Henon(unittest.TestCase):
    def test_fixed_points_are_the_roots_of_the_quadratic(self):
        found = sorted(cycle.points[0][0] for cycle in HENON.cycles(1, 1.4))
        roots = [(-0.7 + sign * math.sqrt(0.49 + 5.6)) / 2.8 for sign in (-1, 1)]
        np.testing.assert_allclose(found, roots, rtol=0, atol=1e-13)

    def test_multipliers_are_those_of_the_closed_form(self):
        for cycle in HENON.cycles(1, 1.4):
            x = cycle.points[0][0]
            roots = sorted(np.roots([1, 2.8 * x, -0.3]), key=abs, reverse=True)
            np.testing.assert_allclose(cycle.multipliers, roots, rtol=0, atol=1e-12)
            self.assertEqual((cycle.stability, cycle.period), ("unstable", 1))

    def test_cycles_are_as_many_as_published(self):
        """O. Biham, W. Wenzel, Phys. Rev. Lett. 63 (1989) 819: orbits of minimal period 2 to 7 at a = 1.4, b = 0.3."""
        starts = HENON.orbit((0.1, 0.1), 160, 1.4)[40:]
        counts = [len(HENON.cycles(period, 1.4, starts=starts)) for period in range(2, 8)]
        self.assertEqual(counts, [1, 0, 1, 0, 2, 4])

    def test_exponents_are_the_published_ones(self):
        """J. C. Sprott, Chaos and Time-Series Analysis (2003): 0.41922, -1.62319; their sum is ln 0.3."""
        found = HENON.exponents((0.1, 0.1), 1.4, steps=6_000)
        self.assertEqual((found.outcome, found.steps), ("completed", 6_000))
        self.assertAlmostEqual(found.exponents.sum(), math.log(0.3), places=9)
        self.assertLess(abs(found.exponents[0] - 0.41922), 5 * found.standard_errors[0])
        self.assertLess(found.standard_errors[0], 0.01)

    def test_differences_stand_in_for_the_jacobian(self):
        plain = analysis.Map(lambda z, a: (1 - a * z[0] ** 2 + z[1], 0.3 * z[0]), dimension=2)
        z = np.array([0.3, -0.2])
        np.testing.assert_allclose(plain.derivative(z, 1.4), HENON.derivative(z, 1.4), rtol=0, atol=1e-9)
        self.assertEqual(len(plain.cycles(2, 1.4)), 1)


class Branches(unittest.TestCase):
    def special(self, branches, kind):
        return [special.parameter for branch in branches for special in branch.special if special.kind == kind]

    def test_the_logistic_map_doubles_its_period_at_three_and_at_one_plus_the_root_of_six(self):
        start = [cycle for cycle in LOGISTIC.cycles(1, 2.5) if cycle.points[0][0] > 0.1]
        branches = LOGISTIC.continue_(start[0], between=(1.5, 3.5), switch=1)
        self.assertEqual([branch.period for branch in branches], [1, 2])
        flips = self.special(branches, "flip")
        np.testing.assert_allclose(sorted(flips), [3, 1 + math.sqrt(6)], rtol=0, atol=1e-8)
        self.assertEqual(branches[1].parent, 0)

    def test_cycles_of_three_begin_in_a_fold_at_one_plus_the_root_of_eight(self):
        cycles = LOGISTIC.cycles(3, 3.84, starts=np.linspace(0.05, 0.95, 40)[:, None])
        self.assertEqual(len(cycles), 2)
        branch = LOGISTIC.continue_(cycles[0], between=(3.8, 3.9))
        np.testing.assert_allclose(self.special(branch, "fold"), [1 + math.sqrt(8)], rtol=0, atol=1e-8)

    def test_the_delayed_logistic_map_loses_its_fixed_point_to_a_torus_at_two(self):
        delayed = analysis.Map(lambda z, r: (r * z[0] * (1 - z[1]), z[0]), dimension=2)
        branch = delayed.continue_([[1 - 1 / 1.8] * 2], between=(1.5, 2.2), parameter=1.8)
        np.testing.assert_allclose(self.special(branch, "neimark-sacker"), [2], rtol=0, atol=1e-8)

    def test_the_logistic_map_at_four_has_the_exponent_ln_two(self):
        found = LOGISTIC.exponents([0.3], 4, steps=6_000)
        self.assertLess(abs(found.exponents[0] - math.log(2)), 5 * found.standard_errors[0])


class Basins(unittest.TestCase):
    def test_henons_map_has_one_and_the_rest_escapes(self):
        """Against 1000 steps from each centre; R. Devaney, Z. Nitecki (1979): what leaves |x| < 2.5 goes to infinity."""
        found = HENON.basins(((-2.5, 2.5, 60), (-2.5, 2.5, 60)), 1.4)
        self.assertEqual((set(np.unique(found.labels)), len(found.attractors)), ({analysis.ESCAPES, 0}, 1))
        x, y = np.meshgrid(*((edge[1:] + edge[:-1]) / 2 for edge in found.edges), indexing="ij")
        with np.errstate(all="ignore"):
            for _ in range(1000):
                x, y = 1 - 1.4 * x * x + y, 0.3 * x
        stays = abs(x) < 2.5
        # An orbit that runs through cells of a basin for ten steps may yet leave it: a few on the boundary.
        self.assertLess(np.mean(stays != (found.labels == 0)), 0.01)
        self.assertAlmostEqual(found.shares()[0], np.mean(found.labels == 0), places=12)
        inside = np.abs(found.attractors[0]).max(axis=0)
        self.assertLess(inside[0], 1.4)
        self.assertLess(inside[1], 0.5)

    def test_a_cubic_map_has_two_on_either_side_of_zero(self):
        cubic = analysis.Map(lambda z: [1.5 * z[0] - 0.5 * z[0] ** 3], dimension=1)  # to -1 and 1 from |x| < 3 ** 0.5
        found = cubic.basins([(-1.7, 1.7, 200)])
        middles = (found.edges[0][1:] + found.edges[0][:-1]) / 2
        np.testing.assert_array_equal(found.labels, np.where(middles < 0, 0, 1))
        np.testing.assert_allclose(np.ravel(found.attractors), [-1, 1], rtol=0, atol=0.0086)  # half a cell

    def test_a_turn_comes_back_to_no_cell_often_enough(self):
        turn = analysis.Map(lambda z: [(z[0] + 2 ** 0.5) % 50], dimension=1)
        self.assertEqual(turn.basins([(0, 50, 2000)], most_steps=20).shares(), {analysis.UNRESOLVED: 1.0})

    def test_wrong_boxes_are_named(self):
        for box, words in (([(0, 1, 5)], "box has 1 sides"), ([(0, 1), (0, 1)], "box has 2 sides"), ([(0, 1, 0)] * 2, "cells = 0 is outside"),
                           ([(1, 0, 5)] * 2, "box = 1 to 0 is outside"), ([(0, float("nan"), 5)] * 2, "box = 0 to nan")):
            with self.assertRaisesRegex(ValueError, words):
                HENON.basins(box, 1.4)


class OfAUser(unittest.TestCase):
    def test_what_the_function_throws_is_thrown(self):
        def broken(z, p):
            raise KeyError("own")
        for use in (lambda m: m.cycles(1), lambda m: m.exponents([0.1]), lambda m: m.continue_([[0.1]], between=(0, 1), parameter=0.5)):
            with self.assertRaisesRegex(KeyError, "own"):
                use(analysis.Map(broken, dimension=1, jacobian=lambda z, p: [[1]]))

    def test_a_map_that_ends_is_an_outcome(self):
        ends = analysis.Map(lambda z: None if z[0] > 5 else z * 1.1, dimension=1)
        self.assertEqual(ends.exponents([1.0], steps=100, transient=0).outcome, "ended-early")

    def test_wrong_input_is_named(self):
        with self.assertRaisesRegex(ValueError, "no parameter"):
            analysis.Map(lambda z: z, dimension=1).continue_([[0.0]], between=(0, 1), parameter=0)
        with self.assertRaisesRegex(ValueError, "outside `between`"):
            LOGISTIC.continue_([[0.6]], between=(1, 2), parameter=2.5)
        with self.assertRaisesRegex(ValueError, "dimension = 0"):
            analysis.Map(lambda z: z, dimension=0)
        for wrong, words in ((lambda: HENON.cycles(period=0), "period = 0 is outside its range: 1 or more"),
                             (lambda: HENON.cycles(period=1.5), "period = 1.5 is no whole number"),
                             (lambda: HENON.cycles(accept=float("nan")), "accept = nan is outside its range: above 0"),
                             (lambda: HENON.cycles(starts=[[0.1] * 3]), r"starts has the shape \(1, 3\); \(n, 2\) is wanted"),
                             (lambda: HENON.orbit(0.1, 5), r"z has the shape \(\); \(2,\) is wanted"),
                             (lambda: HENON.orbit((0.1, 0.1), -1), "steps = -1 is outside its range: 0 or more"),
                             (lambda: HENON.exponents((0.1, 0.1), 1.4, steps=0), "steps = 0 is outside its range: 1 or more"),
                             (lambda: HENON.exponents((0.1, 0.1), 1.4, transient=-1), "transient = -1"),
                             (lambda: LOGISTIC.continue_([[0.6]], (2, 3), 2.5, longest_step=0), "longest_step = 0 is outside its range: above 0"),
                             (lambda: LOGISTIC.continue_([[0.6]], (2, 3), 2.5, switch=-1), "switch = -1")):
            with self.assertRaisesRegex(ValueError, words):
                wrong()

    def test_an_angle_is_one(self):
        turning = analysis.Map(lambda z: [(z[0] + 2 * np.pi / 3) % (2 * np.pi)], dimension=1, angles={0: 2 * np.pi},
                               jacobian=lambda z: [[1.0]])
        found = turning.cycles(3, starts=[[0.5], [0.5 - 2 * np.pi / 3]])  # one cycle, whole turns apart
        self.assertEqual([cycle.period for cycle in found], [3])
        self.assertEqual(found[0].stability, "neutral")


if __name__ == "__main__":
    unittest.main()
