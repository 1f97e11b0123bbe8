"""Drives the built `swirl` as a user does. The first argument of the script that imports this is the binary."""

import json
import os
import re
import shlex
import signal
import statistics
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

SWIRL = str(Path(sys.argv.pop(1)).resolve())
#: A sanitizer's build, some eight times slower, looks for bad memory in the same paths with fewer repeats.
SANITIZED = os.environ.get("SWIRL_SANITIZED") == "1"


def sized(full, fewer):
    return fewer if SANITIZED else full


#: What a search for cycles is given besides: nothing, or less to search.
SEARCH = sized("", "--starts 100 --trajectories 1 --collisions 200")


def _refuse(constant):
    raise ValueError(f"{constant} is no JSON")


def run(arguments, **options):
    words = shlex.split(arguments) if isinstance(arguments, str) else arguments
    return subprocess.run([SWIRL, *words], capture_output=True, text=True, timeout=300, **options)


def examples_of(command):
    """The examples of its help, each as one line without "swirl"."""
    return examples_in(run(f"{command} --help").stdout)


def examples_in(shown):
    """The examples of a help that was printed."""
    return re.findall(r"^\s*swirl (?!\w+  )(.*)$", re.sub(r" *\\\n *", " ", shown).split("Example")[-1], re.M)


def start(arguments, **options):
    """In the background, to be interrupted or killed."""
    return subprocess.Popen([SWIRL, *shlex.split(arguments)], **options)


def wait_until_it_listens(process, most=60):
    """Until it has a handler of its own for SIGINT: what takes long to start, as with sanitizers, is killed by one before."""
    end = time.monotonic() + most
    while time.monotonic() < end:
        caught = re.search(r"^SigCgt:\s*([0-9a-f]+)$", Path(f"/proc/{process.pid}/status").read_text(), re.M)
        if caught and int(caught[1], 16) >> (signal.SIGINT - 1) & 1:
            return
        time.sleep(0.005)
    raise AssertionError(f"{process.args}: no handler of SIGINT after {most} s")


def interrupted(arguments, seconds, wait=60):
    """The exit code of what gets SIGINT so many seconds after its start."""
    process = start(arguments)
    time.sleep(seconds)
    process.send_signal(signal.SIGINT)
    return process.wait(wait)


#: What a task that takes longer than 10 s says at times, where there is no terminal.
_PROGRESS = re.compile(r"^swirl: .* % done.* (to go|left)$")


def without_progress(errors):
    """The other lines of standard error."""
    return [line for line in errors.splitlines() if not _PROGRESS.match(line)]


def document(arguments, code=0, **options):
    """What it printed, as strict JSON; an answer comes without a word on standard error."""
    result = run(arguments + " --json", **options)
    words = without_progress(result.stderr)
    assert result.returncode == code and (code or not words), (arguments, result.returncode, result.stderr)
    return json.loads(result.stdout, parse_constant=_refuse)


def made_records(commands, folder, codes=(0,)):
    """The records of commands, {name: command}, as {name: path}. An orbit that ends leaves exit code 3."""
    records = {name: Path(folder) / f"{name}.h5" for name in commands}
    for name, command in commands.items():
        result = run(f"{command} --quiet -o {records[name]}")
        assert result.returncode in codes, (command, result.stderr)
    return records


def folder_of_module():
    """One that is there until all tests of the script are over."""
    temporary = tempfile.TemporaryDirectory()
    unittest.addModuleCleanup(temporary.cleanup)
    return Path(temporary.name)


def with_records(commands, codes=(0,)):
    """A base of tests that share `records`, those of these commands, in `folder`: made once for a module."""
    class WithRecords(unittest.TestCase):
        folder = None
        records = {}

        @classmethod
        def setUpClass(cls):
            if WithRecords.folder is None:
                WithRecords.folder = folder_of_module()
                WithRecords.records.update(made_records(commands, WithRecords.folder, codes))
                cls.add_records(WithRecords.folder)

        @classmethod
        def add_records(cls, folder):
            """Others, where a base of a module has more than commands make."""

    return WithRecords


#: 97.5 % quantiles of Student's distribution by degrees of freedom, from 1 on (Abramowitz & Stegun, Table 26.10).
STUDENT = (12.706, 4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131)


def error_over_runs(values):
    """Of their mean, such that ± 2 of it hold the mean at 95 %; to the table's four digits."""
    return STUDENT[len(values) - 2] / 1.960 * statistics.stdev(values) / len(values) ** 0.5


class InFolder(unittest.TestCase):
    """A test with a folder of its own."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def file(self, name, text):
        path = self.folder / name
        path.write_text(text)
        return path

    def series(self, name, values, times=None):
        rows = [f"{v!r}" if times is None else f"{times[i]!r},{v!r}" for i, v in enumerate(values)]
        return self.file(name, "\n".join((["S"] if times is None else ["t,S"]) + rows) + "\n")


class Refusing(InFolder):
    def refused(self, arguments, mention):
        result = run(f"{arguments} -o {self.folder}/a.h5")
        self.assertEqual((result.returncode, result.stdout), (2, ""), (arguments, result.stderr))
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class Keeping(InFolder):
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
        import xarray  # half a second that most tests need not wait

        return xarray.open_dataset(self.folder / "i.h5", group=group, engine="h5netcdf")
