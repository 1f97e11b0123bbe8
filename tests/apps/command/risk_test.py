"""Chaos that is called before the limits, at a risk: sweep, bifurcate, classify --runs. risk_test.py SWIRL"""

import unittest

import h5py

from driving import InFolder, document, run

#: Hexagons: four sizes that are chaotic, and one with a steady mode; 5 x 3 cells.
SCENE = "--sides 6 --mu 0.5 --restitution 0.95"
LIMITS = "--transient 1000 --collisions 1000"
PLANE = f"{SCENE} --grid alpha=0.1,0.12,0.15,0.18,0.6 --grid beta=0.4:0.6:3 --runs 8 {LIMITS}"
SWEEP = f"sweep {PLANE} --risk 0.3"
DIAGRAM = f"bifurcate {SCENE} --beta 0.5 --along alpha=0.1:0.2:20 --starts 6 --transient 1000 --collisions 400"
RUNS = f"classify {SCENE} --alpha 0.15 --beta 0.5 --runs 120 {LIMITS}"
EARLY = 432  # impacts


def bound(changed, judged):
    """p at which `changed` or fewer of `judged` have a chance of 2.5 %, by bisection of the binomial sum."""
    def chance(p):
        term, total = (1 - p) ** judged, 0.0
        for k in range(changed + 1):
            total += term
            term *= (judged - k) / (k + 1) * p / (1 - p)
        return total
    low, high = 0.0, 1.0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if chance(middle) > 0.025 else (low, middle)
    return low


class Risk(InFolder):
    def check_evidence(self, evidence, runs, risk):
        self.assertEqual(list(evidence), ["runs", "impacts", "least_exponent", "least_runs", "drawn", "followed", "judged", "changed",
                                          "bound", "means_followed"])
        self.assertEqual((evidence["runs"], evidence["impacts"]), (runs, EARLY))
        self.assertLess(evidence["drawn"], runs / 3)
        self.assertGreaterEqual(runs, evidence["least_runs"])
        self.assertLessEqual(evidence["followed"], evidence["drawn"])
        self.assertLessEqual(evidence["judged"], evidence["followed"])
        self.assertAlmostEqual(evidence["bound"], bound(evidence["changed"], evidence["judged"]), places=9)
        self.assertLess(evidence["bound"], risk)
        self.assertGreater(evidence["least_exponent"], 0)

    def bytes_of(self, command, name):
        path = self.folder / name
        result = run(f"{command} --quiet -o {path}")
        self.assertEqual((result.returncode, result.stderr), (0, ""), command)
        return path.read_bytes()


class Sweep(Risk):
    def test_what_is_not_called_early_is_as_without_a_risk(self):
        at_risk, limits = document(SWEEP), document(f"sweep {PLANE}")
        self.assertEqual(at_risk["settings"]["risk"], 0.3)
        self.assertNotIn("risk", limits["settings"])
        self.assertNotIn("risk_evidence", limits)
        (evidence,) = at_risk["risk_evidence"]
        self.check_evidence(evidence, 120, 0.3)
        early = changed = 0
        for cell, of_limits in zip(at_risk["cells"], limits["cells"]):
            called = [run for run in cell["runs"] if run["mode"] == "chaotic" and run["impacts"] < EARLY + 3]
            if called:
                self.assertEqual({run["mode"] for run in cell["runs"]}, {"chaotic"})
                self.assertEqual(cell["steady_modes"], [])
            for found, expected in zip(cell["runs"], of_limits["runs"]):
                if found in called:
                    early += 1
                    changed += expected["mode"] != "chaotic"
                else:
                    self.assertEqual(found, expected)
        self.assertGreater(early, 20)
        self.assertLess(changed, 0.3 * early)

    def test_the_bytes_depend_on_neither_threads_nor_shards(self):
        whole = self.bytes_of(f"{SWEEP} --threads 1", "one.h5")
        self.assertEqual(self.bytes_of(f"{SWEEP} --threads 3", "three.h5"), whole)
        parts = [self.folder / f"{i}.h5" for i in (1, 2)]
        for i, part in enumerate(parts, 1):
            self.bytes_of(f"{SWEEP} --shard {i}/2", part.name)
        self.assertEqual(self.bytes_of(f"join {parts[1]} {parts[0]}", "joined.h5"), whole)
        with h5py.File(self.folder / "joined.h5") as record:
            group = record["risk_evidence"]
            self.assertIn("drawn without replacement", group.attrs["assumed"])
            self.assertEqual((group["runs"][0], group["impacts"][0]), (120, EARLY))

    def test_a_record_goes_on_at_its_own_risk_and_number_of_runs(self):
        path = self.folder / "a.h5"
        before = self.bytes_of(SWEEP, "a.h5")
        self.assertEqual(document(f"{SWEEP} -o {path} --quiet"), document(SWEEP))
        for other, mention in ((SWEEP.replace("risk 0.3", "risk 0.4"), "here is risk = 0.4"),
                               (f"sweep {PLANE}", "no risk"), (SWEEP.replace("--runs 8", "--runs 9"), "runs = 8")):
            result = run(f"{other} -o {path}")
            self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1), result.stderr)
            self.assertIn(mention, result.stderr)
        self.assertEqual(path.read_bytes(), before)

    def test_each_round_of_a_refined_one_has_a_sample(self):
        few = f"{SCENE} --grid alpha=0.1:0.6:3 --grid beta=0.4:0.6:2 --runs 16 {LIMITS}"
        found = document(f"sweep {few} --risk 0.2 --refine 1")
        self.assertEqual(sum(evidence["runs"] for evidence in found["risk_evidence"]), 16 * len(found["cells"]))
        self.assertEqual(found["risk_evidence"][0]["runs"], 16 * 6)

    def test_too_few_runs_go_to_the_limits_and_people_are_told(self):
        small = f"sweep {SCENE} --alpha 0.3 --grid beta=0.4,0.5 {LIMITS}"
        at_risk = document(f"{small} --risk 0.01")
        self.assertEqual(at_risk["cells"], document(small)["cells"])
        # ln 0.025/ln 0.99 = 367.04: twice 368 candidates, and a twentieth more, are a third
        self.assertEqual(at_risk["risk_evidence"], [{"runs": 2, "impacts": 0, "least_exponent": None, "least_runs": 2319, "drawn": 0,
                                                     "followed": 0, "judged": 0, "changed": 0, "bound": None, "means_followed": 0}])
        told = " ".join(run(f"{small} --risk 0.01 --error 0.1").stdout.split())
        self.assertIn("no chaos was called early: so small a risk wants 2319 runs or more, here are 2; --error 0.1 changes nothing", told)
        self.assertIn(f"chaos was called after {EARLY} impacts", " ".join(run(SWEEP).stdout.split()))


class Others(Risk):
    def test_diagrams(self):
        command = f"{DIAGRAM} --risk 0.3"
        found = document(command)
        self.assertEqual(found["settings"]["risk"], 0.3)
        self.check_evidence(found["risk_evidence"][0], 120, 0.3)
        self.assertEqual(self.bytes_of(f"{command} --threads 1", "1.h5"), self.bytes_of(f"{command} --threads 2", "2.h5"))
        limits = document(DIAGRAM)
        early = 0
        for column, of_limits in zip(found["columns"], limits["columns"]):
            for start, expected in zip(column["attractors"], of_limits["attractors"]):
                early += start != expected
                if start != expected:
                    self.assertEqual(start["mode"], "chaotic")
        self.assertGreater(early, 20)

    def test_several_runs_of_one_scene(self):
        command = f"{RUNS} --risk 0.3"
        found = document(command)
        self.assertEqual(found["settings"]["risk"], 0.3)
        self.check_evidence(found["risk_evidence"][0], 120, 0.3)
        self.assertEqual(self.bytes_of(f"{command} --threads 1", "1.h5"), self.bytes_of(f"{command} --threads 2", "2.h5"))
        self.assertIn("chaos was called after", " ".join(run(command).stdout.split()))

    @staticmethod
    def is_known(run, error):
        """Its mean S: null is an error of which too few impacts tell."""
        return run["mean_S_error"] is not None and run["mean_S_error"] <= error

    def test_means_of_called_runs_are_followed_to_an_error(self):
        error, look, limits = 0.2, 648, 8000
        runs, sweep = (line.replace(LIMITS, "--transient 4000 --collisions 4000") for line in (RUNS, SWEEP))
        plain, known = document(f"{runs} --risk 0.3"), document(f"{runs} --risk 0.3 --error {error}")
        self.assertEqual(known["settings"]["error"], error)
        self.assertNotIn("error", plain["settings"])
        (told,), (evidence,) = known["risk_evidence"], plain["risk_evidence"]
        self.assertEqual({**told, "means_followed": 0}, evidence)
        self.assertGreaterEqual(told["means_followed"], sum(a != b for a, b in zip(plain["runs"], known["runs"])))
        self.assertIn(f"means of {told['means_followed']} were followed on", " ".join(run(f"{runs} --risk 0.3 --error {error}").stdout.split()))
        ends = set()
        for before, after in zip(plain["runs"], known["runs"]):
            if before == after:
                continue
            self.assertEqual(before["mode"], "chaotic")
            self.assertFalse(self.is_known(before, error))
            ends.add(self.is_known(after, error))
        self.assertIn(True, ends)  # others end at the limits with what they have there
        command = f"{sweep} --error {error}"
        cells, limit_cells = document(command)["cells"], document(sweep)["cells"]
        longer = 0
        for cell, of_called in zip(cells, limit_cells):
            for after, before in zip(cell["runs"], of_called["runs"]):
                if after == before:
                    continue
                longer += 1
                self.assertFalse(self.is_known(before, error))
                self.assertLess(before["impacts"], look + 3)
                self.assertGreater(after["impacts"], before["impacts"])
                if after["mode"] == "chaotic" and after["impacts"] < limits:
                    self.assertTrue(self.is_known(after, error))
        self.assertGreater(longer, 20)
        self.assertEqual(self.bytes_of(f"{command} --threads 1", "1.h5"), self.bytes_of(f"{command} --threads 3", "3.h5"))
        parts = [self.folder / f"part{i}.h5" for i in (1, 2)]
        for i, part in enumerate(parts, 1):
            self.bytes_of(f"{command} --shard {i}/2", part.name)
        self.assertEqual(self.bytes_of(f"join {parts[0]} {parts[1]}", "joined.h5"), (self.folder / "1.h5").read_bytes())
        found = document(f"{DIAGRAM} --risk 0.3 --error {error}")
        self.assertEqual(found["settings"]["error"], error)
        self.assertNotEqual(found["columns"], document(f"{DIAGRAM} --risk 0.3")["columns"])

    def test_of_one_run_nothing_is_saved_below_nine_tenths(self):
        one = f"classify {SCENE} --alpha 0.15 --beta 0.5"
        limits, at_risk, dared = document(one), document(f"{one} --risk 0.5"), document(f"{one} --risk 0.92")
        self.assertEqual(at_risk["settings"].pop("risk"), 0.5)
        self.assertEqual(at_risk, limits)
        self.assertEqual(dared["mode"], "chaotic")
        self.assertLess(dared["impacts"], 11_080)
        self.assertIn("of one run alone nothing tells a risk of 0.5", " ".join(run(f"{one} --risk 0.5").stdout.split()))
        self.assertNotIn("of one run alone", run(f"{one} --risk 0.92").stdout)

    def test_where_few_runs_are_chaotic_it_is_said_that_these_are_too_few(self):
        # A fifth of the columns is chaotic.
        command = (f"sweep {SCENE} --grid alpha=0.15,0.6,0.65,0.7,0.75 --beta 0.5 --runs 60 {LIMITS}")
        (evidence,) = document(f"{command} --risk 0.2")["risk_evidence"]
        self.assertEqual((evidence["runs"], evidence["impacts"], evidence["judged"]), (300, 0, 0))
        self.assertLess(evidence["followed"], 0.4 * evidence["drawn"])
        self.assertIn("candidates, too few to tell so small a risk", " ".join(run(f"{command} --risk 0.2").stdout.split()))


class WrongInput(InFolder):
    def test_is_refused(self):
        record = self.folder / "orbit.h5"
        self.assertEqual(run(f"simulate {SCENE} --alpha 0.3 --beta 0.5 --collisions 200 -o {record} --quiet").returncode, 0)
        for command in (f"sweep {PLANE}", DIAGRAM, RUNS, f"classify {SCENE} --alpha 0.3 --beta 0.5"):
            for value in ("2", "1", "-1", "nan", "inf", "much", "1e-999"):
                self.refused(f"{command} --risk {value} -o {self.folder}/a.h5", "risk", "0 or more, below 1")
            self.refused(f"{command} --risk 0.1 --exhaustive -o {self.folder}/a.h5", "risk", "exhaustive")
            for value in ("0", "-1", "nan"):
                self.refused(f"{command} --risk 0.1 --error {value} -o {self.folder}/a.h5", "error", "above 0")
            self.refused(f"{command} --error 0.01 -o {self.folder}/a.h5", "error", "--risk")
        self.refused(f"classify {record} --risk 0.1", "risk")

    def refused(self, command, *mentions):
        result = run(command)
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), (command, result.stderr))
        for mention in mentions:
            self.assertIn(mention, result.stderr, command)
        self.assertFalse((self.folder / "a.h5").exists())


if __name__ == "__main__":
    unittest.main()
