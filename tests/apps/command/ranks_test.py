"""A sweep over several processes: ranks_test.py SWIRL MPIEXEC

Open MPI's launcher; other launchers start ranks with other flags.
"""

import os
import signal
import subprocess
import sys
import time
import unittest

from driving import SWIRL, InFolder, run

MPIEXEC = sys.argv.pop(1)
GRID = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:5 --grid beta=0.1:0.9:4 --runs 3 --transient 500 "
        "--collisions 500 --threads 1")
TREE = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.8:4 --grid beta=0.1:0.9:4 --refine 1 --transient 500 "
        "--collisions 500 --threads 1")
#: Minutes of one core, to be killed.
LONG = ("sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:9 --grid beta=0.1:0.9:9 --runs 4 --threads 1 "
        "--exhaustive --transient 2000 --collisions 2000 --quiet")


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
            for ranks in (2, 3):
                path = self.folder / f"{name}-{ranks}.h5"
                result = over(ranks, f"{sweep} --quiet -o {path}")
                self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""))
                self.assertEqual(path.read_bytes(), alone.read_bytes(), (name, ranks))

    def test_one_rank_answers(self):
        alone, together = run(GRID), over(3, GRID)
        self.assertEqual(together.returncode, 0, together.stderr)
        self.assertEqual(together.stdout, alone.stdout)
        self.assertEqual(len(together.stderr.splitlines()), 1)  # the seconds that it took

    def test_killed_it_goes_on_with_other_ranks(self):
        path, whole = self.folder / "killed.h5", self.folder / "whole.h5"
        self.assertEqual(run(f"{LONG} -o {whole}").returncode, 0)
        for ranks, victim, sent in ((2, 1, signal.SIGKILL), (3, 0, signal.SIGKILL), (2, 0, signal.SIGINT)):
            launcher = subprocess.Popen(launched(ranks, f"{LONG} -o {path}"), stdout=subprocess.DEVNULL,
                                        stderr=subprocess.DEVNULL)
            time.sleep(2.5)
            started = ranks_of(launcher.pid)
            if launcher.poll() is None and len(started) == ranks:
                os.kill(started[victim], sent)
            launcher.wait(60)
        self.assertEqual(run(f"{LONG} -o {path}").returncode, 0)
        self.assertEqual(path.read_bytes(), whole.read_bytes())
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["killed.h5", "whole.h5"])


class Wrong(InFolder):
    def test_bad_input_is_said_once(self):
        result = over(2, GRID.replace("alpha=0.2:0.6:5", "alpha=0.2:1.6:5"))
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        said = [line for line in result.stderr.splitlines() if line.startswith("swirl: ")]
        self.assertEqual(len(said), 1, result.stderr)
        self.assertIn("alpha", said[0])

    def test_other_commands_are_refused(self):
        result = over(2, "classify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("swirl: classify is one process, and 2 were started together", result.stderr)

    def test_help_is_no_matter_of_ranks(self):
        self.assertIn("--grid", over(1, "sweep --help").stdout)


if __name__ == "__main__":
    unittest.main()
