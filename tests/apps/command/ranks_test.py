"""A sweep over several processes: ranks_test.py SWIRL MPIEXEC [--all]

Open MPI's launcher; other launchers start ranks with other flags. --all: also what half a minute must pass for, and more of each kind.
"""

import os
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from driving import SWIRL, InFolder, run

ALL = "--all" in sys.argv and not sys.argv.remove("--all")
MPIEXEC = sys.argv.pop(1)
SHORT = "--transient 300 --collisions 300 --threads 1"
GRID = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:5 --grid beta=0.1:0.9:4 --runs 3 --transient 500 "
        "--collisions 500 --threads 1")
TREE = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.8:4 --grid beta=0.1:0.9:4 --refine 1 --transient 500 "
        "--collisions 500 --threads 1")
# All ranks are on this machine. Open MPI 5 writes to standard error where TCP finds no interface but the loopback.
os.environ["OMPI_MCA_btl"] = "^tcp"
#: Cycles and chaos; random starts of columns, orbits that are followed from column to column, branches.
RUNS = "classify --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 --runs 20 --collisions 1000 --threads 1"
DIAGRAM = ("bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.36:0.42:7 --starts 3 --transient 500 "
           "--follow --branches --threads 1")
#: Chaos that is called before the limits, after a sample.
AT_RISK = f"{GRID.replace('alpha=0.2:0.6:5', 'alpha=0.1:0.2:5').replace('--runs 3', '--runs 8')} --risk 0.15"
#: Seconds of one core, of some hundred runs, to be killed.
LONG = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:9 --runs 4 --threads 1 "
        "--exhaustive --transient 1000 --collisions 2000 --quiet")
#: Many quick runs, whose results come many at a time.
QUICK = ("sweep --sides disk --mu 0 --restitution 0.5 --grid alpha=0.2:0.3:40 --grid beta=0:0.1:40 --runs 40 --transient 0 "
         "--collisions 64 --threads 2 --speed 0 --quiet")


def launched(ranks, arguments, *flags):
    return [MPIEXEC, "--allow-run-as-root", "--oversubscribe", "--bind-to", "none", *flags, "-n", str(ranks), SWIRL,
            *arguments.split()]


def over(ranks, arguments, *flags, **options):
    return subprocess.run(launched(ranks, arguments, *flags), capture_output=True, text=True, timeout=300, **options)


def ranks_of(launcher):
    """The processes that a launcher has started, from rank 0 on."""
    found = {}
    for process in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{process}/environ", "rb") as file:
                environment = dict(line.split(b"=", 1) for line in file.read().split(b"\0") if b"=" in line)
            with open(f"/proc/{process}/stat", encoding="utf-8") as file:
                parent = int(file.read().rsplit(")", 1)[1].split()[1])
        except (OSError, ValueError):
            continue
        if parent == launcher and b"OMPI_COMM_WORLD_RANK" in environment:
            found[int(environment[b"OMPI_COMM_WORLD_RANK"])] = int(process)
    return [found[rank] for rank in sorted(found)]


class Ranks(InFolder):
    def test_records_are_the_bytes_of_one_process(self):
        for name, sweep in (("grid", GRID), ("tree", TREE)):
            alone = self.folder / f"{name}.h5"
            self.assertEqual(run(f"{sweep} --quiet -o {alone}").returncode, 0)
            for ranks in (2, 3) if ALL else (3,):
                path = self.folder / f"{name}-{ranks}.h5"
                result = over(ranks, f"{sweep} --quiet -o {path}")
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
                self.assertEqual(path.read_bytes(), alone.read_bytes(), (name, ranks))

    def test_runs_and_diagrams_are_those_of_one_process(self):
        for name, command in (("runs", RUNS), ("diagram", DIAGRAM), ("risk", AT_RISK)):
            alone = self.folder / f"{name}.h5"
            self.assertEqual(run(f"{command} --quiet -o {alone}").returncode, 0)
            path = self.folder / f"{name}-3.h5"
            result = over(3, f"{command} --json -o {path}")
            self.assertEqual((result.returncode, result.stdout), (0, run(f"{command} --json").stdout), result.stderr)
            self.assertEqual(path.read_bytes(), alone.read_bytes(), name)

    def test_one_rank_answers(self):
        alone, together = run(GRID), over(3, GRID)
        self.assertEqual(together.returncode, 0, together.stderr)
        self.assertEqual(together.stdout, alone.stdout)
        self.assertEqual(len(together.stderr.splitlines()), 1)  # the seconds that it took

    def grown(self, path, launcher):
        """Waits until runs are kept beside the record, and gives the ranks' processes."""
        journal, begin = lambda: sum(p.stat().st_size for p in self.folder.glob(f"*{path.name}*")), time.monotonic()
        first = 0
        while time.monotonic() - begin < 60 and launcher.poll() is None:
            first = first or journal()
            if first and journal() > first:
                return ranks_of(launcher.pid)
            time.sleep(0.02)
        self.fail("no run was kept within a minute, or all of them at once")

    def test_killed_it_goes_on_with_other_ranks(self):
        path, whole = self.folder / "killed.h5", self.folder / "whole.h5"
        self.assertEqual(run(f"{LONG} -o {whole}").returncode, 0)
        ends = ((3, 0, signal.SIGKILL), (2, 1, signal.SIGKILL), (2, 0, signal.SIGINT))
        for ranks, victim, sent in ends if ALL else ends[:1]:
            launcher = subprocess.Popen(launched(ranks, f"{LONG} -o {path}"), stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
            started = self.grown(path, launcher)
            self.assertEqual(len(started), ranks)
            os.kill(started[victim], sent)
            self.assertNotEqual(launcher.wait(60), 0)
            self.assertFalse(path.exists())
        self.assertEqual(run(f"{LONG} -o {path}").returncode, 0)
        self.assertEqual(path.read_bytes(), whole.read_bytes())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["killed.h5", "whole.h5"])

    @unittest.skipUnless(ALL, "half a minute goes by until a silent rank is taken for lost: with --all")
    def test_where_the_launcher_lets_the_others_live_they_go_on(self):
        path, whole = self.folder / "lost.h5", self.folder / "whole.h5"
        self.assertEqual(run(f"{LONG} -o {whole}").returncode, 0)
        launcher = subprocess.Popen(launched(3, f"{LONG} -o {path}", "--enable-recovery"), stdout=subprocess.DEVNULL,
                                    stderr=subprocess.DEVNULL)
        os.kill(self.grown(path, launcher)[2], signal.SIGKILL)
        launcher.wait(120)
        self.assertEqual(path.read_bytes(), whole.read_bytes())

    def test_an_error_of_rank_0_ends_all(self):
        launcher = subprocess.Popen(launched(3, f"{QUICK} -o {self.folder / 'full.h5'}"), stdout=subprocess.PIPE,
                                    stderr=subprocess.PIPE, text=True)
        resource.prlimit(self.grown(self.folder / "full.h5", launcher)[0], resource.RLIMIT_FSIZE, (1000, 1000))
        output, errors = launcher.communicate(timeout=60)
        self.assertEqual((launcher.returncode, output), (4, ""), errors)
        self.assertEqual(len([line for line in errors.splitlines() if line.startswith("swirl: ")]), 1, errors)


class Wrong(InFolder):
    def test_bad_input_is_said_once(self):
        for wrong in (GRID.replace("alpha=0.2:0.6:5", "alpha=0.2:1.6:5"), RUNS.replace("--alpha 0.635", "--alpha 1.6"),
                      DIAGRAM.replace("alpha=0.36:0.42:7", "alpha=0.36:1.6:7")):
            result = over(2, wrong)
            self.assertEqual((result.returncode, result.stdout), (2, ""), wrong)
            said = [line for line in result.stderr.splitlines() if line.startswith("swirl: ")]
            self.assertEqual(len(said), 1, result.stderr)
            self.assertIn("alpha", said[0])

    def ranks_with(self, scenes):
        """A rank for each scene, in a folder with that scene's file. (Each goes there by itself: mpiexec of Open MPI 5.0.7
        ends without a word when it is given more than one program.)"""
        for number, scene in enumerate(scenes):
            folder = self.folder / str(number)
            folder.mkdir()
            if scene is not None:
                (folder / "scene.toml").write_text(scene)
        words = f"sweep --scene scene.toml --grid beta=0.1:0.9:5 --runs 2 {SHORT} --json".split()
        there = 'cd "$0/$OMPI_COMM_WORLD_RANK" && exec "$@"'
        command = [*launched(len(scenes), "")[:-1], "sh", "-c", there, str(self.folder), SWIRL, *words]
        return subprocess.run(command, capture_output=True, text=True, timeout=300)

    def test_a_rank_with_other_files_takes_no_part_and_is_told_of(self):
        scene = "[scene]\nsides = 6\nalpha = 0.4\nmu = 0.5\nrestitution = 0.9\n"
        alone = self.ranks_with([scene])
        self.assertEqual(alone.returncode, 0, alone.stderr)
        with tempfile.TemporaryDirectory() as folder:
            self.folder = Path(folder)
            found = self.ranks_with([scene, scene.replace("mu = 0.5", "mu = 0.1"), None])
        self.assertEqual((found.returncode, found.stdout), (0, alone.stdout), found.stderr)
        said = sorted(line for line in found.stderr.splitlines() if line.startswith("swirl: rank"))
        self.assertEqual(len(said), 2, found.stderr)
        self.assertIn("rank 1 takes no part", said[0])
        self.assertIn("other work", said[0])
        self.assertIn("rank 2 takes no part", said[1])
        self.assertIn("scene.toml", said[1])

    def test_a_launcher_of_another_mpi_is_named(self):
        result = run(GRID, env={**os.environ, "PMI_SIZE": "2", "PMI_RANK": "0"})
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("2 processes were started together", result.stderr)

    def test_help_is_no_matter_of_ranks(self):
        self.assertIn("--grid", over(1, "sweep --help").stdout)


class Library(InFolder):
    """All of MPI is in a library that is loaded where a launcher has started several."""

    def test_the_program_itself_is_linked_with_none_of_it(self):
        needed = subprocess.run(["ldd", SWIRL], capture_output=True, text=True, check=True).stdout
        self.assertIn("libfftw3", needed)
        self.assertNotIn("mpi", needed)

    def test_where_it_is_missing_or_none_that_is_said(self):
        program, library = self.folder / "swirl", self.folder / "swirl_mpi.so"
        shutil.copy(SWIRL, program)
        for content, reason in ((None, "this build of swirl has no MPI"), ("no library", "MPI can't be loaded: ")):
            if content:
                library.write_text(content)
            result = subprocess.run([program, *GRID.split(), "-o", self.folder / "a.h5"], capture_output=True, text=True,
                                    env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2"}, timeout=60)
            self.assertEqual((result.returncode, result.stdout), (2, ""), reason)
            self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
            self.assertIn(reason, result.stderr)
            self.assertFalse((self.folder / "a.h5").exists())


if __name__ == "__main__":
    unittest.main()
