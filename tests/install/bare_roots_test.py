"""Both commands of the README in bare systems of Debian 12, 13 and unstable, from a clone alone: bare_roots_test.py ROOT

What is there at first is apt and what every system has. An hour and more of two cores. As root, with mmdebstrap and mount."""

import contextlib
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve()
#: The file that says how old it may be is past its date where a mirror of unstable is a snapshot.
ANY_DATE = 'Acquire::Check-Valid-Until "false";'


def told(*command):
    result = subprocess.run(command, capture_output=True, text=True, timeout=7200)
    assert result.returncode == 0, (command, result.stdout[-8000:], result.stderr[-8000:])
    return result.stdout


@contextlib.contextmanager
def bare(release):
    """A root with /proc, /sys and terminals, as in any system that runs: Open MPI looks into the first two, zsh's completion
    is tried on a terminal."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder) / release
        told("mmdebstrap", "--quiet", "--variant=apt", f"--aptopt={ANY_DATE}", release, root)
        shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")
        mounted = []
        try:
            for kind, place in (("proc", root / "proc"), ("sysfs", root / "sys"), ("devpts", root / "dev/pts")):
                told("mount", "-t", kind, kind, place)
                mounted.append(place)
            yield root
        finally:
            for place in mounted:
                told("umount", place)


@unittest.skipUnless(os.geteuid() == 0 and shutil.which("mmdebstrap") and shutil.which("mount"),
                     "a bare root needs root, mmdebstrap and mount: not tested")
class BareRoots(unittest.TestCase):
    def both_commands_pass(self, release):
        with bare(release) as root:
            told("git", "clone", "--quiet", "--no-hardlinks", ROOT, root / "root/swirl")
            for command in ("./quickstart", "./quickstart --test"):
                begin = time.monotonic()
                said = told("chroot", root, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL=C.UTF-8", "HOME=/root",
                            "bash", "-c", f"cd /root/swirl && {command}")
                print(f"{release}: {command}: {(time.monotonic() - begin) / 60:.1f} min")
            bits = "ctest --test-dir build/release --no-tests=error --output-on-failure -R '^command.bits_Nightly$'"
            told("chroot", root, "bash", "-c", f"cd /root/swirl && {bits}")
            tests = re.search(r"100% tests passed, 0 tests failed out of (\d+)", said)
            self.assertIsNotNone(tests, said[-8000:])
            self.assertGreater(int(tests[1]), 700)
            self.assertTrue((root / "root/swirl/swirl-diagram.png").read_bytes().startswith(b"\x89PNG"))

    def test_bookworm(self):
        self.both_commands_pass("bookworm")

    def test_trixie(self):
        self.both_commands_pass("trixie")

    def test_sid(self):
        self.both_commands_pass("sid")


if __name__ == "__main__":
    unittest.main()
