"""How the comparison judges: times at equal error, means with their errors. Exit code 77: python3-scipy is missing."""

import math
import random
import sys
import unittest

try:
    from judgement import time_at_error
    from statistics_of_peers import distances, ratio_and_error, verdict
except ImportError:
    print("skipped: python3-scipy is not installed (packages.txt)")
    sys.exit(77)


class TimeAtEqualError(unittest.TestCase):
    LADDER = [(error, error**-0.25) for error in (1e-6, 1e-9, 1e-12)]  # a method of fourth order

    def test_between_two_tolerances_it_is_on_their_power_law(self):
        self.assertAlmostEqual(time_at_error(self.LADDER, 1e-8), 1e2)
        self.assertAlmostEqual(time_at_error(self.LADDER, 1e-11), 10**2.75)

    def test_at_a_tolerance_it_is_that_of_the_tolerance(self):
        self.assertAlmostEqual(time_at_error(self.LADDER, 1e-9), 10**2.25)

    def test_a_ladder_that_ends_above_the_error_never_comes_there(self):
        self.assertIsNone(time_at_error(self.LADDER, 1e-13))
        self.assertIsNone(time_at_error([(math.nan, 1.0)], 1e-3))

    def test_a_ladder_below_the_error_takes_its_cheapest_step(self):
        self.assertAlmostEqual(time_at_error(self.LADDER, 1e-3), 10**1.5)


class MeansOverOrbits(unittest.TestCase):
    def test_error_of_equal_weights_is_that_of_a_mean(self):
        mean, error = ratio_and_error([1.0, 3.0, 5.0], [1.0, 1.0, 1.0])
        self.assertAlmostEqual(mean, 3)
        self.assertAlmostEqual(error, 2 / math.sqrt(3))

    def test_error_covers_the_true_ratio_as_often_as_it_should(self):
        source, covered = random.Random(1), 0
        for _ in range(1000):
            times = [source.uniform(1, 3) for _ in range(100)]
            mean, error = ratio_and_error([0.3 * time + source.gauss(0, 1) for time in times], times)
            covered += abs(mean - 0.3) < 2 * error
        self.assertGreater(covered, 930)  # 954 expected
        self.assertLess(covered, 975)

    def test_what_is_three_errors_away_differs_and_what_is_one_away_agrees(self):
        own = ((1.0, 0.03), (0.0, 1.0), (0.0, 1.0), (0.0, 1.0))
        other = ((1.0, 0.04), (0.0, 1.0), (0.0, 1.0), (0.0, 1.0))
        moved = ((1.15, 0.04), *other[1:])
        self.assertAlmostEqual(distances(moved, own)[0], 3)
        self.assertEqual(verdict(other, own, "Newton"), "agrees with Newton")
        self.assertEqual(verdict(moved, own, "Newton"), "differs from Newton: S over time by 3.0")


if __name__ == "__main__":
    unittest.main()
