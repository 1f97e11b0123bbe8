"""swirl orbits, from outside: orbits_command_test.py SWIRL"""

import json
import unittest

import xarray

from driving import SEARCH, Keeping, Refusing, document, run, sized

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
POINT = "-0.083922288419212287574,0.027966794811174552721,-0.55420644250323559488,0.88979354385790028771,-0.97926605821858726645"


class Orbits(Refusing):
    def test_the_published_fixed_point_is_found_with_its_multipliers(self):
        found = document(f"orbits {HEXAGON} --period 1 {SEARCH}")["orbits"]
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
                                                 "complete_to": 12, "not_fixed": 0})
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
        # Cut off soon after the first search: later what is missed may come out as less than one half.
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
            flags = f"--max-period 2 --threads {threads} --starts 100 --trajectories 2 --collisions 200"
            self.assertEqual(run(f"orbits {HEXAGON} {flags} -o {path} --quiet").returncode, 0)
            records.append(path.read_bytes())
        self.assertEqual(*records)
        orbits = xarray.open_dataset(self.folder / "1.h5", group="orbits", engine="h5netcdf")
        self.assertEqual(set(orbits["period"].values), {1, 2})
        self.assertTrue((orbits["residual"] < 1e-12).all())

    def test_near_grazing_it_is_the_nearest_cycle(self):
        # A 3-cycle with an impact at u_n = 0.02 and a multiplier of 8e4: its other points, where the given one leads to, are
        # 8e4 times farther off.
        cycle = (-3.140464623458104, 0.0008869223756284513, -0.018611351111013124, 0.09296616479760035, -1.4824151997686588)
        for size in sized((1e-3, 1e-6), (1e-6,)):
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
        result = run("orbits --sides disk --alpha 0.4 --beta 0.1 --mu 2 --restitution 0.1 --near=0,-0.001,0.1,-1 --period 9 --json")
        answer = json.loads(result.stdout)
        self.assertEqual((result.returncode, answer["residual"], answer["candidates"]), (3, None, 0))
        self.assertIn("impacts", answer["limits"][0])

    def test_cycles_without_restitution_can_be_given_back(self):
        scene = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0"
        found = document(f"orbits {scene} --period 1 --starts 100 --trajectories {sized(2, 1)}")["orbits"]
        self.assertGreaterEqual(len(found), 3)
        for orbit in found[:sized(len(found), 5)]:
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


class KeptCycles(Keeping):
    def test_cycles_that_were_found_are_kept(self):
        for seconds in (2, 20):  # on a loaded machine none is found so soon
            answer = self.interrupt(f"orbits {HEXAGON} --period 1 --starts 40000 --trajectories 1 --threads 1", seconds)
            if answer["orbits"]:
                break
        self.assertEqual(answer["outcome"], "interrupted")
        self.assertGreater(len(answer["orbits"]), 0)
        self.assertLess(answer["candidates"], 40000)
        self.assertEqual(self.samples("orbits").sizes["orbit"], len(answer["orbits"]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
