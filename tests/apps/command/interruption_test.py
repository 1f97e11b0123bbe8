"""SIGINT, SIGTERM, SIGHUP: every command ends with 130 within half a second and leaves no stray file (InHalfASecond); what
is finished is kept (Kept, beside other tests); BesideALibrary, of no sanitizer's build, is of signals that a library takes.
interruption_test.py SWIRL [InHalfASecond | Kept | BesideALibrary]"""

import json
import os
import re
import signal
import subprocess
import time
import unittest
from pathlib import Path

import h5py

from driving import SWIRL, InFolder, run, start

CHAOS = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
LONG = "--transient 1000000 --collisions 100000000"
IMPACTS = Path(__file__).resolve().parents[2] / "behaviour" / "inputs" / "impacts.csv"
POINT = "-0.0829,0.028,-0.5552,0.8908,-0.9783"

#: They take minutes.
COMMANDS = [
    f"simulate {CHAOS} --collisions 1000000000 --every 1000",
    f"simulate {CHAOS} --collisions 1000000000 --json",
    f"classify {CHAOS} {LONG}",
    f"classify {CHAOS} {LONG} --runs 50",
    f"recurrence {CHAOS} {LONG}",
    f"spectrum {CHAOS} {LONG}",
    f"lyapunov {CHAOS} {LONG}",
    f"orbits {CHAOS} --max-period 12 --starts 1000000",
    f"orbits {CHAOS} --period 3 --starts 10 --trajectories 1000 --collisions 1000000",
    f"continue {HEXAGON} --from={POINT} --along alpha=0.0001:0.99 --longest-step 1e-6",
    f"bifurcate {HEXAGON} --along beta=0.4:0.6:1000 --transient 100000",
    f"bifurcate {HEXAGON} --along beta=0.4:0.6:1000 --starts 0 --follow --transient 100000",
    f"ramp {HEXAGON} --along beta=0.4:0.6 --rate 1e-9",
    f"boundaries {HEXAGON} --plane alpha=0.1:0.9 --plane beta=0.05:1.05 --lines 2000",
    f"sweep {CHAOS} --grid mu=0.1:0.2:1000 {LONG}",
    f"tradeoff {CHAOS} --budget 1000",
    f"certify {HEXAGON} --all --period 1 --max-time 1000",
    f"fit --impacts {IMPACTS} --resamples 100000",
]


def wait_until_caught(process, number):
    """Until the process takes the signal: on a busy machine it takes long to start. At most a minute."""
    begin = time.monotonic()
    while process.poll() is None and time.monotonic() - begin < 60:
        caught = re.search(r"^SigCgt:\s*(\w+)", Path(f"/proc/{process.pid}/status").read_text(), re.M)
        if caught and int(caught[1], 16) >> (number - 1) & 1:
            return
        time.sleep(0.01)


class Ending(InFolder):
    def end(self, command, after, number=signal.SIGINT):
        """Exit code, seconds from the signal to the end, output and errors."""
        process = start(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, cwd=self.folder)
        reader = None
        if "--json" in command:  # what is printed meanwhile must be taken
            reader = subprocess.Popen(["cat"], stdin=process.stdout, stdout=subprocess.DEVNULL)
            process.stdout.close()
            process.stdout = None
        time.sleep(after)
        wait_until_caught(process, number)
        self.assertIsNone(process.poll(), f"{command} was over before it could be interrupted")
        begin = time.monotonic()
        process.send_signal(number)
        process.wait(60)
        seconds = time.monotonic() - begin
        _, errors = process.communicate()
        if reader:
            reader.wait(60)
        return process.returncode, seconds, errors

    def ends_by_itself(self, environment):
        """Under nohup, though SIGHUP comes once the record has been begun."""
        others = self.names()
        process = subprocess.Popen(["nohup", SWIRL, *f"simulate {CHAOS} --collisions 400000 --quiet -o a.h5".split()],
                                   cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, env=environment)
        # nohup has become swirl, and the signals are its own, once there is a file more.
        begin = time.monotonic()
        while self.names() == others and time.monotonic() - begin < 60:
            time.sleep(0.01)
        self.assertIsNone(process.poll(), "it was over before it could be interrupted")
        process.send_signal(signal.SIGHUP)
        self.assertEqual((process.wait(60), self.names()), (0, sorted([*others, "a.h5"])))

    def names(self):
        return sorted(path.name for path in self.folder.iterdir())


class InHalfASecond(Ending):
    """With nothing else on the machine."""

    def test_every_command_ends_within_half_a_second_and_leaves_no_stray_file(self):
        for command in COMMANDS:
            code, seconds, errors = self.end(f"{command} --quiet -o a.h5", 0.3)
            self.assertEqual((code, errors), (130, ""), command)
            self.assertLess(seconds, 0.5, command)
            self.assertLessEqual(set(self.names()), {"a.h5"}, command)
            for name in self.names():
                self.check_whole(self.folder / name, command.split()[0])
                (self.folder / name).unlink()

    def check_whole(self, path, command):
        if command == "certify":
            self.assertEqual(json.loads(path.read_text())["outcome"], "interrupted")
            return
        with h5py.File(path) as file:
            self.assertEqual(file.attrs["command"], command)

    def test_every_command_is_tried(self):
        listed = set(re.findall(r"^  ([a-z]+) ", run("--help").stdout, re.M))
        tried = {command.split()[0] for command in COMMANDS}
        # Over at once; what Python does, animate and notebook, has tests of its own.
        self.assertEqual(listed - tried, {"describe", "show", "plot", "tour", "join", "animate", "notebook", "inspect", "manual", "completion", "explore"})

    def test_signals_but_sigint(self):
        for number in (signal.SIGTERM, signal.SIGHUP):
            for command in (f"classify {CHAOS} {LONG}", f"sweep {CHAOS} --grid mu=0.1:0.2:1000 {LONG}"):
                code, seconds, _ = self.end(f"{command} -o a.h5", 0.3, number)
                self.assertEqual((code, self.names()), (130, []), (command, number))
                self.assertLess(seconds, 0.5)


#: A library that takes SIGHUP for itself as soon as it is loaded, as UCX of Open MPI 5 does.
TAKES_HANGUP = """#include <signal.h>
#include <unistd.h>
static void end(int number) { _exit(number); }
__attribute__((constructor)) static void take(void) { signal(SIGHUP, end); }
"""


class BesideALibrary(Ending):
    def test_nohup_is_heeded(self):
        source, library = self.folder / "takes.c", self.folder / "takes.so"
        source.write_text(TAKES_HANGUP)
        subprocess.run(["cc", "-shared", "-fPIC", "-o", library, source], check=True)
        for file in (source, self.folder / "a.h5"):
            file.unlink(missing_ok=True)
        self.ends_by_itself({**os.environ, "LD_PRELOAD": str(library)})


class Kept(Ending):
    def test_nohup_is_heeded(self):
        self.ends_by_itself(os.environ)

    def kept(self, command):
        """The record that is there when the command was interrupted after a second."""
        code, _, _ = self.end(f"{command} --quiet -o a.h5", 1)
        self.assertEqual(code, 130)
        file = h5py.File(self.folder / "a.h5")
        self.addCleanup(file.close)
        return file

    def test_the_finished_runs_of_several_are_kept_though_another_is_in_its_midst(self):
        file = self.kept(f"classify {HEXAGON} --transient 1000 --collisions 1000 --runs 100000")
        self.assertGreater(len(file["runs/seed"]), 2)
        self.assertEqual(file["runs"].attrs["wanted"], 100000)

    def test_the_finished_runs_of_several_are_in_the_document_too(self):
        process = subprocess.Popen([SWIRL, *f"classify {HEXAGON} --transient 1000 --collisions 1000 --runs 100000 "
                                    "--json --quiet".split()], stdout=subprocess.PIPE, text=True)
        time.sleep(1)
        process.send_signal(signal.SIGINT)
        found = json.loads(process.communicate(timeout=60)[0])
        self.assertEqual((process.returncode, found["outcome"]), (130, "interrupted"))
        self.assertGreater(len(found["runs"]), 2)

    def test_the_finished_columns_of_a_diagram_are_kept(self):
        file = self.kept(f"bifurcate {HEXAGON} --along beta=0.45:0.55:5000 --starts 1")
        self.assertGreater(len(file["samples/S"]), 2)

    def test_a_sweep_goes_on_from_every_run_that_had_ended(self):
        command = f"sweep {HEXAGON} --grid mu=0.3:0.6:20000 --transient 1000 --collisions 1000 --exhaustive -o a.h5".replace(
            "--mu 0.5 ", "")
        kept = []
        for _ in range(2):
            code, _, errors = self.end(command, 1)
            self.assertEqual((code, self.names()), (130, [".a.h5.journal"]), errors)
            kept.append(int(re.search(r"(\d+) of 20000 runs are kept", errors)[1]))
        self.assertGreater(kept[0], 0)
        self.assertGreater(kept[1], kept[0])


if __name__ == "__main__":
    unittest.main()
