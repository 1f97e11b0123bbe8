"""Standard errors of means of chaos: how often they hold the mean of all starts. mean_errors_test.py SWIRL [--all]

With --all over ten scenes of 1,000 starts, by night, and prints their table; else 200 of the first. Scenes are chaotic from each start, for
all 20,000 impacts, and their starts' means scatter as one bell, without a second heap: one ergodic attractor, as far as these tell.
There is no disk among them: with friction disks come to roll, and without it S is conserved.
"""
import statistics
import sys
import unittest

from driving import document, run

#: N, alpha, beta, mu, e, law
SCENES = ["6 0.3 0.5 0.5 1 poisson", "6 0.3 0.5 0.5 0.9 poisson", "6 0.3 0.5 0.3 0.8 stronge", "4 0.3 0.5 0.5 0.7 newton",
          "3 0.3 0.05 1 0.9 poisson", "5 0.15 0.3 1 0.6 newton", "8 0.15 1 1 0.6 poisson", "12 0.2 0.5 0.3 0.8 newton",
          "12 0.2 0.1 1 0.7 stronge", "4 0.15 0.05 0.05 0.7 poisson"]
HEXAGON = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution"
NAMES = "sides alpha beta mu restitution law".split()
ALL = "--all" in sys.argv and not sys.argv.remove("--all")
SEEDS = 1000 if ALL else 200


def flags(scene):
    return " ".join(f"--{name} {value}" for name, value in zip(NAMES, scene.split()))


def coverage(runs, mean, error):
    """Share of runs within 2 errors of the mean over all, the spread of their means, the root mean square of their errors."""
    means, errors = [r[mean] for r in runs], [r[error] for r in runs]
    centre = statistics.fmean(means)
    within = sum(abs(m - centre) <= 2 * e for m, e in zip(means, errors)) / len(runs)
    return within, statistics.stdev(means), statistics.fmean(e * e for e in errors) ** 0.5


class Coverage(unittest.TestCase):
    def test_two_errors_hold_the_mean_of_all_starts_as_often_as_they_say(self):
        # 95.4 % of a normal distribution. 200 starts know a share to 1.5 %, so that of twenty one may well be below 92 (seeds 1
        # to 200 of the ninth scene: 91.5 %); 1,000 know it to 0.7 %.
        for scene in SCENES if ALL else SCENES[:1]:
            runs = document(f"classify {flags(scene)} --runs {SEEDS}")["runs"]
            self.assertEqual({(r["kind"], r["mean_S_kind"]) for r in runs}, {("chaotic", "sampled")}, scene)
            line = f"{scene:<30}"
            for mean, error in (("mean_S", "mean_S_error"), ("mean_S_per_impact", "mean_S_per_impact_error")):
                within, spread, claimed = coverage(runs, mean, error)
                line += f"  {mean}: spread {spread:.2g}, errors {claimed:.2g}, within 2: {100 * within:.1f} %"
                with self.subTest(scene=scene, mean=mean):
                    self.assertGreaterEqual(within, 0.92)
                    self.assertLessEqual(within, 0.98)
            print(line, flush=True)


@unittest.skipIf(ALL, "by day")
class Words(unittest.TestCase):
    def test_digits_are_cut_to_match_the_error(self):
        text = run(f"classify {HEXAGON} 1 --seed 1").stdout
        self.assertRegex(text, r"; mean S (-?0\.\d\d \+- 0\.0[2-9]|-?0\.\d\d\d \+- 0\.0(1\d|20));")

    def test_a_cycle_is_exact_a_torus_has_a_bound_and_a_short_run_no_error(self):
        cycle = document("classify --sides 12 --alpha 0.3 --beta 0.3 --mu 0.3 --restitution 0.95")
        self.assertEqual((cycle["mean_S_kind"], cycle["mean_S_error"], cycle["mean_S_per_impact_error"]), ("exact", 0, 0))
        short = document(f"classify {HEXAGON} 1 --transient 1000 --collisions 300")
        self.assertEqual((short["mode"], short["mean_S_kind"], short["mean_S_error"]), ("chaotic", "too-short", None))

    def test_of_several_runs_the_error_is_their_scatter_and_of_one_its_own(self):
        several = document(f"classify {HEXAGON} 0.9 --runs 8 --collisions 4000")
        one, = several["attractors"]
        means = [r["mean_S"] for r in several["runs"]]
        self.assertAlmostEqual(one["mean_S_error"], statistics.stdev(means) / 8 ** 0.5, delta=1e-12)
        single = document(f"classify {HEXAGON} 0.9 --runs 1 --collisions 4000")
        self.assertEqual(single["attractors"][0]["mean_S_error"], single["runs"][0]["mean_S_error"])
        self.assertEqual(single["mean_S_error"], several["runs"][0]["mean_S_error"])

    def test_sweep_and_bifurcate_say_the_same_of_a_run(self):
        counts = "--transient 3000 --collisions 4000"
        run_itself = document(f"classify {HEXAGON} 0.9 {counts} --seed 5")
        cell, = document(f"sweep {HEXAGON} 0.9 {counts} --seed 5 --grid alpha=0.3:0.3:1 --runs 1")["cells"]
        for key in ("mean_S", "mean_S_error", "mean_S_per_impact", "mean_S_per_impact_error"):
            self.assertEqual(cell[key], run_itself[key], key)
            self.assertEqual(cell["runs"][0][key], run_itself[key], key)
        self.assertEqual(cell["attractors"][0]["mean_S_error"], run_itself["mean_S_error"])


if __name__ == "__main__":
    unittest.main()
