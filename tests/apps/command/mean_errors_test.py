"""Standard errors of means of chaos: how often they hold the mean of all starts. mean_errors_test.py SWIRL [--all]

With --all over ten scenes of 1,000 starts, by night, and prints their table; else 200 of the first. Scenes are chaotic from each start, for
all 20,000 impacts, and their starts' means scatter as one bell, without a second heap: one ergodic attractor, as far as these tell.
There is no disk among them: with friction no impact of a disk makes J + I S/alpha larger (map/README.md, "Energy in the swirling frame"), so that chaos
ends there, and without friction S is conserved: its mean has no error.
"""
import math
import statistics
import sys
import unittest

from driving import InFolder, document, error_over_runs, run

#: N, alpha, beta, mu, e, law
SCENES = ["6 0.3 0.5 0.5 1 poisson", "6 0.3 0.5 0.5 0.9 poisson", "6 0.3 0.5 0.3 0.8 stronge", "4 0.3 0.5 0.5 0.7 newton",
          "3 0.3 0.05 1 0.9 poisson", "5 0.15 0.3 1 0.6 newton", "8 0.15 1 1 0.6 poisson", "12 0.2 0.5 0.3 0.8 newton",
          "12 0.2 0.1 1 0.7 stronge", "4 0.15 0.05 0.05 0.7 poisson"]
HEXAGON = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution"
TORUS = "--sides 4 --alpha 0.52 --beta 0.46 --mu 0.6 --restitution 0.75"
NAMES = "sides alpha beta mu restitution law".split()
ALL = "--all" in sys.argv and not sys.argv.remove("--all")
SEEDS = 1000 if ALL else 200


def flags(scene):
    return " ".join(f"--{name} {value}" for name, value in zip(NAMES, scene.split()))


def coverage(runs, mean, error):
    """Number of runs within 2 errors of the mean over all, the spread of their means, the root mean square of their errors."""
    means, errors = [r[mean] for r in runs], [r[error] for r in runs]
    centre = statistics.fmean(means)
    within = sum(abs(m - centre) <= 2 * e for m, e in zip(means, errors))
    return within, statistics.stdev(means), statistics.fmean(e * e for e in errors) ** 0.5


def uncertain(within, runs):
    """The binomial standard error of a share."""
    return (within / runs * (1 - within / runs) / runs) ** 0.5


class Coverage(unittest.TestCase):
    def test_two_errors_hold_the_mean_of_all_starts_as_often_as_they_say(self):
        # 92 to 98 %; 95.4 % of a normal distribution. 200 starts know a share to 1.5 %, so that one of twenty below 92 tells nothing
        # (seeds 1 to 200 of the ninth scene: 91.5 +- 2.0 %); by night 1,000 know it to 0.7 %, and each share is held to the promise
        # itself. All scenes together know theirs to 0.2 %: three times that beside it must be within.
        pooled = {}
        for scene in SCENES if ALL else SCENES[:1]:
            runs = document(f"classify {flags(scene)} --runs {SEEDS}")["runs"]
            self.assertEqual({(r["kind"], r["mean_S_kind"]) for r in runs}, {("chaotic", "sampled")}, scene)
            line = f"{scene:<30}"
            for mean, error in (("mean_S", "mean_S_error"), ("mean_S_per_impact", "mean_S_per_impact_error")):
                within, spread, claimed = coverage(runs, mean, error)
                share, known = within / SEEDS, uncertain(within, SEEDS)
                line += f"  {mean}: spread {spread:.2g}, errors {claimed:.2g}, within 2: {100 * share:.1f} +- {100 * known:.1f} %"
                pooled.setdefault(mean, []).append(within)
                with self.subTest(scene=scene, mean=mean):
                    self.assertGreaterEqual(share, 0.92)
                    self.assertLessEqual(share, 0.98)
            print(line, flush=True)
        for mean, counts in pooled.items() if ALL else ():
            starts = SEEDS * len(counts)
            share, known = sum(counts) / starts, uncertain(sum(counts), starts)
            print(f"all {starts} starts: {mean} within 2: {100 * share:.2f} +- {100 * known:.2f} %")
            self.assertGreaterEqual(share - 3 * known, 0.92, mean)
            self.assertLessEqual(share + 3 * known, 0.98, mean)


@unittest.skipIf(ALL, "by day")
class Words(unittest.TestCase):
    def test_digits_are_cut_to_match_the_error(self):
        text = run(f"classify {HEXAGON} 1 --seed 1").stdout
        self.assertRegex(text, r"; mean S (-?0\.\d\d \+- 0\.0[2-9]|-?0\.\d\d\d \+- 0\.0(1\d|20));")

    def test_a_torus_has_a_bound_and_no_error_of_chaos(self):
        found = document(f"classify {TORUS}")
        self.assertEqual((found["kind"], found["mean_S_kind"]), ("quasi-periodic", "bounded"))
        self.assertEqual((found["mean_S_error"], found["mean_S_per_impact_error"]), (None, None))
        text = run(f"classify {TORUS}").stdout
        self.assertRegex(text, r"; mean S -0\.5375\d+ \(off by (0\.000\d+|\de-05) at most\);")
        self.assertNotRegex(text.split("outcome")[0], r"\+-")
        # Twenty times as long: what it says holds, and its bound falls with the time.
        longer = document(f"classify {TORUS} --transient 20000 --collisions 200000")
        self.assertLessEqual(abs(longer["mean_S"] - found["mean_S"]), found["mean_S_bound"] + longer["mean_S_bound"])
        self.assertLess(longer["mean_S_bound"], found["mean_S_bound"] / 5)

    def test_no_impact_of_a_disk_makes_j_plus_i_s_over_alpha_larger(self):
        """I/alpha = kappa alpha: what friction turns into S the swirl's belt has given to J, and no more."""
        for e, mu, beta, code in ((1, 0.3, 0.8, 0), (0.95, 0.1, 2, 0), (0.8, 1, 0.3, 3)):  # the last one ends in contact
            rows = document(f"simulate --sides disk --alpha 0.3 --beta {beta} --mu {mu} --restitution {e} --seed 2 --collisions 300", code)
            kept = [row["jacobi"] + 0.5 * 0.3 * row["spin"] for row in rows["collisions"]]
            self.assertGreater(len(kept), 20)
            self.assertLess(max(b - a for a, b in zip(kept, kept[1:])), 1e-12, (e, mu, beta))
            self.assertLess(kept[-1], kept[0] - 1e-4)

    def test_a_frictionless_disks_mean_is_its_spin(self):
        disk = document("classify --sides disk --alpha 0.4 --beta 0.5 --mu 0 --restitution 1 --x 0.6 --vx 0.2 --vy 0.13 --spin 0.25")
        self.assertEqual((disk["kind"], disk["mean_S"], disk["mean_S_error"]), ("chaotic", 0.25, 0))

    def test_a_cycle_is_exact_and_a_short_run_has_no_error(self):
        cycle = document("classify --sides 12 --alpha 0.3 --beta 0.3 --mu 0.3 --restitution 0.95")
        self.assertEqual((cycle["mean_S_kind"], cycle["mean_S_error"], cycle["mean_S_per_impact_error"]), ("exact", 0, 0))
        short = document(f"classify {HEXAGON} 1 --transient 1000 --collisions 300")
        self.assertEqual((short["mode"], short["mean_S_kind"], short["mean_S_error"]), ("chaotic", "too-short", None))

    def test_of_several_runs_the_error_is_their_scatter_and_of_one_its_own(self):
        several = document(f"classify {HEXAGON} 0.9 --runs 8 --collisions 4000")
        one, = several["attractors"]
        means = [r["mean_S"] for r in several["runs"]]
        self.assertAlmostEqual(one["mean_S_error"], error_over_runs(means), delta=4e-4 * one["mean_S_error"])
        pair = document(f"classify {HEXAGON} 0.9 --runs 2 --collisions 4000")["attractors"][0]["mean_S_error"]
        self.assertAlmostEqual(pair, error_over_runs(means[:2]), delta=4e-4 * pair)  # 6.5 times s/√2
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


def henon(start, count):
    """x of the map at (1.4, 0.3) after 100 steps from a start near 0, and times between which 2 + x pass."""
    x, y, t, rows = start, 0.0, 0.0, []
    for step in range(count + 100):
        x, y = 1 - 1.4 * x * x + y, 0.3 * x
        if step >= 100:
            rows.append((t, x))
            t += 2 + x
    return rows


def means_of(rows):
    """Over time, each value holding until the next one, and over the values."""
    spans = [b[0] - a[0] for a, b in zip(rows, rows[1:])]
    return math.fsum(x * dt for (_, x), dt in zip(rows, spans)) / math.fsum(spans), statistics.fmean(x for _, x in rows)


@unittest.skipIf(ALL, "by day")
class Series(InFolder):
    COUNT = 16000

    def classified(self, rows, flags, names=("t", "S")):
        path = self.folder / "series.csv"
        path.write_text("\n".join([",".join(names), *(",".join(map(repr, row)) for row in rows)]) + "\n")
        return document(f"classify --series {path} --rows impacts {flags}")

    def test_its_errors_are_the_spread_of_means_over_starts(self):
        starts = [means_of(henon(0.001 * k, self.COUNT)) for k in range(1, 81)]
        rows = henon(0.1234, self.COUNT)
        found = self.classified(rows, "--column S --time t")
        self.assertEqual((found["kind"], found["mean_S_kind"], found["mean_S_bound"]), ("chaotic", "sampled", None))
        for k, key in enumerate(("mean_S", "mean_S_per_impact")):
            means = [start[k] for start in starts]
            self.assertAlmostEqual(found[key], means_of(rows)[k], delta=1e-12)
            # 16 blocks or more know an error to 20 %, 80 starts the spread to 8 %.
            self.assertAlmostEqual(math.log(found[f"{key}_error"] / statistics.stdev(means)), 0, delta=math.log(1.6), msg=key)
            self.assertLess(abs(found[key] - statistics.fmean(means)), 4 * found[f"{key}_error"])

    def test_without_times_it_has_the_error_per_impact_alone(self):
        rows = henon(0.1234, self.COUNT)
        found = self.classified([row[1:] for row in rows], "--column S", ("S",))
        self.assertEqual((found["kind"], found["mean_S"], found["mean_S_error"], found["mean_S_kind"]),
                         ("chaotic", None, None, "sampled"))
        self.assertEqual(found["mean_S_per_impact_error"], self.classified(rows, "--column S --time t")["mean_S_per_impact_error"])

    def test_a_cycles_has_none(self):
        cycle = [(float(k), 0.5 + 0.25 * (-1) ** k) for k in range(2000)]
        found = self.classified(cycle, "--column S --time t")
        self.assertEqual((found["kind"], found["mean_S_kind"], found["mean_S_error"]), ("cycle", "none", None))


if __name__ == "__main__":
    unittest.main()
