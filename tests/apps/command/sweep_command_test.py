"""swirl sweep, from outside: sweep_command_test.py SWIRL"""

import signal
import statistics
import subprocess
import time
import unittest

import xarray

from driving import InFolder, document, error_over_runs, run, sized, start

BASE = "--sides 6 --mu 0.5 --restitution 0.95 --transient 300 --collisions 300"
GRID = f"{BASE} --grid alpha=0.2:0.7:6 --grid beta=0.1:0.9:5 --runs 2"
COLUMNS = sized(9, 3)
LONG = f"{BASE} --grid alpha=0.2:0.7:{COLUMNS} --grid beta=0.1:0.9:25 --runs 4"


class BadGrids(InFolder):
    def test_each_is_one_line_and_exit_2(self):
        rest = "--sides 6 --mu 0.5 --restitution 0.95 --beta 0.5"
        for grid, mention in [("alpha=0.2:0.6:0", "COUNT"), ("alpha=0.2:0.6:1", "COUNT"), ("foo=1:2:3", "NAME"),
                              ("alpha=0.2:nan:3", "finite"), ("alpha=0.2:1.6:3", "1.6"), ("sides=3:6:3", "whole"),
                              ("alpha=0.2", "NAME=A:B:COUNT"), ("alpha=0.2:x:3", "x"), ("alpha=0.3:0.3:2", "COUNT = 1"),
                              ("alpha=0.2:0.6:3 --grid alpha=0.1:0.2:2", "twice"),
                              ("alpha=0.2:0.6:3 --grid mu=0:1:2 --grid restitution=0:1:2 --grid beta=0:1:2 --grid sides=3:4:2 --grid speed=0:1:2", "5"),
                              ("law=euler", "poisson, newton, stronge"), ("law=poisson,", "grid law=poisson,"), ("law=newton,newton", "twice"),
                              ("law", "law=NAME"), ("law=newton --law poisson", "both given"),
                              ("alpha=0.3:0.4:65536 --grid mu=0.1:0.2:65536 --grid beta=0.3:0.4:65536 --grid speed=0:1:65536", "1.845e+19"),
                              ("law=newton,poisson --grid alpha=0.2:0.4:3 --refine 1", "between two laws"),
                              ("alpha=0.2:0.6:3 --x 0.3", "random"), ("alpha=0.2:0.6:3 --runs 0", "runs")]:
            result = run(f"sweep {rest} --grid {grid} -o {self.folder}/a.h5")
            self.assertEqual((result.returncode, result.stdout), (2, ""), grid)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(mention, result.stderr)
            self.assertEqual(list(self.folder.iterdir()), [])


class SteadyModes(InFolder):
    """What no start reaches: the attracting steady modes of a cell, with their shares, 0 included."""
    SCENE = "--sides 6 --mu 0.5 --restitution 0.95 --transient 2000 --collisions 500"

    def test_a_mode_that_no_start_came_to_is_listed_all_the_same(self):
        # alpha = 0.38, beta = 0.9: beside chaos it takes one start in a hundred
        swept = document(f"sweep {self.SCENE} --grid alpha=0.38:0.4:2 --grid beta=0.9:0.9:1 --runs 2")
        modes = swept["cells"][0]["steady_modes"]
        self.assertEqual([(m["period"], m["share"]) for m in modes], [(1, 0)])
        known = document("describe --sides 6 --mu 0.5 --restitution 0.95 --alpha 0.38 --beta 0.9")["steady_modes"]
        stable = [m for m in known if m["stability"] == "stable"]
        self.assertEqual(len(stable), 1)
        for key, ours in (("S", "S"), ("tau", "flight_time")):
            self.assertAlmostEqual(stable[0][key], modes[0][ours], delta=1e-12)
        runs = document(f"classify {self.SCENE} --alpha 0.38 --beta 0.9 --runs 2")
        self.assertEqual(runs["steady_modes"], modes)
        column = document(f"bifurcate {self.SCENE} --beta 0.9 --along alpha=0.38:0.4:2 --starts 2")["columns"][0]
        self.assertEqual(column["steady_modes"], modes)

    def test_shares_are_those_of_the_runs_and_the_record_opens(self):
        grid = f"{self.SCENE} --grid alpha=0.3:0.7:5 --grid beta=0.3:0.7:5 --runs 2"
        swept = document(f"sweep {grid} -o {self.folder}/a.h5")
        listed = 0
        for cell in swept["cells"]:
            steady = [run_["mean_S"] for run_ in cell["runs"] if run_["kind"] == "fixed-point"]
            for mode in cell["steady_modes"]:
                listed += 1
                self.assertLess(mode["multiplier"], 1)
                self.assertEqual(mode["share"], sum(abs(S - mode["S"]) < 1e-6 for S in steady) / 2)
            for S in steady:  # none is steady without its mode
                self.assertTrue(any(abs(S - mode["S"]) < 1e-6 for mode in cell["steady_modes"]), cell["parameters"])
        self.assertGreater(listed, 0)
        with xarray.open_dataset(self.folder / "a.h5", group="sweep", engine="h5netcdf") as record:
            self.assertEqual(record["steady_S"].dims, ("alpha", "beta", "steady_mode"))
            self.assertEqual(int(record["steady_S"].notnull().sum()), listed)
        self.assertEqual(document(f"sweep {grid} -o {self.folder}/a.h5 --quiet"), swept)


class Refined(InFolder):
    TREE = "--sides 6 --mu 0.5 --restitution 0.95 --transient 400 --collisions 200 --grid alpha=0.2:0.8:4 --grid beta=0.1:0.9:4"
    FULL = TREE.replace(":4", ":13")  # what --refine 2 makes of it

    def test_a_tree_has_the_full_grids_cells_where_it_looked_and_its_neighbours_elsewhere(self):
        tree, full = self.folder / "tree.h5", self.folder / "full.h5"
        found = document(f"sweep {self.TREE} --refine 2 -o {tree}")
        every = document(f"sweep {self.FULL} -o {full}")
        whole = {tuple(cell["parameters"].values()): cell for cell in every["cells"]}
        self.assertLess(len(found["cells"]), len(whole))
        for cell in found["cells"]:  # those that were looked at
            self.assertEqual(cell["runs"], whole[tuple(cell["parameters"].values())]["runs"])
        with xarray.open_dataset(tree, group="sweep", engine="h5netcdf") as record:
            with xarray.open_dataset(full, group="sweep", engine="h5netcdf") as other:
                self.assertEqual(dict(record["run_mode"].sizes), dict(other["run_mode"].sizes))
                self.assertEqual(record["alpha"].values.tolist(), other["alpha"].values.tolist())
                seen = record["visited"].values == 1
                self.assertEqual(int(seen.sum()), len(found["cells"]))
                self.assertTrue((record["run_mode"].values[seen] == other["run_mode"].values[seen]).all())
                agree = (record["run_mode"].values == other["run_mode"].values)[..., 0].mean()
                self.assertGreater(agree, 0.9)
                self.assertTrue((record["impacts_spent"].values[~seen] == 0).all())

    def test_killed_and_continued_it_is_the_same_record(self):
        longer = self.TREE.replace("--collisions 200", f"--collisions {sized(4000, 400)}") + " --refine 2 --exhaustive --quiet"
        whole, cut = self.folder / "whole.h5", self.folder / "cut.h5"
        begin = time.monotonic()
        self.assertEqual(run(f"sweep {longer} -o {whole}").returncode, 0)
        took = time.monotonic() - begin
        for share in (0.3, 0.6):
            process = start(f"sweep {longer} -o {cut}")
            time.sleep(share * took)
            process.send_signal(signal.SIGKILL)
            process.wait(timeout=60)
        self.assertEqual(run(f"sweep {longer} -o {cut}").returncode, 0)
        self.assertEqual(whole.read_bytes(), cut.read_bytes())

    def test_what_is_wrong_beside_the_grid_is_told(self):
        """The grid wins over a flag for its parameter, but not over what is none."""
        for flags, grid, value in (("--sides 6 --alpha nine", "alpha=0.2:0.3:2", "nine"), ("--sides 6 --alpha 9", "alpha=0.2:0.3:2", "9"),
                                   ("--sides 6 --alpha nan", "alpha=0.2:0.3:2", "nan"), ("--sides six --alpha 0.4", "sides=3:4:2", "six")):
            result = run(f"sweep {flags} --beta 0.5 --mu 0.5 --restitution 0.95 --grid {grid}")
            self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
            self.assertIn(value, result.stderr)

    def test_what_cannot_be_refined_is_refused(self):
        for flags, mention in (("--grid sides=3:6:4 --refine 1", "whole"), ("--grid alpha=0.3:0.3:1 --refine 1", "COUNT"),
                               ("--grid alpha=0.2:0.3:2 --refine 0", "refine"), ("--grid alpha=0.2:0.3:2 --refine 11", "refine"),
                               ("--grid alpha=0.2:0.3 --refine 1 --sample sobol:4", "sample"),
                               ("--grid alpha=0.2:0.3:2 --refine 1 --shard 1/2", "shard"),
                               ("--grid alpha=0.2:0.3:2 --sample sobol:4", "COUNT"), ("--grid alpha=0.2:0.3 --sample halton:4", "sample"),
                               ("--grid alpha=0.2:0.3:2 --shard 3/2", "shard"), ("--grid alpha=0.2:0.3:2 --shard 1-2", "shard")):
            result = run(f"sweep --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.95 {flags} -o {self.folder}/a.h5")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), flags + result.stderr)
            self.assertIn(mention, result.stderr)
            self.assertEqual(list(self.folder.iterdir()), [])


class Axes(InFolder):
    SHORT = "--transient 300 --collisions 300"

    def test_a_law_is_an_axis_by_its_name(self):
        scene, file = "--sides 6 --alpha 0.45 --beta 0.5 --mu 0.5", self.folder / "a.h5"
        cells = document(f"sweep {scene} {self.SHORT} --grid law=stronge,newton --grid restitution=0.8:0.9:2 --runs 2 -o {file}")["cells"]
        self.assertEqual([cell["parameters"] for cell in cells],
                         [{"law": law, "restitution": e} for law in ("stronge", "newton") for e in (0.8, 0.9)])
        for cell in cells:
            law, e = cell["parameters"].values()
            for seed, run_ in enumerate(cell["runs"], 1):
                alone = document(f"classify {scene} {self.SHORT} --law {law} --restitution {e} --seed {seed}")
                for key in ("mode", "kind", "mean_S", "impacts"):
                    self.assertEqual(run_[key], alone[key], (law, e, seed, key))
        self.assertNotEqual(cells[0]["runs"][0]["mean_S"], cells[2]["runs"][0]["mean_S"])  # laws differ
        with xarray.open_dataset(file, group="sweep", engine="h5netcdf") as record:
            self.assertEqual(list(record["law"].values), ["stronge", "newton"])
            self.assertEqual(float(record["run_mean_S"].sel(law="newton", restitution=0.9, run=1)), cells[3]["runs"][1]["mean_S"])
        figure = run(f"plot {file} -o {self.folder}/a.png --json")
        self.assertEqual((figure.returncode, figure.stderr), (0, ""))

    def test_five_parameters_at_once(self):
        file, again = self.folder / "a.h5", self.folder / "b.h5"
        sweep = (f"sweep {self.SHORT} --grid sides=3:6:2 --grid alpha=0.3:0.6:{sized(3, 2)} --grid beta=0.3:0.5:2 --grid mu=0.1:0.5:2 "
                 "--grid restitution=0.8:0.9:2")
        cells = document(f"{sweep} -o {file}")["cells"]
        self.assertEqual(len(cells), sized(48, 32))
        self.assertEqual(cells[-1]["parameters"], {"sides": 6, "alpha": 0.6, "beta": 0.5, "mu": 0.5, "restitution": 0.9})
        self.assertEqual(run(f"{sweep} --threads 1 --quiet -o {again}").returncode, 0)
        self.assertEqual(file.read_bytes(), again.read_bytes())
        figure = run(f"plot {file} -o {self.folder}/a.png --json")  # three of them; the others stand at a value
        self.assertEqual((figure.returncode, figure.stderr), (0, ""))

    def test_a_sample_draws_laws_in_equal_shares(self):
        cells = document(f"sweep --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 {self.SHORT} --grid law=poisson,newton,stronge "
                         "--grid alpha=0.3:0.6 --sample latin:12")["cells"]
        laws = [cell["parameters"]["law"] for cell in cells]
        self.assertEqual({law: laws.count(law) for law in laws}, {"poisson": 4, "newton": 4, "stronge": 4})

    def test_laws_are_compared_in_the_figure_of_four_parameters(self):
        file = self.folder / "a.h5"
        run(f"sweep --sides 6 --restitution 0.9 {self.SHORT} --grid law=stronge,newton --grid alpha=0.3:0.6:3 --grid beta=0.3:0.5:3 "
            f"--grid mu=0.1:0.5:3 --quiet -o {file}")
        figure = run(f"plot {file} -o {self.folder}/a.svg")
        self.assertEqual((figure.returncode, figure.stderr), (0, ""))
        text = (self.folder / "a.svg").read_text()
        for words in ("Stronge's law", "Newton's law", "is one of 3 values"):
            self.assertIn(words, text)


class CellAttractors(unittest.TestCase):
    def test_an_error_is_of_the_runs_of_one_attractor(self):
        # Chaos that some starts have left and some have not, and what they came to.
        cell, = document("sweep --sides 6 --mu 0.3 --restitution 0.9 --transient 2000 --collisions 1000 --grid alpha=0.398:0.398:1 "
                         "--grid beta=0.893:0.893:1 --runs 16")["cells"]
        found, runs = cell["attractors"], cell["runs"]
        self.assertGreater(len(found), 1)
        self.assertAlmostEqual(sum(one["share"] for one in found), 1, delta=1e-12)
        self.assertEqual([one["share"] for one in found], sorted((one["share"] for one in found), reverse=True))
        for one in found:
            mine = [r["mean_S"] for r in runs if (r["mode"], r["kind"], r["period"]) == (one["mode"], one["kind"], one["period"])
                    and (one["kind"] not in ("fixed-point", "cycle") or abs(r["mean_S"] - one["mean_S"]) < 1e-6)]
            self.assertEqual(len(mine), round(16 * one["share"]))
            self.assertAlmostEqual(one["mean_S"], statistics.fmean(mine), delta=1e-12)
            if len(mine) > 1:
                expected = error_over_runs(mine)
                self.assertAlmostEqual(one["mean_S_error"], expected, delta=4e-4 * expected + 1e-12)
            else:  # its own, which a cycle has none of
                own, = [r["mean_S_error"] for r in runs if r["mean_S"] == one["mean_S"]]
                self.assertEqual(one["mean_S_error"], own or None)
            self.assertTrue(one["share_low"] < one["share"] <= one["share_high"])


class Samples(InFolder):
    SCENE = "--sides 6 --mu 0.5 --restitution 0.95 --transient 400 --collisions 200 --grid alpha=0.2:0.8 --grid beta=0.1:0.9"

    def test_points_fill_the_box_and_the_record_lists_them(self):
        for kind in ("sobol", "latin"):
            file = self.folder / f"{kind}.h5"
            cells = document(f"sweep {self.SCENE} --sample {kind}:12 --runs 2 -o {file}")["cells"]
            self.assertEqual(len(cells), 12)
            alone = document(f"classify --sides 6 --mu 0.5 --restitution 0.95 --transient 400 --collisions 200 "
                             f"--alpha {cells[5]['parameters']['alpha']!r} --beta {cells[5]['parameters']['beta']!r}")
            self.assertEqual(alone["mean_S"], cells[5]["runs"][0]["mean_S"])
            with xarray.open_dataset(file, group="sweep", engine="h5netcdf") as record:
                self.assertEqual(record["run_mode"].dims, ("cell", "run"))
                self.assertEqual(record["alpha"].values.tolist(), [c["parameters"]["alpha"] for c in cells])
        slices = sorted(int((c["parameters"]["alpha"] - 0.2) / 0.05) for c in cells)
        self.assertEqual(slices, list(range(12)))
        refused = run(f"sweep {self.SCENE} --sample latin:13 --runs 2 -o {self.folder}/latin.h5")
        self.assertEqual(refused.returncode, 2)

    def test_shares_have_wilsons_interval(self):
        cells = document(f"sweep {self.SCENE} --sample sobol:4 --runs 3")["cells"]
        for cell in cells:
            for mode, share in cell["modes"].items():
                self.assertLessEqual(cell["modes_low"][mode], share)
                self.assertGreaterEqual(cell["modes_high"][mode], share)
        whole = [c for c in cells if 1 in c["modes"].values()]
        self.assertGreater(len(whole), 0)
        for cell in whole:  # 3 of 3: n/(n + z^2)
            self.assertAlmostEqual(list(cell["modes_low"].values())[0], 3 / (3 + 1.959963984540054**2), delta=1e-14)


class Shards(InFolder):
    def test_joined_they_are_the_bytes_of_one_process(self):
        for name, flags in (("grid", GRID), ("sample", GRID.replace("0.7:6", "0.7").replace("0.9:5", "0.9") + " --sample latin:31")):
            whole, joined = self.folder / f"{name}.h5", self.folder / f"{name}_joined.h5"
            self.assertEqual(run(f"sweep {flags} --quiet -o {whole}").returncode, 0)
            parts = [self.folder / f"{name}{i}.h5" for i in (1, 2, 3)]
            for i, part in enumerate(parts):
                self.assertEqual(run(f"sweep {flags} --shard {i + 1}/3 --quiet -o {part}").returncode, 0)
            missing = run(f"join {parts[0]} {parts[2]} -o {joined}")
            self.assertEqual((missing.returncode, missing.stderr), (2, "swirl: shard 2/3 is missing\n"))
            twice = run(f"join {parts[0]} {parts[1]} {parts[1]} -o {joined}")
            self.assertEqual(twice.returncode, 2)
            self.assertIn("twice", twice.stderr)
            self.assertFalse(joined.exists())
            self.assertEqual(run(f"join {parts[2]} {parts[0]} {parts[1]} --quiet -o {joined}").returncode, 0)
            self.assertEqual(whole.read_bytes(), joined.read_bytes())
            again = run(f"sweep {flags} --quiet -o {joined}")  # it is the sweep's record
            self.assertEqual(again.returncode, 0)
            self.assertEqual(run(f"sweep {flags} --shard 2/3 -o {parts[1]}").returncode, 0)
            other = run(f"sweep {flags} --shard 1/3 -o {parts[1]}")
            self.assertEqual(other.returncode, 2)
            self.assertIn("shard", other.stderr)
        foreign = run(f"join {self.folder}/grid1.h5 {self.folder}/sample2.h5 {self.folder}/grid3.h5 -o {self.folder}/x.h5")
        self.assertEqual(foreign.returncode, 2)
        self.assertEqual(run(f"join {self.folder}/grid.h5 -o {self.folder}/x.h5").returncode, 2)
        self.assertFalse((self.folder / "x.h5").exists())

    def test_units_go_with_them(self):
        flags = GRID + " --container-radius 2 --swirl-rate 3"
        whole, joined = self.folder / "whole.h5", self.folder / "joined.h5"
        self.assertEqual(run(f"sweep {flags} --quiet -o {whole}").returncode, 0)
        for i in (1, 2):
            self.assertEqual(run(f"sweep {flags} --shard {i}/2 --quiet -o {self.folder}/{i}.h5").returncode, 0)
        self.assertEqual(run(f"join {self.folder}/1.h5 {self.folder}/2.h5 --quiet -o {joined}").returncode, 0)
        self.assertEqual(whole.read_bytes(), joined.read_bytes())


class Sweeps(InFolder):
    def test_a_run_is_what_classify_gives(self):
        swept = document(f"sweep {GRID} --seed 5")
        self.assertEqual(len(swept["cells"]), 30)
        for cell in swept["cells"][3::7]:
            parameters = cell["parameters"]
            for r, found in enumerate(cell["runs"]):
                alone = document(f"classify {BASE} --alpha {parameters['alpha']!r} --beta {parameters['beta']!r} "
                                 f"--seed {5 + r}")
                self.assertEqual((alone["mode"], alone["mean_S"], alone["largest_exponent"]),
                                 (found["mode"], found["mean_S"], found["largest_exponent"]))
            self.assertAlmostEqual(sum(cell["modes"].values()), 1, delta=1e-15)

    def test_fewer_impacts_give_the_verdicts_of_all(self):
        scene = GRID.replace("--transient 300 --collisions 300", "--transient 3000 --collisions 3000")
        scene = sized(scene, scene.replace(":6", ":3").replace(":5", ":2"))
        few, all_ = document(f"sweep {scene}"), document(f"sweep {scene} --exhaustive")
        self.assertEqual((few["settings"]["exhaustive"], all_["settings"]["exhaustive"]), (False, True))
        spent = {"few": 0, "all": 0}
        for a, b in zip(few["cells"], all_["cells"]):
            for one, other in zip(a["runs"], b["runs"]):
                self.assertEqual([one[key] for key in ("mode", "kind", "period", "outcome")],
                                 [other[key] for key in ("mode", "kind", "period", "outcome")], a["parameters"])
                self.assertAlmostEqual(one["mean_S"], other["mean_S"], delta=1e-9)
                self.assertLessEqual(one["impacts"], other["impacts"])
            self.assertEqual(a["impacts_spent"], sum(run_["impacts"] for run_ in a["runs"]))
            spent["few"] += a["impacts_spent"]
            spent["all"] += b["impacts_spent"]
        self.assertLess(spent["few"], 0.8 * spent["all"])

    def test_threads_do_not_change_a_bit_and_xarray_opens_the_grid(self):
        for threads in (1, 2):
            swept = run(f"sweep {GRID} --threads {threads} -o {self.folder}/{threads}.h5 --quiet")
            self.assertEqual(swept.returncode, 0)
        self.assertEqual((self.folder / "1.h5").read_bytes(), (self.folder / "2.h5").read_bytes())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["1.h5", "2.h5"])
        with xarray.open_dataset(self.folder / "1.h5", group="sweep", engine="h5netcdf") as grid:
            self.assertEqual(grid["share"].dims, ("alpha", "beta", "mode"))
            self.assertEqual(grid["run_mode"].sizes, {"alpha": 6, "beta": 5, "run": 2})
            self.assertAlmostEqual(float(grid["alpha"][-1]), 0.7)

    def test_killed_and_continued_is_the_same_record(self):
        whole, cut = self.folder / "whole.h5", self.folder / "cut.h5"
        begin = time.monotonic()
        self.assertEqual(run(f"sweep {LONG} -o {whole} --quiet").returncode, 0)
        half = (time.monotonic() - begin) / 2
        for signal_, code in ((signal.SIGKILL, -9), (signal.SIGINT, 130)):
            process = start(f"sweep {LONG} -o {cut} --quiet")
            time.sleep(half)
            process.send_signal(signal_)
            ended = process.wait(timeout=60)
            self.assertIn(ended, (code, 0))
            if ended == 0:  # it was quicker this time
                continue
            self.assertFalse(cut.exists())
            self.assertTrue((self.folder / ".cut.h5.journal").exists())
            other = run(f"sweep {LONG} --seed 9 -o {cut}")
            self.assertEqual((other.returncode, len(other.stderr.splitlines())), (2, 1))
        if not cut.exists():
            self.assertEqual(run(f"sweep {LONG} -o {cut} --quiet").returncode, 0)
        self.assertEqual(whole.read_bytes(), cut.read_bytes())
        self.assertFalse((self.folder / ".cut.h5.journal").exists())

    def test_interrupted_it_says_what_is_kept_if_a_record_was_asked_for(self):
        kept = r"^swirl: interrupted; [1-9]\d* of {} runs are kept: the same command goes on from there$"
        kept = kept.format(100 * COLUMNS)
        longer = LONG.replace("--collisions 300", "--collisions 20000")
        for flags, said in ((f"-o {self.folder}/a.h5", kept), (f"-o {self.folder}/b.h5 --quiet", "^$"), ("", "^$")):
            process = start(f"sweep {longer} {flags}", stderr=subprocess.PIPE, text=True)
            time.sleep(0.7)
            process.send_signal(signal.SIGINT)
            message = process.communicate(timeout=60)[1]
            self.assertEqual(process.returncode, 130)
            self.assertRegex(message.rstrip("\n"), said)

    def test_a_finished_record_is_used_and_one_of_other_options_refused(self):
        file = self.folder / "a.h5"
        first = document(f"sweep {GRID} -o {file}")
        bytes_ = file.read_bytes()
        self.assertEqual(document(f"sweep {GRID} -o {file} --quiet"), first)
        for change, name in (("--seed 2", "seed"), ("--exhaustive", "exhaustive"), ("--runs 1", "runs"), ("--collisions 400", "collisions")):
            grid = GRID.replace({"runs": "--runs 2", "collisions": "--collisions 300"}.get(name, "nothing"), "")
            refused = run(f"sweep {grid} {change} -o {file}")
            self.assertEqual(refused.returncode, 2, refused.stderr)
            self.assertIn(name, refused.stderr)
        self.assertEqual(file.read_bytes(), bytes_)
        file.write_text("not a record")
        self.assertEqual(run(f"sweep {GRID} -o {file}").returncode, 2)
        self.assertEqual(file.read_text(), "not a record")


if __name__ == "__main__":
    unittest.main()
