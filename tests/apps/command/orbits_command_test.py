"""swirl orbits, continue and bifurcate, from outside: orbits_command_test.py SWIRL"""

import json
import signal
import subprocess
import time
import unittest

import xarray

from driving import InFolder, document, run, start

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
POINT = "-0.083922288419212287574,0.027966794811174552721,-0.55420644250323559488,0.88979354385790028771,-0.97926605821858726645"
WINDOW = "--sides 6 --beta 0.5 --mu 0.5 --restitution 0.95"


class Refusing(InFolder):
    def refused(self, arguments, mention):
        result = run(f"{arguments} -o {self.folder}/a.h5")
        self.assertEqual((result.returncode, result.stdout), (2, ""), (arguments, result.stderr))
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class Orbits(Refusing):
    def test_the_published_fixed_point_is_found_with_its_multipliers(self):
        found = document(f"orbits {HEXAGON} --period 1")["orbits"]
        wanted = [float(x) for x in POINT.split(",")]
        best = min(found, key=lambda o: abs(o["points"][0]["S"] - wanted[4]))
        for name, value in zip(("psi", "chi", "vn", "vt", "S"), wanted):
            self.assertAlmostEqual(best["points"][0][name], value, delta=1e-12)
        for (re, im), (a, b) in zip(best["multipliers"], [(0.603654650944, 0.745364501151), (0.603654650944, -0.745364501151),
                                                          (-0.235491544256, 0.54249265091), (-0.235491544256, -0.54249265091), (0, 0)]):
            self.assertAlmostEqual(re, a, delta=2e-12)
            self.assertAlmostEqual(im, b, delta=2e-12)
        self.assertEqual((best["stability"], best["index"], best["family"], best["period"]), ("stable", 0, None, 1))
        self.assertEqual([set(letter) for letter in best["word"]], [{"vertex_step", "contact_mode"}])
        self.assertAlmostEqual(best["mean_S"], best["points"][0]["S"], delta=1e-13)

    def test_period_1_is_complete_and_says_so(self):
        found = document(f"orbits {HEXAGON} --period 1 --starts 50 --trajectories 1 --collisions 200")
        self.assertEqual(found["fixed_points"], {"max_time": 12, "set": "points", "found": 31, "complete": True,
                                                 "complete_to": 12})
        self.assertEqual(len(found["orbits"]), 31)  # e = 0.9: none through contact
        self.assertEqual(sum(abs(o["points"][0]["psi"]) > 1.5 for o in found["orbits"]), 25)  # the branch psi near pi
        self.assertIn("all 31 fixed points with tau <= 12", run(f"orbits {HEXAGON} --starts 0 --trajectories 0").stdout)
        short = document(f"orbits {HEXAGON} --max-time 2.5 --starts 0 --trajectories 0")
        self.assertEqual([o for o in found["orbits"] if o["return_time"] <= 2.5], short["orbits"])

    def test_period_1_is_what_describe_lists(self):
        for scene in ("--sides 5 --alpha 0.45 --beta 0.6 --mu 0.3 --restitution 0.7 --law stronge",
                      "--sides 3 --alpha 0.5 --beta 0.4 --mu 0.2 --restitution 0.8 --law newton",
                      "--sides 4 --alpha 0.5 --beta 0.3 --mu 0.4 --restitution 1",
                      "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1",
                      "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 0.9"):
            found = document(f"orbits {scene} --max-time 5 --starts 0 --trajectories 0")
            known = document(f"describe {scene} --max-time 5")
            modes = known["steady_modes"] or [f["midway"] for f in known["families"]]
            self.assertEqual([o["points"][0] for o in found["orbits"]], [m["point"] for m in modes], scene)
            self.assertEqual(found["fixed_points"]["found"], len(modes), scene)
            for orbit, mode in zip(found["orbits"], modes):
                self.assertEqual(orbit["stability"], mode["stability"], scene)
                # Multipliers in 100 digits against those in double: rounding by the size of DF.
                self.assertAlmostEqual(abs(complex(*orbit["multipliers"][0])) / abs(complex(*mode["multipliers"][0])), 1,
                                       delta=1e-6)

    def test_how_many_were_missed_is_estimated(self):
        few = document(f"orbits {HEXAGON} --period 3 --starts 150 --trajectories 2 --collisions 300")
        search, = few["searches"]
        self.assertEqual(search["cycles"], len(few["orbits"]))
        self.assertEqual(search["samples"], sum(o["found"] for o in few["orbits"]))
        once, twice = (sum(o["found"] == n for o in few["orbits"]) for n in (1, 2))
        self.assertEqual((search["found_once"], search["found_twice"]), (once, twice))
        n = search["samples"]
        self.assertAlmostEqual(search["missed"], (n - 1) / n * once * (once - 1) / (2 * (twice + 1)), delta=1e-12)
        self.assertGreater(once, 0)
        # A long search finds 61, some of them rarely: of so unequal ones the estimate is a lower bound.
        self.assertLess(search["missed"], 61 - search["cycles"])
        self.assertIsNone(few["fixed_points"])

    def test_complete_searches_until_none_seems_missing(self):
        few = "--complete --starts 50 --trajectories 1 --collisions 200"
        landing = "--sides 5 --alpha 0.6433 --beta 0.5562 --mu 2 --restitution 0.05"  # one fixed point through contact
        search, = document(f"orbits {landing} {few}")["searches"]
        self.assertEqual((search["cycles"], search["missed"]), (1, 0))
        self.assertGreater(search["candidates"], 60)  # a second search, twice as long, brought nothing new
        cut = document(f"orbits {HEXAGON} --period 3 {few} --most-starts 60", 3)
        self.assertGreater(cut["searches"][0]["missed"], 0.5)
        self.assertLess(cut["searches"][0]["candidates"], 120)

    def test_near(self):
        near = document(f"orbits {HEXAGON} --near=-0.0829,0.028,-0.5552,0.8908,-0.9783")
        self.assertEqual(len(near["orbits"]), 1)
        self.assertLessEqual(near["iterations"], 20)
        self.assertAlmostEqual(near["orbits"][0]["points"][0]["S"], -0.97926605821858726645, delta=1e-12)

    def test_nothing_near_is_exit_3_and_a_document(self):
        result = run(f"orbits {HEXAGON} --period 7 --near=1,0.1,-0.3,2,3 --json")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(json.loads(result.stdout)["orbits"], [])

    def test_a_family_is_one_orbit_with_its_tangent(self):
        disk = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"
        found = document(f"orbits {disk}")["orbits"]
        self.assertEqual(len(found), 4)
        self.assertEqual([abs(o["points"][0]["psi"]) > 3 for o in found], [False, False, True, True])  # both branches
        main = next(o for o in found if o["family"]["shortest_return_time"] < 0.1)
        self.assertEqual(main["family"]["dimension"], 1)
        self.assertGreater(main["family"]["longest_return_time"], 2.5)
        self.assertEqual(set(main["family"]["tangents"][0]), {"psi", "vn", "vt", "S"})
        pinned = document(f"orbits {disk} --pin tau=2.5")["orbits"]
        member = min(pinned, key=lambda o: abs(o["points"][0]["S"] + 0.30503695))
        self.assertAlmostEqual(member["points"][0]["S"], -0.30503695, delta=1e-8)
        self.assertAlmostEqual(abs(complex(*member["multipliers"][0])), 1.0072349, delta=1e-7)

    def test_without_friction_and_with_dissipation_none_exist(self):
        answer = document("orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0 --restitution 0.9")
        self.assertEqual(answer["orbits"], [])
        self.assertIn("J", answer["none_exist"])

    def test_threads_do_not_matter_and_the_record_opens(self):
        records = []
        for threads in (1, 2):
            path = self.folder / f"{threads}.h5"
            self.assertEqual(run(f"orbits {HEXAGON} --max-period 2 --threads {threads} -o {path} --quiet").returncode, 0)
            records.append(path.read_bytes())
        self.assertEqual(*records)
        orbits = xarray.open_dataset(self.folder / "1.h5", group="orbits", engine="h5netcdf")
        self.assertEqual(set(orbits["period"].values), {1, 2})
        self.assertTrue((orbits["residual"] < 1e-12).all())

    def test_near_grazing_it_is_the_nearest_cycle(self):
        # A 3-cycle with an impact at u_n = 0.02 and a multiplier of 8e4: its other points, where the given one leads to, are
        # 8e4 times farther off.
        cycle = (-3.140464623458104, 0.0008869223756284513, -0.018611351111013124, 0.09296616479760035, -1.4824151997686588)
        for size in (1e-3, 1e-6):
            found = given = 0
            for i in range(5):
                for sign in (size, -size):
                    near = [x + sign * (j == i) for j, x in enumerate(cycle)]
                    result = run(f"orbits {HEXAGON} --period 3 --near={','.join(map(repr, near))} --json")
                    if result.returncode == 2:  # not leaving the wall, or another vertex outside
                        continue
                    answer = json.loads(result.stdout)
                    given += 1
                    found += result.returncode == 0 and answer["distance"] < 1.5 * size
            self.assertGreaterEqual(found, 0.9 * given, size)
            self.assertGreaterEqual(given, 9)

    def test_an_orbit_that_ends_says_how_far_it_came(self):
        result = run("orbits --sides disk --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.1 --near=0,-0.001,0.1,-1 --period 9 --json")
        answer = json.loads(result.stdout)
        self.assertEqual((result.returncode, answer["residual"], answer["candidates"]), (3, None, 0))
        self.assertIn("impacts", answer["limits"][0])

    def test_cycles_without_restitution_can_be_given_back(self):
        scene = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0"
        found = document(f"orbits {scene} --period 1 --starts 100 --trajectories 2")["orbits"]
        self.assertGreaterEqual(len(found), 3)
        for orbit in found:
            point = ",".join(repr(orbit["points"][0][name]) for name in ("psi", "chi", "vn", "vt", "S"))
            again = document(f"orbits {scene} --near={point}")
            self.assertLess(again["distance"], 1e-9)
            self.assertEqual(run(f"simulate {scene} --point={point} --collisions 2 --quiet").returncode, 0)

    def test_wrong_input(self):
        for extra, mention in [("--period 0", "period"), ("--period 2 --max-period 3", "both"), ("--near 1,2", "numbers"),
                               ("--near 0,0,1,0,0", "u_n"), ("--pin x=3", "pin"), ("--pin tau=-1", "tau"),
                               ("--accuracy half", "quad"), ("--starts -1", "starts"),
                               ("--max-time 0", "max-time"), ("--max-time nan", "max-time"), ("--max-time 20000", "10000"),
                               (f"--complete --near={POINT}", "both")]:
            self.refused(f"orbits {HEXAGON} {extra}", mention)


class Continue(Refusing):
    def test_a_branch_with_its_special_points(self):
        branches = document(f"continue {HEXAGON} --from={POINT} --along alpha=0.1:0.9")["branches"]
        kinds = [s["kind"] for s in branches[0]["special"]]
        for kind in ("fold", "flip", "neimark-sacker"):
            self.assertIn(kind, kinds)
        for point in branches[0]["points"]:
            self.assertLessEqual(point["residual"], 1e-12)
            self.assertTrue(0.1 <= point["parameter"] <= 0.9)
        for special in branches[0]["special"]:
            moduli = [complex(*m) for m in special["multipliers"]]
            critical = {"fold": lambda m: abs(m - 1), "flip": lambda m: abs(m + 1),
                        "neimark-sacker": lambda m: abs(abs(m) - 1) if m.imag else 1}[special["kind"]]
            self.assertLess(min(map(critical, moduli)), 1e-6)
            self.assertEqual(set(special["point"]), {"psi", "chi", "vn", "vt", "S"})
            self.assertIsNotNone(special["normal_form"])
        doubled = branches[1]
        self.assertEqual((doubled["period"], doubled["begins"], doubled["switched_from"]), (2, "switched", 0))

    def test_the_disks_family_loses_its_stability(self):
        branch, = document("continue --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 "
                           "--from=0,-0.576,0.192,-0.305 --along tau=1:3")["branches"]
        special, = branch["special"]
        self.assertEqual(special["kind"], "neimark-sacker")
        self.assertAlmostEqual(special["parameter"], 2.33112237041442, delta=1e-8)

    def test_the_ends_of_the_range_are_on_the_branch(self):
        branch = document(f"continue {HEXAGON} --from={POINT} --along beta=0.48:0.52 --switch 0")["branches"][0]
        self.assertEqual(sorted({branch["points"][0]["parameter"], branch["points"][-1]["parameter"]}), [0.48, 0.52])
        self.assertEqual((branch["begins"], branch["ends"]), ("range", "range"))

    def test_a_family_at_the_end_of_the_range_is_not_followed(self):
        # At beta = 0 psi is free by symmetry.
        steady = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1 " \
                 "--from=0,0,-0.5161526339171516,0.917202293555976,-1.0430057338899403"
        branches = document(f"continue {steady} --along beta=0:1")["branches"]
        self.assertLess(len(branches), 5)
        for branch in branches:
            self.assertLess(sum(point["parameter"] < 1e-9 for point in branch["points"]), 3)
            self.assertLess(len(branch["points"]), 3000)

    def test_nothing_happens_where_friction_ends(self):
        steady = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1 " \
                 "--from=0,0,-0.5161526339171516,0.917202293555976,-1.0430057338899403"
        branch = document(f"continue {steady} --along mu=0:1 --switch 0")["branches"][0]
        self.assertEqual([s["kind"] for s in branch["special"] if s["parameter"] < 1e-6], [])

    def test_the_record_holds_what_the_document_says(self):
        path = self.folder / "b.h5"
        branches = document(f"continue {HEXAGON} --from={POINT} --along alpha=0.01:0.99 -o {path}")["branches"]
        special = xarray.open_dataset(path, group="special", engine="h5netcdf")
        listed = [s for b in branches for s in b["special"]]
        self.assertEqual(list(special["kind"].values), [s["kind"] for s in listed])
        self.assertEqual([bool(x) for x in special["located"].values], [s.get("located", True) for s in listed])
        for row, s in enumerate(listed):
            if "normal_form" in s:
                self.assertEqual(special["form_nonlinear_re"].values[row], s["normal_form"]["nonlinear"][0])
            if "word_before" in s:
                self.assertEqual(special["word_before"].values[row] == "", s["word_before"] == [])
        ends = xarray.open_dataset(path, group="branch_ends", engine="h5netcdf")
        self.assertEqual(list(ends["ends"].values), [b["ends"] for b in branches])
        self.assertEqual(list(ends["switched_from"].values), [b.get("switched_from", -1) for b in branches])

    def test_nothing_there_is_exit_3(self):
        result = run(f"continue {HEXAGON} --from=1,0.1,-0.3,2,3 --period 5 --along alpha=0.3:0.5 --json")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(json.loads(result.stdout)["branches"], [])

    def test_wrong_input(self):
        rest = f"continue {HEXAGON}"
        for extra, mention in [("--along alpha=0.3:0.5", "from"), (f"--from={POINT}", "along"),
                               (f"--from={POINT} --along alpha=0.5:0.6", "outside"),
                               (f"--from={POINT} --along sides=3:6", "NAME"), (f"--from={POINT} --along alpha=0.3:0.5:3", "A:B"),
                               (f"--from={POINT} --along alpha=0.3:x", "x"), (f"--from={POINT} --along alpha=0.4:0.4", "differ"),
                               ("--from=1,2,3 --along alpha=0.3:0.5", "numbers"),
                               (f"--from={POINT} --along alpha=0.3:0.5 --longest-step nan", "longest-step"),
                               (f"--from={POINT} --along alpha=0.3:0.5 --longest-step 2", "longest-step")]:
            self.refused(f"{rest} {extra}", mention)


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
        column = document(f"bifurcate {scene} --along beta=0.569:0.57:2 --starts 3")["columns"][1]
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

    def test_chaos_is_named(self):
        answer = document(f"bifurcate {WINDOW} --along alpha=0.3:0.35:3 --starts 2")
        self.assertEqual({c["mode"] for c in answer["columns"]}, {"chaotic"})
        self.assertEqual({c["period"] for c in answer["columns"]}, {None})

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
            self.assertEqual(run(f"bifurcate {WINDOW} --along alpha=0.37:0.4:4 --starts 1 --branches --observable {observable} "
                                 f"--quiet -o {path}").returncode, 0)
            self.assertEqual(run(f"plot {path} -o {self.folder}/v.svg --quiet").returncode, 0)
            figures.append((self.folder / "v.svg").read_text())
        self.assertNotEqual(*figures)
        branches = xarray.open_dataset(path, group="branches", engine="h5netcdf")
        self.assertLess(float(branches["value"].max()), 0)  # v_n of a state that leaves the wall with chi = psi = 0

    def test_threads_do_not_matter(self):
        outputs = [run(f"bifurcate {WINDOW} --along alpha=0.3:0.4:6 --starts 3 --follow --json --threads {t}").stdout for t in (1, 2)]
        self.assertEqual(*outputs)

    def test_falling_ranges_run_backwards(self):
        columns = document(f"bifurcate {WINDOW} --along alpha=0.41:0.37:3 --starts 1")["columns"]
        self.assertEqual(columns[0]["parameter"], 0.41)

    def test_wrong_input(self):
        for extra, mention in [("--along alpha=0.3:0.4", "COUNT"), ("--along alpha=0.3:0.4:1", "COUNT"),
                               ("--along alpha=0.3:1.4:5", "1.39"), ("--along S=0:1:5", "NAME"), ("", "along"),
                               ("--along alpha=0.3:0.4:5 --observable x", "observable"),
                               ("--along alpha=0.3:0.4:5 --x 0.1", "random"), ("--along alpha=0.3:0.4:5 --starts 0", "follow")]:
            self.refused(f"bifurcate {WINDOW} {extra}", mention)


class Interrupted(InFolder):
    """SIGINT: exit 130, and what is finished, whole, in the document and on disk."""

    def interrupt(self, arguments, seconds):
        process = start(f"{arguments} --json --quiet -o {self.folder}/i.h5", stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                        text=True)
        time.sleep(seconds)
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=100)
        self.assertEqual((process.returncode, error), (130, ""), arguments)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["i.h5"])
        return json.loads(out)

    def samples(self, group):
        return xarray.open_dataset(self.folder / "i.h5", group=group, engine="h5netcdf")

    def test_a_diagram_keeps_the_orbits_that_are_done(self):
        answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.1:0.9:2000 --starts 20 --threads 1", 1.5)
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
                answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.3:0.34:3 {extra} --threads 1", 1)
                self.assertEqual(answer["columns"], [])

    def test_followed_columns_are_kept(self):
        answer = self.interrupt(f"bifurcate {WINDOW} --along alpha=0.1:0.9:5000 --starts 0 --follow --threads 1", 1.5)
        self.assertGreater(len(answer["columns"]), 0)

    def test_cycles_that_were_found_are_kept(self):
        answer = self.interrupt(f"orbits {HEXAGON} --period 1 --starts 40000 --trajectories 1 --threads 1", 3)
        self.assertEqual(answer["outcome"], "interrupted")
        self.assertGreater(len(answer["orbits"]), 0)
        self.assertLess(answer["candidates"], 40000)
        self.assertEqual(self.samples("orbits").sizes["orbit"], len(answer["orbits"]))

    def test_a_branch_is_kept_as_far_as_it_came(self):
        answer = self.interrupt(f"continue {HEXAGON} --from={POINT} --along alpha=0.1:0.9 --longest-step 1e-6", 0.4)
        self.assertGreater(len(answer["branches"][0]["points"]), 10)  # of 20,000, which take some 0.7 s
        self.assertEqual(answer["branches"][0]["ends"], "stopped")
        self.assertEqual(self.samples("branches").sizes["point"], len(answer["branches"][0]["points"]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
