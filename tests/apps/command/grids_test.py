"""What a sweep's cells can be, and records that grow: lists, logarithms, tables of scenes, more runs. grids_test.py SWIRL ROOT"""

import math
import re
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

import xarray

ROOT = Path(sys.argv.pop())

from driving import InFolder, document, run, start  # noqa: E402

sys.path.insert(0, str(ROOT / "notebooks-export"))

from swirl_figures import draw  # noqa: E402

SHORT = "--transient 200 --collisions 200"
SCENE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"


def scene_without(*names):
    words = SCENE.split()
    return " ".join(f"{flag} {value}" for flag, value in zip(words[::2], words[1::2]) if flag[2:] not in names)


class Grids(InFolder):
    def check_runs(self, cells, fixed):
        """Each run is what classify gives for the cell's scene."""
        for cell in cells:
            flags = " ".join(f"--{name} {value}" for name, value in cell["parameters"].items())
            for seed, found in enumerate(cell["runs"], 1):
                alone = document(f"classify {fixed} {SHORT} {flags} --seed {seed}")
                for key in ("mode", "kind", "mean_S", "impacts"):
                    self.assertEqual(found[key], alone[key], (flags, key))

    def refused(self, arguments, *mentions):
        result = run(f"{arguments} -o {self.folder}/a.h5")
        self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), (arguments, result.stderr))
        for mention in mentions:
            self.assertIn(mention, result.stderr, arguments)
        self.assertFalse((self.folder / "a.h5").exists())


class Lists(Grids):
    def test_numbers_rise_and_sides_may_be_a_disk(self):
        file = self.folder / "a.h5"
        fixed = scene_without("sides", "mu")
        cells = document(f"sweep {fixed} {SHORT} --grid sides=3,8,disk --grid mu=0.5,0.1 -o {file}")["cells"]
        self.assertEqual([cell["parameters"] for cell in cells],
                         [{"sides": sides, "mu": mu} for sides in (3, 8, "disk") for mu in (0.1, 0.5)])
        self.check_runs(cells, fixed)
        with xarray.open_dataset(file, group="sweep", engine="h5netcdf") as record:
            self.assertEqual(list(record["sides"].values), ["3", "8", "disk"])
            self.assertEqual(record["mu"].values.tolist(), [0.1, 0.5])

    def test_sides_without_a_disk_are_numbers(self):
        file = self.folder / "a.h5"
        cells = document(f"sweep {scene_without('sides')} {SHORT} --grid sides=8,3 -o {file}")["cells"]
        self.assertEqual([cell["parameters"]["sides"] for cell in cells], [3, 8])
        with xarray.open_dataset(file, group="sweep", engine="h5netcdf") as record:
            self.assertEqual(record["sides"].values.tolist(), [3, 8])

    def test_logarithms_are_the_numbers_that_a_user_writes(self):
        cells = document(f"sweep {scene_without('mu')} {SHORT} --grid mu=0.001:1:4:log")["cells"]
        self.assertEqual([cell["parameters"]["mu"] for cell in cells], [0.001, 0.01, 0.1, 1])
        cells = document(f"sweep {scene_without('mu')} {SHORT} --grid mu=2:1:3:log")["cells"]
        self.assertEqual([cell["parameters"]["mu"] for cell in cells], [2, math.sqrt(2), 1])
        fine = document(f"sweep {scene_without('mu')} {SHORT} --grid mu=0.01:1:2:log --refine 1")["cells"]
        self.assertLessEqual({cell["parameters"]["mu"] for cell in fine}, {0.01, 0.1, 1})

    def test_columns_of_a_diagram(self):
        flags = f"{scene_without('mu')} --transient 200 --collisions 100 --starts 1"
        for along, values in (("mu=0.5,0.1,0.3", [0.1, 0.3, 0.5]), ("mu=0.01:1:3:log", [0.01, 0.1, 1])):
            columns = document(f"bifurcate {flags} --along {along}")["columns"]
            self.assertEqual([column["parameter"] for column in columns], values)
        self.refused(f"bifurcate {flags} --along mu=0.1,0.1", "twice")
        self.refused(f"bifurcate {flags} --along mu=0:1:3:log", "above 0")

    def test_a_sample_takes_each_of_a_list_equally_often(self):
        cells = document(f"sweep {scene_without('sides', 'mu')} {SHORT} --grid sides=3,disk --grid mu=0.01:1:log --sample latin:8")["cells"]
        sides = [cell["parameters"]["sides"] for cell in cells]
        self.assertEqual((sides.count(3), sides.count("disk")), (4, 4))
        # a Latin hypercube has one point in each eighth of the axis, here of log mu
        self.assertEqual(sorted(int(8 * (math.log10(cell["parameters"]["mu"]) + 2) / 2) for cell in cells), list(range(8)))

    def test_refusals(self):
        for grid, mention in (("mu=0.1,0.1", "twice"), ("mu=0.1,x", "x"), ("mu=0.1,", "(empty)"), ("mu=0.1,nan", "finite"),
                              ("sides=3,1", "2 to"), ("sides=3,diskk", "disk"), ("mu=0:1:3:log", "above 0"),
                              ("sides=3:12:3:log", "list"), ("mu=0.1:1:3:lin", "NAME=A:B:COUNT:log"), ("sides=0:3:4", "sides = 0"),
                              ("mu=0.1,0.2 --refine 1", "list"), ("law=poisson:newton:2", "law"), ("foo=1,2", "NAME")):
            name = grid.split("=")[0]
            self.refused(f"sweep {scene_without(name)} --grid {grid}", mention)


class Scenes(Grids):
    TABLE = "sides,alpha,mu,law,speed\n6,0.4,0.5,poisson,0.1\n# a comment\ndisk,0.3,0.1,newton,0.2\n3,0.4,0.5,stronge,0.1\n"
    REST = "--beta 0.5 --restitution 0.9"

    def test_each_row_is_a_scene(self):
        table, file = self.file("t.csv", self.TABLE), self.folder / "a.h5"
        sweep = f"sweep {self.REST} {SHORT} --scenes {table} --runs 2"
        cells = document(f"{sweep} -o {file}")["cells"]
        self.assertEqual([tuple(cell["parameters"].values()) for cell in cells],
                         [(6, 0.4, 0.5, "poisson", 0.1), ("disk", 0.3, 0.1, "newton", 0.2), (3, 0.4, 0.5, "stronge", 0.1)])
        self.check_runs(cells, self.REST)
        shown = run(sweep).stdout.splitlines()
        self.assertEqual(shown[0].split()[:5], ["sides", "alpha", "mu", "law", "speed"])
        self.assertEqual([line.split()[0] for line in shown[1:4]], ["6", "disk", "3"])
        draw(file)
        for i in (1, 2):
            self.assertEqual(run(f"{sweep} --shard {i}/2 -o {self.folder}/{i}.h5 --quiet").returncode, 0)
        self.assertEqual(run(f"join {self.folder}/1.h5 {self.folder}/2.h5 -o {self.folder}/j.h5 --quiet").returncode, 0)
        self.assertEqual((self.folder / "j.h5").read_bytes(), file.read_bytes())

    def test_another_table_is_another_sweep(self):
        table, file = self.file("t.csv", self.TABLE), self.folder / "b.h5"
        self.assertEqual(run(f"sweep {self.REST} {SHORT} --scenes {table} -o {file} --quiet").returncode, 0)
        table.write_text(self.TABLE.replace("0.3", "0.31"))
        result = run(f"sweep {self.REST} {SHORT} --scenes {table} -o {file}")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1), result.stderr)

    def test_refusals(self):
        for text, mentions in (("sides,foo\n6,1\n", ("line 1", "foo")), ("mu,mu\n1,1\n", ("line 1", "twice")), ("mu\n", ("no scene",)),
                               ("mu\n0.1\nx\n", ("line 3", "x")), ("mu,alpha\n0.1\n", ("line 2", "cells")),
                               ("mu,alpha\n0.1,\n", ("line 2", "alpha is empty")), ("mu\n0.1\n-1\n", ("scene 2", "-1"))):
            table = self.file("t.csv", text)
            self.refused(f"sweep {SCENE} --scenes {table}", *mentions)
        table = self.file("t.csv", "mu\n0.1\n")
        for flag in ("--grid beta=0.1:0.2:2", "--sample sobol:3", "--refine 1", "--track", "--saddles 2"):
            self.refused(f"sweep {SCENE} --scenes {table} {flag}", flag.split()[0][2:])
        self.refused(f"sweep {SCENE} --scenes {self.folder}/none.csv", "none.csv")


class MoreRuns(Grids):
    GRID = f"{SHORT} --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.3:0.5:3 --grid beta=0.3:0.7:3"

    def both(self, flags, few, many):
        grown, whole = self.folder / "grown.h5", self.folder / "whole.h5"
        for runs, file in ((few, grown), (many, whole), (many, grown)):
            self.assertEqual(run(f"sweep {self.GRID} {flags} --runs {runs} -o {file} --quiet").returncode, 0)
        self.assertEqual(grown.read_bytes(), whole.read_bytes())
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["grown.h5", "whole.h5"])
        return grown

    def test_a_record_of_few_runs_grows_to_the_one_made_at_once(self):
        grown = self.both("", 1, 3)
        before = grown.read_bytes()
        fewer = run(f"sweep {self.GRID} --runs 2 -o {grown}")
        self.assertEqual((fewer.returncode, fewer.stderr.count("\n")), (2, 1))
        self.assertIn("runs = 3", fewer.stderr)
        self.assertIn("runs = 2", fewer.stderr)
        self.assertEqual(grown.read_bytes(), before)

    def test_so_do_a_refined_one_and_a_shard(self):
        for flags in ("--refine 1", "--shard 2/3"):
            grown = self.both(flags, 1, 2)
            for path in (grown, self.folder / "whole.h5"):
                path.unlink()

    def test_the_old_record_stays_until_the_new_one_is_whole(self):
        file, whole = self.folder / "a.h5", self.folder / "whole.h5"
        longer = self.GRID.replace("--transient 200 --collisions 200", "--transient 1000 --collisions 1000 --exhaustive") + " --quiet"
        self.assertEqual(run(f"sweep {longer} --runs 1 -o {file}").returncode, 0)
        before = file.read_bytes()
        process = start(f"sweep {longer} --runs 2000 --threads 1 -o {file}")
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
        self.assertEqual((process.wait(60), file.read_bytes() == before), (130, True))
        self.assertTrue((self.folder / ".a.h5.journal").exists())
        self.assertEqual(run(f"sweep {longer} --runs 4 -o {whole}").returncode, 0)
        self.assertEqual(run(f"sweep {longer} --runs 4 -o {file}").returncode, 2)  # an unfinished one of 2000 lies beside
        (self.folder / ".a.h5.journal").unlink()
        self.assertEqual(run(f"sweep {longer} --runs 4 -o {file}").returncode, 0)
        self.assertEqual(whole.read_bytes(), file.read_bytes())


class Shown(Grids):
    """What a person reads, against the document."""
    LETTERS = {"steady": "S", "quasi-steady": "Q", "chaotic": "C", "undecided": "?"}

    def test_a_map_has_the_figures_axes(self):
        sweep = f"sweep {SHORT} --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.7:6 --grid beta=0.9:0.1:5"
        letters = {tuple(cell["parameters"].values()): self.LETTERS[max(cell["modes"], key=cell["modes"].get)]
                   for cell in document(sweep)["cells"]}
        lines = run(sweep).stdout.splitlines()
        self.assertTrue(all(len(line) <= 100 for line in lines))
        self.assertEqual(lines[1], "beta")
        rows = [line.split("|") for line in lines[2:7]]
        betas = [float(label) for label, _ in rows]
        self.assertEqual(betas, [0.9, 0.7, 0.5, 0.3, 0.1])  # upwards
        alphas = [float(word) for word in lines[8].split()[:-1]]
        self.assertEqual((alphas, lines[8].split()[-1]), ([0.2, 0.3, 0.4, 0.5, 0.6, 0.7], "alpha"))
        for beta, (_, row) in zip(betas, rows):
            self.assertEqual(row.split(), [letters[alpha, beta] for alpha in alphas])
        for label in alphas:  # each value ends beneath its column's letter
            text = f"{label:g}"
            self.assertNotEqual(lines[2][lines[8].index(text) + len(text) - 1], " ")

    def test_a_wide_map_has_the_values_that_fit(self):
        lines = run(f"sweep {SHORT} --sides 6 --restitution 0.95 --alpha 0.4 --grid beta=0.3:0.7:41 --grid mu=0.1:0.2:2").stdout.splitlines()
        self.assertEqual(len(lines[2].split("|")[1]), 41)
        ticks = [match.start() for match in re.finditer(r"\S+", lines[5])][:-1]
        self.assertEqual([0.3 + 0.01 * (at - lines[2].index("|") - 1) for at in ticks][0], 0.3)
        for at, word in zip(ticks, lines[5].split()):
            self.assertAlmostEqual(float(word), 0.3 + 0.01 * (at - lines[2].index("|") - 1), delta=1e-9)
            self.assertEqual(lines[4][at], "+")

    def test_one_parameter_is_a_table(self):
        sweep = f"sweep {SHORT} {scene_without('mu')} --grid mu=0.5,0.1,0.3 --runs 3"
        cells = document(sweep)["cells"]
        lines = run(sweep).stdout.splitlines()
        self.assertEqual(lines[0].split()[0], "mu")
        for line, cell in zip(lines[1:], cells):
            words = line.replace("%", "").split()
            self.assertEqual(float(words[0]), cell["parameters"]["mu"])
            for word, mode in zip(words[1:5], self.LETTERS):
                self.assertAlmostEqual(float(word), 100 * cell["modes"].get(mode, 0), delta=0.005)
            if cell["mean_S"] is not None:  # with as many digits as its error leaves, one where none is known
                said = re.search(r"(about )?(-?[\d.]+)( \+- [\d.]+)?$", line)
                digits = cell["mean_S_error"] if said[3] else 0.5 * abs(cell["mean_S"]) if said[1] else 1e-6
                self.assertAlmostEqual(float(said[2]), cell["mean_S"], delta=digits)

    #: At mu = 0.15 three of four runs leave chaos for the wall, S = 1, in these impacts; none at 0.25.
    ESCAPES = "--sides 6 --alpha 0.3 --beta 0.5 --restitution 0.9 --transient 1500 --collisions 500"

    def test_a_mean_over_different_modes_is_marked(self):
        sweep = f"sweep {self.ESCAPES} --grid mu=0.15,0.25 --runs 4"
        cells = document(sweep)["cells"]
        self.assertEqual([len(cell["attractors"]) for cell in cells], [2, 1])
        text = run(sweep).stdout
        marked, plain = text.splitlines()[1:3]
        self.assertRegex(marked, r" \* -?[\d.]+ \+- [\d.]+$")
        self.assertRegex(plain, r" -?[\d.]+ \+- [\d.]+$")
        self.assertNotIn("*", plain)
        self.assertIn("\n  * the mean of runs that came to different S", text)
        alone = run(sweep.replace("0.15,", "")).stdout
        self.assertNotIn("*", alone)

    def test_chaos_is_said_of_the_impacts_that_were_followed(self):
        sweep = f"sweep {self.ESCAPES} --grid mu=0.15,0.25 --runs 4"
        runs = [one for cell in document(sweep)["cells"] for one in cell["runs"] if one["impacts"] > 1000]
        stayed = [one["impacts"] - 1000 for one in runs if one["kind"] == "chaotic"]
        left = [one["impacts"] - 1000 for one in runs if one["outcome"] == "in-contact"]
        self.assertEqual(len(runs), len(stayed) + len(left))  # a torus would count as neither
        self.assertGreater(len(left), 0)
        said = self.chaos_in(run(sweep).stdout)
        self.assertEqual((int(said["runs"]), int(said["left"])), (len(runs), len(left)))
        self.assertAlmostEqual(float(said["all"]), sum(stayed + left), delta=0.005 * sum(stayed + left))  # three digits
        self.assertAlmostEqual(float(said["half"]), math.log(2) * sum(stayed + left) / len(left), delta=0.005 * float(said["half"]))
        diagram = self.chaos_in(run(f"bifurcate {self.ESCAPES} --along mu=0.15,0.25 --starts 4").stdout)
        self.assertGreaterEqual(int(diagram["runs"]), int(diagram["left"]) + 4)  # those at mu = 0.25 stay
        short = run(f"sweep {self.ESCAPES} --grid mu=0.25,0.3 --transient 100 --collisions 100".replace("--transient 1500 --collisions 500 ", ""))
        self.assertIn("chaos was followed for 201 impacts a run, at most: too few to say how long it lasts", short.stdout)
        self.assertNotIn("chaos:", run("sweep --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --grid restitution=0.9,0.91").stdout)

    def test_chaos_that_no_run_leaves_has_a_bound(self):
        said = run("bifurcate --sides 6 --alpha 0.3 --beta 0.5 --restitution 0.95 --along mu=0.5,0.51 --starts 2").stdout
        words = " ".join(said.split())
        seen = re.search(r"chaos: 4 runs were in it after 1000 impacts, for ([\d.e+]+) more in all; none of these has left: half-life "
                         r"above ([\d.e+]+) impacts \(95 %\)", words)
        self.assertIsNotNone(seen, words)
        self.assertAlmostEqual(float(seen[2]), math.log(2) * float(seen[1]) / 3, delta=0.01 * float(seen[2]))

    def chaos_in(self, text):
        self.assertLessEqual(max(map(len, text.splitlines())), 100)
        seen = re.search(r"chaos: (?P<runs>\d+) runs were in it after 1000 impacts, for (?P<all>[\d.e+]+) more in all; (?P<left>\d+) of "
                         r"these ha(s|ve) left: half-life (?P<half>[\d.e+]+) impacts \(95 %: .* to .*\), on the mean of all runs of cells with a chaotic one, and if "
                         r"what came late .*; a run is called chaotic for the (?P<most>\d+) impacts", " ".join(text.split()))
        self.assertIsNotNone(seen, text)
        return seen

    def test_a_figure_has_logarithmic_axes_and_names(self):
        file = self.folder / "a.h5"
        self.assertEqual(run(f"sweep {SHORT} {scene_without('mu', 'sides')} --grid mu=0.01:1:3:log --grid sides=3,disk -o {file} --quiet").returncode, 0)
        axes = draw(file).axes[0]
        self.assertEqual((axes.get_xscale(), axes.get_yscale()), ("log", "linear"))
        self.assertEqual([label.get_text() for label in axes.get_yticklabels()], ["3", "disk"])
        low, high = axes.get_xlim()  # cells reach half a step, of a decade, beyond
        self.assertAlmostEqual(math.log10(low), -2.5, delta=1e-9)
        self.assertAlmostEqual(math.log10(high), 0.5, delta=1e-9)


class Starts(Grids):
    FILE = "[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\n[start]\n"

    def test_a_scene_file_has_a_start(self):
        for text, flags in (("vx = 0.3\nangle = 0.1\n", "--vx 0.3 --angle 0.1"), ("seed = 7\nspeed = 0.2\n", "--seed 7 --speed 0.2"),
                            ("point = [-0.0829, 0.028, -0.5552, 0.8908, -0.9783]\n", "--point=-0.0829,0.028,-0.5552,0.8908,-0.9783"),
                            ('point = "-0.0829,0.028,-0.5552,0.8908,-0.9783"\n', "--point=-0.0829,0.028,-0.5552,0.8908,-0.9783")):
            scene = self.file("s.toml", self.FILE + text)
            for command in ("simulate --collisions 5", f"classify {SHORT}"):
                self.assertEqual(document(f"{command} --scene {scene}"), document(f"{command} {SCENE} {flags}"))
        document(f"describe --scene {scene}")  # has no start, and needs none

    def test_flags_win(self):
        scene = self.file("s.toml", self.FILE + "vx = 0.3\nangle = 0.1\n")
        for flags, same in (("--vx 0.2", "--vx 0.2 --angle 0.1"), ("--seed 3", "--seed 3")):
            self.assertEqual(document(f"simulate --collisions 5 --scene {scene} {flags}"),
                             document(f"simulate --collisions 5 {SCENE} {same}"))

    def test_refusals(self):
        for text, mention in (("vz = 1\n", "vz"), ("vx = 1e-400\n", "1e-400"), ("seed = -1\n", "-1"), ("vx = 0.1\nseed = 2\n", "two ways"),
                              ("vx = [1]\n", "vx"), ("vx = true\n", "vx"), ("[other]\na = 1\n", "other")):
            scene = self.file("s.toml", self.FILE + text)
            self.refused(f"simulate --scene {scene}", "s.toml" if "e-400" not in text and "seed = -1" not in text else "", mention)


class Progress(Grids):
    LONG = "--sides 6 --alpha 0.3 --beta 0.1 --restitution 1 --grid mu=0.1:0.2:20000 --transient 300 --collisions 300 --exhaustive"

    def test_where_there_is_no_terminal_an_estimate_is_said_unless_quiet(self):
        """After three seconds, which the processes spend stopped: the estimate is by the clock."""
        says, quiet = (start(f"sweep {self.LONG} --threads 1 {flags}", stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)
                       for flags in ("", "--quiet"))
        for seconds, then in ((0.7, signal.SIGSTOP), (2.8, signal.SIGCONT)):
            time.sleep(seconds)
            for process in (says, quiet):
                process.send_signal(then)
        line = says.stderr.readline()
        for process in (says, quiet):
            process.send_signal(signal.SIGINT)
        self.assertEqual(quiet.communicate(timeout=60)[1], "")
        says.communicate(timeout=60)
        self.assertRegex(line, r"^swirl: sweep: \S+ % done in \d+ s, about \d[\d.]* (s|min|h) to go\n")

    def test_an_interrupted_diagram_says_what_is_kept(self):
        process = start(f"bifurcate {SCENE} --along beta=0.45:0.55:5000 --starts 1 -o {self.folder}/a.h5", stderr=subprocess.PIPE,
                        stdout=subprocess.DEVNULL, text=True)
        time.sleep(0.7)
        process.send_signal(signal.SIGINT)
        error = process.communicate(timeout=60)[1]
        self.assertEqual(process.returncode, 130)
        self.assertRegex(error, rf"^swirl: interrupted; [1-9]\d* of 5000 columns are whole, and what is done is in '{self.folder}/a.h5'\n$")


if __name__ == "__main__":
    unittest.main()
