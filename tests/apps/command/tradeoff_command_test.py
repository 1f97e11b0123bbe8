"""swirl tradeoff, from outside: tradeoff_command_test.py SWIRL"""

import re
import time
import unittest
from functools import lru_cache

import xarray

from driving import InFolder, document, run

CHAOS = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DISK = "--sides disk --alpha 0.3 --beta 0.1 --mu 0 --restitution 1"
ROLLS = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"
LANDS = "--sides 3 --alpha 0.4 --beta 0.8 --mu 0.5 --restitution 0.5"
TRANSIENT = "--sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95"  # chaos that ends within some 1,000 impacts
CHATTERS = "--sides 3 --alpha 0.57 --beta 1 --mu 1.9 --restitution 1 --seed 5"
DIVERGES = "--sides 3 --alpha 0.6 --beta 0.5 --mu 5 --restitution 1 --law newton"

RUNG = """name seconds_per_collision seconds_per_collision_lower seconds_per_collision_upper error error_99
error_largest error_of_ten flights missed_contacts missed_rate missed_rate_least missed_rate_most misordered_contacts
misordered_rate misordered_rate_least misordered_rate_most mode kind period outcome verdict_differs
mean_S mean_S_error mean_S_off largest_exponent exponent_off jacobi_drift""".split()
EVIDENCE = """collisions mode mean_S mean_S_error largest_exponent mean_S_off exponent_off runs changed changed_rate_least
changed_rate_most seconds""".split()
MODEL = "name seconds_per_collision seconds_without seconds_added paid_by".split()


@lru_cache(maxsize=None)
def measured(scene, budget=None):
    """The document. A machine that is busy, or a sanitizer's, is given more time: not so as to count for ever less."""
    budget = budget or (1 if scene == CHAOS else 0.5)
    for more in (1, 4, 16):
        found = document(f"tradeoff {scene} --budget {budget * more}")
        if not found["cut_short"]:
            return found
    raise AssertionError(f"{scene} was cut short with a budget of {16 * budget} s")


def rungs(found):
    return {row["name"]: row for row in found["rungs"]}


def model(found):
    return {row["name"]: row for row in found["model"]}


def without_times(found):
    """The document without what is measured in seconds, and what follows from it."""
    if isinstance(found, dict):
        return {k: without_times(v) for k, v in found.items()
                if not k.startswith("seconds") and k not in ("advice", "knee")}
    return [without_times(v) for v in found] if isinstance(found, list) else found


class Ladders(unittest.TestCase):
    def test_the_documents_keys(self):
        found = measured(CHAOS)
        for key, names in (("rungs", RUNG), ("evidence", EVIDENCE), ("model", MODEL)):
            self.assertTrue(found[key])
            for row in found[key]:
                self.assertLessEqual(set(names), set(row), key)
        self.assertEqual([row["name"] for row in found["rungs"] if row["name"] in ("double", "quad")],
                         ["double", "quad"])
        self.assertIn(found["recommended"], rungs(found))
        self.assertIn(found["knee"], rungs(found))
        self.assertIn("For a cycle use", found["advice"])
        self.assertLess(found["flights"]["compared"], found["flights"]["drawn"] + 1)

    def test_double_is_right_to_fifty_roundings_of_the_condition_and_more_digits_are_better(self):
        for scene in (CHAOS, STEADY, DISK):
            rows = rungs(measured(scene))
            double = rows["double"]
            self.assertGreater(double["flights"], 50, scene)
            self.assertLessEqual(double["error_in_condition"], 50, scene)
            self.assertGreater(double["error_largest"], 0, scene)
            self.assertLessEqual(double["error"], double["error_99"], scene)
            self.assertLessEqual(double["error_99"], double["error_largest"], scene)
            self.assertLess(double["seconds_per_collision"], rows["quad"]["seconds_per_collision"], scene)
            if "extended" in rows:
                self.assertLess(rows["extended"]["error"], double["error"] / 100, scene)

    def test_the_last_rung_is_compared_with_and_has_no_error(self):
        last = measured(CHAOS)["rungs"][-1]
        for key in ("error", "error_99", "error_largest", "error_of_ten", "flights", "missed_contacts",
                    "missed_rate_most", "misordered_contacts", "misordered_rate_most", "verdict_differs", "mean_S_off"):
            self.assertIsNone(last[key], key)
        self.assertEqual(last["mode"], "chaotic")

    def test_an_orbit_too_short_for_a_verdict_is_no_objection(self):
        """Of a frictionless disk some 1,000 impacts often name no mode: that says nothing of the arithmetic."""
        found = measured("--sides disk --alpha 0.4 --beta 0.5 --mu 0 --restitution 1")
        last = found["rungs"][-1]
        short = 0
        for row in found["rungs"][:-1]:
            undecided = "undecided" in (row["mode"], last["mode"]) and row["outcome"] == "completed"
            self.assertEqual(row["verdict_differs"] is None, undecided, row)
            short += undecided
        self.assertGreater(short, 0)
        self.assertEqual(found["recommended"], "double")

    def test_none_of_n_says_how_large_the_rate_may_be(self):
        for scene in (CHAOS, STEADY, DISK):
            for row in measured(scene)["rungs"][:-1]:
                for what in ("missed", "misordered"):
                    n, k = row["flights"], row[f"{what}_contacts"]
                    self.assertAlmostEqual(row[f"{what}_rate"], k / n, delta=1e-15)
                    self.assertGreater(row[f"{what}_rate_most"], 0)
                    if k == 0:
                        self.assertAlmostEqual(row[f"{what}_rate_most"], 1 - 0.05 ** (1 / n), delta=1e-12)
                    else:
                        self.assertGreater(row[f"{what}_rate_least"], 0)
        for row in run(f"tradeoff {CHAOS} --budget 0.1").stdout.splitlines():
            self.assertEqual(len(re.findall(r"\b0 of ", row)), row.count("(below"), row)

    def test_searches_to_compare_with_miss_contacts_or_take_them_out_of_order(self):
        """Of a chaotic hexagon: four guesses a vertex pass contacts over, steps of 0.01 see two vertices at once."""
        rows = rungs(measured(CHAOS))
        self.assertGreater(rows["paper"]["missed_contacts"], rows["paper"]["misordered_contacts"])
        self.assertGreater(rows["fixed-step"]["misordered_contacts"], rows["fixed-step"]["missed_contacts"])
        self.assertEqual((rows["double"]["missed_contacts"], rows["double"]["misordered_contacts"]), (0, 0))

    def test_the_knee_is_the_cheapest_rung_that_is_right_to_fifty_roundings(self):
        for scene in (CHAOS, STEADY, DISK):
            found = measured(scene)
            self.assertEqual(found["settings"]["roundings_at_knee"], 50)
            kept = [row for row in found["rungs"][:-1]
                    if row["missed_contacts"] + row["misordered_contacts"] == 0
                    and row["error_in_condition"] * (2**-11 if row["name"] == "extended" else 1) <= 50]
            self.assertEqual(found["knee"], min(kept, key=lambda row: row["seconds_per_collision"])["name"], scene)

    def test_what_is_recommended_fits_into_lines(self):
        for scene in (CHAOS, LANDS):
            shown = run(f"tradeoff {scene} --budget 0.5").stdout
            advice = shown[shown.index("recommended: "):].splitlines()
            self.assertGreater(len(advice), 2, scene)
            self.assertEqual([line for line in advice if len(line) > 100], [], scene)

    def test_contact_at_e_one_is_paid_for_where_friction_lets_a_vertex_come_to_rest(self):
        """Of this triangle one of some 3,000 impacts chatters to its end."""
        pieces = model(measured(CHATTERS, 1))
        self.assertEqual((pieces["watch for contact"]["paid_by"], pieces["motion in contact"]["paid_by"]),
                         ("every command", "every command"))
        self.assertGreater(measured(CHATTERS, 1)["flights"]["through_contact"], 0)
        for scene in (DISK, CHAOS.replace("--mu 0.5", "--mu 0")):
            self.assertEqual(model(measured(scene))["watch for contact"]["paid_by"],
                             "nothing: e = 1, and no friction holds a vertex", scene)

    def test_more_digits_are_not_offered_to_cycles(self):
        cycle = measured(CHAOS)["advice"].split("For a cycle use ")[1]
        self.assertIn("orbits and continue round every step to double", cycle)
        self.assertNotIn("where more digits are wanted", cycle)

    def test_how_fast_chaos_ends_where_it_does_and_how_slowly_at_least_where_it_does_not(self):
        ends = measured(TRANSIENT, 1)["escape"]
        self.assertGreater(ends["left"], 0)
        self.assertAlmostEqual(ends["rate"], ends["left"] / ends["impacts"], delta=1e-15)
        self.assertLess(0, ends["least_rate"])
        self.assertLess(ends["least_rate"], ends["rate"])
        self.assertLess(ends["rate"], ends["most_rate"])
        self.assertTrue(200 < ends["half_life"] < 2000, ends)  # 567 from 59 of 64 starts, 446 to 745 at 95 %
        lasts = measured(CHAOS)["escape"]
        self.assertEqual((lasts["left"], lasts["rate"], lasts["half_life"]), (0, 0, None))
        self.assertAlmostEqual(lasts["most_rate"], 3 / lasts["impacts"], delta=1e-15)
        self.assertIsNone(measured(ROLLS)["escape"])  # come to without chaos before

    def test_evidence_rises_and_the_last_one_is_its_own_measure(self):
        rows = measured(CHAOS)["evidence"]
        self.assertEqual([row["collisions"] for row in rows][:3], [100, 300, 1000])
        self.assertEqual((rows[-1]["changed"], rows[-1]["mean_S_off"], rows[-1]["exponent_off"]), (0, 0, 0))
        for row in (rows[1], rows[-1]):  # few impacts are too short to tell an error
            same = document(f"classify {CHAOS} --transient {row['collisions']} --collisions {row['collisions']}")
            for key in ("mode", "kind", "mean_S", "mean_S_error", "largest_exponent"):
                self.assertEqual(row[key], same[key], key)
        self.assertEqual(rows[-1]["mean_S_differs"], 0)
        self.assertGreater(rows[0]["mean_S_differs"], 0.05)
        self.assertEqual(measured(STEADY)["evidence"][-1]["mean_S_error"], 0)

    def test_what_a_scene_does_not_need_nothing_pays_for(self):
        disk, hexagon = model(measured(DISK)), model(measured(CHAOS))
        for name in ("friction", "orientation of vertices", "watch for contact"):
            self.assertTrue(disk[name]["paid_by"].startswith("nothing: "), name)
        for name in ("friction", "orientation of vertices"):
            self.assertEqual(hexagon[name]["paid_by"], "every command")
        self.assertGreater(disk["orientation of vertices"]["seconds_added"], 0)
        self.assertGreater(hexagon["derivative"]["seconds_added"], 0)
        self.assertEqual(model(measured(LANDS))["motion in contact"]["paid_by"], "every command")

    def test_equal_seeds_give_equal_documents_but_for_times(self):
        first = measured(STEADY)
        budget = first["settings"]["budget"]
        again = document(f"tradeoff {STEADY} --budget {budget} --threads 1")
        starts = [[found[key][0]["runs"] for key in ("evidence", "risk") if found[key]] for found in (first, again)]
        if again["cut_short"] or starts[0] != starts[1]:
            self.skipTest("the machine is too busy for equal amounts")
        self.assertEqual(without_times(again), without_times(first))
        other = document(f"tradeoff {STEADY} --budget {budget} --seed 2")
        self.assertNotEqual(without_times(other), without_times(again))

    def test_it_takes_its_budget(self):
        begin = time.monotonic()
        run(f"tradeoff {CHAOS} --budget 1")
        took = time.monotonic() - begin
        self.assertGreater(took, 1)
        self.assertLess(took, 1.3 + 1)  # a third beyond it, and a second to start and for what is under way on a busy machine


class Enough(unittest.TestCase):
    def test_fewer_impacts_are_recommended_where_neither_verdicts_nor_mean_s_change(self):
        """From eight starts of verdicts that is never known, from 32 of which none changes it is."""
        few = document(f"tradeoff {CHAOS} --budget 0.3")
        self.assertIsNone(few["enough_collisions"])
        self.assertRegex(few["advice"], rf"with (at least )?{few['evidence'][-1]['collisions']} \+ ")
        many = measured(CHAOS, 10)
        rows = many["evidence"]
        self.assertEqual(many["settings"]["starts"], 64)
        if rows[0]["runs"] < 32:
            self.skipTest("the machine is too busy for as many starts")
        modes = [row["changed_rate_most"] < many["settings"]["may_change"] for row in rows]
        means = [row["mean_S_differs"] < many["settings"]["mean_may_differ"] for row in rows]
        self.assertTrue(all(modes))  # the mode is known from 100 impacts on, where mean S is not
        self.assertFalse(means[0])
        first = next((k for k in range(len(rows) - 1) if all(modes[k:]) and all(means[k:])), None)
        self.assertEqual(many["enough_collisions"], None if first is None else rows[first]["collisions"])


class Regimes(unittest.TestCase):
    def check(self, scene, mode, outcome):
        found = measured(scene, 0.3)
        self.assertEqual((found["evidence"][-1]["mode"], found["evidence"][-1]["outcome"]), (mode, outcome), scene)
        return found

    def test_a_cycle_is_compared_on_the_way_to_it(self):
        found = self.check(STEADY, "steady", "completed")
        self.assertFalse(found["flights"]["after_transient"])
        self.assertEqual((found["recommended"], found["rungs"][0]["period"]), ("double", 1))

    def test_an_orbit_that_comes_to_roll_is_compared_up_to_there(self):
        found = self.check(ROLLS, "quasi-steady", "in-contact")
        self.assertEqual(found["flights"]["outcome"], "in-contact")
        self.assertEqual(found["recommended"], "double")
        # In more digits chatter takes more impacts: with the whole budget all three proven searches come to the end.
        proven = [row["outcome"] for name, row in rungs(measured(ROLLS, 4)).items() if name in ("double", "extended", "quad")]
        self.assertEqual(set(proven), {"in-contact"})  # searches to compare with may lose the body near the wall

    def test_an_orbit_that_leads_through_contact(self):
        """Too small a budget for quad to come to the end of chatter does not speak against double."""
        for budget in (0.5, 2, 8):
            found = measured(LANDS, budget)
            self.assertGreater(found["flights"]["through_contact"], 0)
            self.assertGreater(found["flights"]["compared"], 50)
            self.assertEqual(found["recommended"], "double", budget)
        self.assertFalse(rungs(found)["double"]["verdict_differs"])
        self.assertEqual(rungs(found)["quad"]["outcome"], "in-contact")
        self.assertLessEqual(rungs(found)["double"]["error_in_condition"], 50)

    def test_no_contact_and_rest_have_nothing_to_compare(self):
        small = STEADY.replace("--beta 0.5", "--beta 0.1")
        for scene, outcome in ((f"{small} --x 0.1", "no-contact"), (f"{DISK} --point=0,0,0,0", "resting")):
            found = self.check(scene, "undecided", outcome)
            self.assertIsNone(found["recommended"])
            self.assertIsNone(found["advice"])
            self.assertIsNone(found["knee"])
            self.assertIn(outcome, found["reason"])
            self.assertEqual(found["model"], [])
            for row in found["rungs"]:
                for key in ("seconds_per_collision", "error", "missed_contacts", "missed_rate_most",
                            "misordered_contacts", "misordered_rate_most"):
                    self.assertIsNone(row[key], key)

    def test_an_orbit_that_diverges_is_compared_up_to_there(self):
        found = self.check(DIVERGES, "undecided", "completed")  # it does after thousands of impacts
        self.assertEqual(found["flights"]["outcome"], "diverged")
        self.assertGreater(found["flights"]["compared"], 50)
        self.assertEqual(found["recommended"], "double")


class AtRisk(InFolder):
    SCENE = "--sides 6 --alpha 0.15 --beta 0.5 --mu 0.5 --restitution 0.95"  # chaos that stays

    def test_the_rows_are_what_classify_does_at_that_risk(self):
        found = measured(self.SCENE, 3)
        rows = {row["risk"]: row for row in found["risk"]}
        self.assertEqual(list(rows), [0, 0.005, 0.01, 0.02, 0.05, 0.1, 0.2])
        runs = rows[0]["runs"]
        self.assertLessEqual(runs, found["settings"]["risk_runs"])
        if runs < 110:
            self.skipTest("the machine is too busy for a sample")
        self.assertEqual((rows[0]["runs_called"], rows[0]["changed"], rows[0]["bound"]), (0, 0, None))
        record = self.folder / "runs.h5"
        called = document(f"classify {self.SCENE} --runs {runs} --risk 0.2 -o {record}")
        limits = document(f"classify {self.SCENE} --runs {runs}")
        with xarray.open_dataset(record, group="runs", engine="h5netcdf") as opened:
            early = (opened["impacts"].values < 3000)
        chaotic = [run["mode"] == "chaotic" for run in called["runs"]]
        of_called = [run["mode"] != "chaotic" for run, is_early, is_chaotic in zip(limits["runs"], early, chaotic)
                     if is_early and is_chaotic]
        row = rows[0.2]
        self.assertGreater(row["runs_called"], 0.5 * runs)
        self.assertEqual((row["runs_called"], row["changed"]), (len(of_called), sum(of_called)))
        self.assertEqual(row["bound"], called["risk_evidence"][0]["bound"])
        self.assertEqual(row["share_that_differs"], row["changed"] / runs)
        self.assertLess(row["impacts"], rows[0]["impacts"])
        self.assertAlmostEqual(row["seconds"] / rows[0]["seconds"], row["impacts"] / rows[0]["impacts"], places=9)
        self.assertIn(f"--risk {found['recommended_risk']:g} takes", found["advice"])

    def test_people_see_them_in_a_table(self):
        shown = run(f"tradeoff {self.SCENE} --budget 1")
        self.assertEqual((shown.returncode, shown.stderr), (0, ""))
        self.assertRegex(shown.stdout, r"risk +runs +impacts +time +called early +of these otherwise +of all +below\n +0 +\d+ ")

    def test_a_start_that_is_given_has_none(self):
        found = document(f"tradeoff {self.SCENE} --point 0,0,-0.5,0.5,0.1 --budget 0.3")
        self.assertEqual((found["risk"], found["recommended_risk"]), ([], None))


class Outputs(InFolder):
    def test_the_record_has_the_three_ladders_and_a_figure(self):
        record = self.folder / "t.h5"
        found = document(f"tradeoff {CHAOS} --budget 0.3 -o {record}")
        for group in ("rungs", "evidence", "model"):
            with xarray.open_dataset(record, group=group, engine="h5netcdf") as opened:
                self.assertEqual(opened.sizes, {"rung": len(found[group])})
        with xarray.open_dataset(record, group="rungs", engine="h5netcdf") as opened:
            self.assertEqual(opened["seconds_per_collision"].attrs["units"], "s")
            self.assertEqual(list(opened["error"].values[:-1]), [row["error"] for row in found["rungs"][:-1]])
            self.assertEqual(list(opened["misordered_contacts"].values[:-1]),
                             [row["misordered_contacts"] for row in found["rungs"][:-1]])
        with xarray.open_dataset(record, group="result", engine="h5netcdf") as opened:
            self.assertEqual(opened.attrs["knee"], found["knee"])
        figure = run(f"plot {record} -o {self.folder}/t.png --json")
        self.assertEqual((figure.returncode, figure.stderr), (0, ""))
        self.assertIn('"tradeoff"', figure.stdout)
        self.assertGreater((self.folder / "t.png").stat().st_size, 20_000)

    def test_bad_input(self):
        for flags in ("--budget 0", "--budget nan", "--budget -1", "--budget 1e9", "--budget ten", "--accuracy quad",
                      "--accuracy half", "--x 3", "--collisions 5", "--seed -1", "--point 0,0,1,0,0"):
            result = run(f"tradeoff {STEADY} {flags} -o {self.folder}/none.h5")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                             (flags, result.stderr))
            self.assertIn(flags.split()[0].strip("-").split("=")[0].replace("x", "start", flags.startswith("--x")),
                          result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


if __name__ == "__main__":
    unittest.main()
