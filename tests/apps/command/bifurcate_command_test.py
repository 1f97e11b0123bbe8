"""swirl bifurcate, from outside: bifurcate_command_test.py SWIRL"""

import json
import unittest

import xarray

from driving import Keeping, Refusing, document, run, sized

WINDOW = "--sides 6 --beta 0.5 --mu 0.5 --restitution 0.95"


class Bifurcate(Refusing):
    def test_columns_and_branches(self):
        path = self.folder / "d.h5"
        answer = document(f"bifurcate {WINDOW} --along alpha=0.365:0.41:10 --starts 2 --branches --follow -o {path}")
        self.assertEqual([c["parameter"] for c in answer["columns"]][::9], [0.365, 0.41])
        for column in answer["columns"][1:]:
            self.assertEqual((column["mode"], column["period"]), ("steady", 1))
            self.assertEqual([a["origin"] for a in column["attractors"]], ["random", "random", "up", "down"])
            self.assertEqual(len(column["S"]), 4)
            self.assertLess(max(column["S"]) - min(column["S"]), 1e-8)
        self.assertGreaterEqual(answer["agreement"]["compared"], 15)
        self.assertLess(answer["agreement"]["largest_difference_of_S"], 1e-8)
        self.assertEqual(answer["agreement"]["without_branch"], 0)
        self.assertIn("flip", [s["kind"] for b in answer["branches"] for s in b["special"]])
        for group, name in (("samples", "S"), ("columns", "period"), ("branches", "parameter"), ("special", "kind")):
            self.assertIn(name, xarray.open_dataset(path, group=group, engine="h5netcdf"))
        self.assertEqual(run(f"plot {path} -o {self.folder}/d.png --quiet").returncode, 0)

    def test_a_cycle_that_is_approached_slowly_is_the_polished_one(self):
        # A multiplier of 0.99997: after 20,000 impacts the orbits are still some 0.002 from the fixed point.
        scene = "--sides 6 --alpha 0.635 --mu 0.5 --restitution 0.95"
        column = document(f"bifurcate {scene} --along beta=0.569:0.57:2 --starts 3 --seed 5")["columns"][1]
        self.assertEqual((column["mode"], column["period"]), ("steady", 1))
        self.assertLess(max(column["S"]) - min(column["S"]), 1e-9)
        share, = column["shares"]
        self.assertEqual((share["share"], share["kind"], share["period"]), (1, "fixed-point", 1))

    def test_shares_are_those_of_classify(self):
        scene = "--sides 6 --beta 0.893 --mu 0.3 --restitution 0.9"
        column = document(f"bifurcate {scene} --along alpha=0.398:0.42:2 --starts 8")["columns"][0]
        self.assertAlmostEqual(sum(s["share"] for s in column["shares"]), 1, delta=1e-12)
        self.assertEqual([s["share"] for s in column["shares"]], sorted((s["share"] for s in column["shares"]), reverse=True))
        self.assertGreater(len(column["shares"]), 1)
        for share in column["shares"]:
            same = [a for a in column["attractors"] if (a["kind"], a["period"]) == (share["kind"], share["period"])]
            self.assertGreaterEqual(len(same) / 8, share["share"])
        lines = run(f"bifurcate {scene} --along alpha=0.398:0.42:2 --starts 8 --quiet").stdout
        self.assertEqual(lines, "")
        table = run(f"bifurcate {scene} --along alpha=0.398:0.42:2 --starts 8").stdout
        self.assertEqual(table.count(" 0.398 "), len(column["shares"]))

    def test_branches_switch_at_flips(self):
        answer = document(f"bifurcate {WINDOW} --along alpha=0.365:0.41:4 --starts 1 --branches")
        switched = [b for b in answer["branches"] if b["begins"] == "switched"]
        self.assertTrue(switched)
        for branch in switched:
            parent = answer["branches"][branch["switched_from"]]
            special = parent["special"][branch["switched_at"]]
            self.assertEqual((special["kind"], branch["period"]), ("flip", 2 * parent["period"]))
        for branch in answer["branches"]:
            for special in branch["special"]:
                self.assertLess(special["after"], len(branch["points"]))  # a border may end it behind its last point

    def test_of_many_columns_every_so_many_is_listed(self):
        said = run("bifurcate --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.48:0.52:201 --starts 1 --transient 64 "
                   "--collisions 64 --exhaustive").stdout.splitlines()
        rows = [float(line.split()[0]) for line in said[1:] if "%" in line and "columns" not in line]
        self.assertEqual(len(set(rows)), 67)
        self.assertAlmostEqual(rows[1] - rows[0], 3 * 0.04 / 200, delta=1e-9)
        self.assertIn("one in 3 of 201 columns is listed (--json, -o)", said)

    def test_chaos_is_named(self):
        answer = document(f"bifurcate {WINDOW} --along alpha=0.3:0.35:3 --starts 2")
        self.assertEqual({c["mode"] for c in answer["columns"]}, {"chaotic"})
        self.assertEqual({c["period"] for c in answer["columns"]}, {None})

    def test_a_mean_of_chaos_without_an_error_has_one_digit(self):
        flags = "--sides 6 --alpha 0.3 --beta 0.5 --restitution 0.9 --along mu=0.2,0.25 --starts 1"
        attractors = [column["attractors"][0] for column in document(f"bifurcate {flags}")["columns"]]
        rows = run(f"bifurcate {flags}").stdout.splitlines()[1:3]
        self.assertIn("too-short", {a["mean_S_kind"] for a in attractors})  # 500 impacts
        for attractor, row in zip(attractors, rows):
            self.assertEqual(attractor["kind"], "chaotic")
            if attractor["mean_S_kind"] == "too-short":
                self.assertTrue(row.endswith(f" about {attractor['mean_S']:.1g}"), row)
            else:
                self.assertRegex(row, r" \+- [\d.]+$")

    def test_a_disk_that_rolls_is_named_as_classify_names_it(self):
        scene = "--sides disk --beta 0.23 --mu 0.4 --restitution 0.3"
        column = document(f"bifurcate {scene} --along alpha=0.35:0.36:2 --starts 1")["columns"][0]
        verdict = document(f"classify {scene} --alpha 0.35")
        self.assertEqual(column["attractors"][0]["kind"], verdict["kind"])
        self.assertEqual(column["mode"], verdict["mode"])

    def test_members_of_a_family_are_on_no_branch(self):
        answer = document("bifurcate --sides disk --beta 0.1 --mu 0.5 --restitution 1 --along alpha=0.25:0.35:3 --starts 2 --branches")
        self.assertEqual((answer["branches"], answer["agreement"]["without_branch"]), ([], 0))
        self.assertGreater(answer["agreement"]["in_families"], 0)

    def test_physical_units(self):
        plain = document(f"bifurcate {WINDOW} --along alpha=0.38:0.4:3 --starts 1")
        units = document("bifurcate --sides 6 --mu 0.5 --restitution 0.95 --container-radius 2 --polygon-radius 0.8 "
                         "--swirl-radius 1 --along alpha=0.38:0.4:3 --starts 1")
        self.assertEqual(plain["columns"], units["columns"])
        self.assertEqual(units["units"]["length"], 2)

    def test_an_orbit_that_dies_away_is_not_chaotic(self):
        columns = document("bifurcate --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0:0.1:2 --starts 2")["columns"]
        for attractor in columns[0]["attractors"]:
            self.assertEqual((attractor["outcome"], attractor["mode"]), ("resting", "undecided"))

    def test_a_diagram_in_contact_only_is_drawn_from_its_record(self):
        path = self.folder / "c.h5"
        self.assertEqual(run("bifurcate --sides disk --beta 0.23 --mu 0.4 --restitution 0.3 --along alpha=0.35:0.36:2 "
                             f"--starts 2 --quiet -o {path}").returncode, 0)
        attractors = xarray.open_dataset(path, group="attractors", engine="h5netcdf")
        self.assertEqual(set(attractors["outcome"].values), {"in-contact"})
        self.assertTrue(set(attractors["kind"].values) <= {"rolling", "rolling-librating", "rolling-circulating", "sliding"})
        self.assertEqual(run(f"plot {path} -o {self.folder}/c.png --quiet").returncode, 0)

    def test_the_observable_is_what_is_drawn(self):
        path, figures = self.folder / "v.h5", []
        for observable in ("S", "vn"):
            self.assertEqual(run(f"bifurcate {WINDOW} --along alpha=0.37:0.4:4 --starts 1 --branches --longest-branch 1 "
                                 f"--observable {observable} --quiet -o {path}").returncode, 0)
            self.assertEqual(run(f"plot {path} -o {self.folder}/v.svg --quiet").returncode, 0)
            figures.append((self.folder / "v.svg").read_text())
        self.assertNotEqual(*figures)
        branches = xarray.open_dataset(path, group="branches", engine="h5netcdf")
        self.assertLess(float(branches["value"].max()), 0)  # v_n of a state that leaves the wall with chi = psi = 0

    def test_threads_do_not_matter(self):
        outputs = [run(f"bifurcate {WINDOW} --along alpha=0.1:0.9:{sized(33, 9)} --starts 2 --follow --branches --json --threads {t}").stdout
                   for t in (1, 2)]
        self.assertEqual(*outputs)
        # The branches of each period are a piece of work, and so are those that are switched to.
        branches = json.loads(outputs[0])["branches"]
        for switched in (False, True):
            periods = {branch["period"] for branch in branches if ("switched_from" in branch) == switched}
            self.assertGreater(len(periods), 1)

    def test_falling_ranges_run_backwards(self):
        columns = document(f"bifurcate {WINDOW} --along alpha=0.41:0.37:3 --starts 1")["columns"]
        self.assertEqual(columns[0]["parameter"], 0.41)

    def test_wrong_input(self):
        for extra, mention in [("--along alpha=0.3:0.4", "COUNT"), ("--along alpha=0.3:0.4:1", "COUNT"),
                               ("--along alpha=0.3:1.4:5", "alpha = 1.4 is outside"), ("--along S=0:1:5", "NAME"), ("", "along"),
                               ("--along alpha=0.3:0.4:5 --observable x", "observable"),
                               ("--along alpha=0.3:0.4:5 --x 0.1", "random"), ("--along alpha=0.3:0.4:5 --starts 0", "follow")]:
            self.refused(f"bifurcate {WINDOW} {extra}", mention)


class KeptColumns(Keeping):
    def test_a_diagram_keeps_the_orbits_that_are_done(self):
        answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.1:0.9:2000 --starts 20 --threads 1", 1)
        self.assertEqual(answer["outcome"], "interrupted")
        self.assertGreater(len(answer["columns"]), 0)
        self.assertLess(len(answer["columns"]), 2000)
        for column in answer["columns"]:
            self.assertEqual(len(column["attractors"]) < 20, column.get("interrupted", False))
            for attractor in column["attractors"]:  # whole: a period, or every impact that was asked for
                self.assertIn(len(attractor["S"]), (attractor["period"], 500 if attractor["outcome"] == "completed" else 0))
        self.assertEqual(self.samples("samples").sizes["sample"], sum(len(c["S"]) for c in answer["columns"]))

    def test_an_orbit_that_was_cut_short_is_no_sample(self):
        for extra in ("--starts 1 --transient 1000000000", "--starts 1 --transient 100 --collisions 1000000000",
                      "--starts 0 --follow --transient 1000000000"):
            with self.subTest(extra):
                answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.3:0.34:3 {extra} --threads 1", 0.5)
                self.assertEqual(answer["columns"], [])

    def test_followed_columns_are_kept(self):
        answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.1:0.9:5000 --starts 0 --follow --threads 1", 1)
        self.assertGreater(len(answer["columns"]), 0)

    def test_branches_are_kept(self):
        """While some periods' are still continued; the record has those that the document has."""
        pentagon = "--sides 5 --beta 0.5 --mu 0.3 --restitution 0.9 --along alpha=0.95:0.05:400 --longest-branch 64"
        for seconds in (1, 2, 4, 8, 16, 32):  # until the first branches are there, and long before the last
            answer = self.interrupt(f"bifurcate {pentagon} --branches", seconds)
            self.assertEqual(answer["outcome"], "interrupted")
            if answer["branches"]:
                break
            (self.folder / "i.h5").unlink()
        self.assertEqual(len(answer["columns"]), 400)
        self.assertGreater(len(answer["branches"]), 0)
        self.assertEqual(self.samples("branch_ends").sizes["branch"], len(answer["branches"]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
