"""The Debian packages: packages_test.py ROOT VERSION

They are made of the committed files, looked at, unpacked into an empty root, and installed into and removed from another. As
root; lintian is run where it is installed."""

import contextlib
import gzip
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT, VERSION = Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)
#: The file that says how old it may be is past its date where a mirror of unstable is a snapshot.
ANY_DATE = 'Acquire::Check-Valid-Until "false";'
FIGURES = "python3-swirl-figures"
MODULE = "python3-swirl"
NAMES = {"swirl", FIGURES, MODULE, "libswirl-dev"}


def told(*command, **options):
    result = subprocess.run(command, capture_output=True, text=True, timeout=3000, **options)
    assert result.returncode == 0, (command, result.stdout, result.stderr)
    return result.stdout


def field(package, name):
    return told("dpkg-deb", "-f", package, name).strip()


def files_below(root):
    return {str(path.relative_to(root)) for path in root.rglob("*") if not path.is_dir()}


@contextlib.contextmanager
def processes_seen_in(root):
    """/proc, as in any system that runs: by it a program finds what lies beside it."""
    told("mount", "-t", "proc", "proc", root / "proc")
    try:
        yield
    finally:
        told("umount", root / "proc")


class Packages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        source = cls.folder / "made" / "swirl"
        told("git", "clone", "--quiet", "--no-hardlinks", ROOT, source)
        # No packages of symbols: they would double the time.
        told("dpkg-buildpackage", "--build=binary", "--no-sign", cwd=source,
             env={**os.environ, "DEB_BUILD_OPTIONS": f"noautodbgsym parallel={os.cpu_count()}"})
        cls.packages = {field(path, "Package"): path for path in (cls.folder / "made").glob("*.deb")}

    def unpacked(self, name):
        root = self.folder / f"root-{name}"
        if not root.exists():
            told("dpkg-deb", "-x", self.packages[name], root)
        return root

    def test_what_they_are(self):
        self.assertEqual(set(self.packages), NAMES)
        for name, path in self.packages.items():
            self.assertEqual(field(path, "Version"), VERSION)
            self.assertEqual(field(path, "Architecture"), "all" if name == FIGURES else
                             told("dpkg", "--print-architecture").strip())
        needed = field(self.packages["swirl"], "Depends")
        for library in ("libc6", "libhdf5", "libfftw3", "libgsl", "libtbb", "libfmt"):
            self.assertRegex(needed, rf"(^|, ){library}", needed)
        self.assertNotIn("-dev", needed)
        self.assertIn("python3-matplotlib", field(self.packages[FIGURES], "Depends"))
        self.assertIn("libeigen3-dev", field(self.packages["libswirl-dev"], "Depends"))
        for package in ("python3-numpy", "python3 (<<", "libhdf5"):  # of the interpreter that it was compiled for
            self.assertIn(package, field(self.packages[MODULE], "Depends"))

    def test_what_is_in_them(self):
        program, figures, library = (files_below(self.unpacked(name)) for name in ("swirl", FIGURES, "libswirl-dev"))
        commands = re.findall(r"^  ([a-z]+) ", told(self.unpacked("swirl") / "usr/bin/swirl", "--help").split("Subcommands:")[1],
                              re.M)
        libraries = "usr/lib/" + told("dpkg-architecture", "-qDEB_HOST_MULTIARCH").strip()
        pages = {f"usr/share/man/man1/swirl-{command}.1.gz" for command in commands} | {"usr/share/man/man1/swirl.1.gz"}
        self.assertLessEqual(pages | {"usr/bin/swirl", "usr/share/bash-completion/completions/swirl",
                                      "usr/share/zsh/vendor-completions/_swirl", "usr/share/doc/swirl/tutorial.md"}, program)
        self.assertIn(f"{libraries}/swirl/swirl_mpi.so", program)
        self.assertIn("usr/share/swirl/notebooks-export/plot_record.py", figures)
        module = files_below(self.unpacked(MODULE))
        self.assertFalse([name for name in program | figures | library | module if "__pycache__" in name])
        self.assertEqual({name.rsplit("/", 1)[0] for name in module if not name.startswith("usr/share/doc")},
                         {"usr/lib/python3/dist-packages/swirl"})
        self.assertLessEqual({f"usr/lib/python3/dist-packages/swirl/{name}" for name in
                              ("__init__.py", "__init__.pyi", "_commands.py", "_places.py", "py.typed", "scene.pyi")}, module)
        self.assertFalse(module & (program | figures | library))
        self.assertLessEqual({f"{libraries}/libswirl_map.a", f"{libraries}/cmake/Swirl/SwirlConfig.cmake",
                              "usr/include/swirl/analysis/section_map.hpp"}, library)
        for name in NAMES:
            documents = self.unpacked(name) / "usr/share/doc" / name
            self.assertIn("Permission is hereby granted", (documents / "copyright").read_text())
            changes = gzip.decompress((documents / "changelog.gz").read_bytes()).decode()
            self.assertIn(VERSION, changes)
        self.assertFalse(program & figures | program & library | figures & library)

    def test_the_command_runs_from_an_empty_root(self):
        root = self.folder / "empty"
        for name in ("swirl", FIGURES):
            told("dpkg-deb", "-x", self.packages[name], root)
        swirl = root / "usr/bin/swirl"
        work = self.folder / "work"
        work.mkdir()
        self.assertIn("chaotic", told(swirl, "tour", "-o", "tour.h5", cwd=work))
        echo = {**os.environ, "SWIRL_PYTHON": "/bin/echo"}
        script = swirl.parents[1] / "share/swirl/notebooks-export/plot_record.py"
        self.assertIn(str(script), told(swirl, "plot", "tour.h5", "-o", "tour.png", cwd=work, env=echo))
        told(swirl, "plot", "tour.h5", "-o", "tour.png", cwd=work)
        self.assertTrue((work / "tour.png").read_bytes().startswith(b"\x89PNG"))

    @unittest.skipIf(os.geteuid() != 0, "dpkg installs as root only: installing and removing are not tested")
    def test_they_are_installed_and_removed_without_a_trace(self):
        root = self.folder / "system"
        for folder in ("var/lib/dpkg/info", "var/lib/dpkg/updates", "var/lib/dpkg/triggers", "var/log"):
            (root / folder).mkdir(parents=True)
        (root / "var/lib/dpkg/status").touch()
        before = files_below(root)
        # A root with nothing in it: what they depend on is not there either.
        dpkg = ("dpkg", f"--root={root}", "--force-depends", "--force-script-chrootless")
        told(*dpkg, "-i", *self.packages.values())
        self.assertIn("chaotic", told(root / "usr/bin/swirl", "tour"))
        self.assertEqual(told(*dpkg, "--verify"), "")
        told(*dpkg, "-r", *NAMES)
        left = {name for name in files_below(root) - before if not name.startswith("var/")}
        self.assertEqual(left, set())
        self.assertFalse((root / "usr/share/swirl").exists())

    @unittest.skipUnless(os.geteuid() == 0 and shutil.which("mmdebstrap") and shutil.which("mount"),
                         "a bare root needs root, mmdebstrap and mount: not tested")
    def test_with_nothing_else_present_they_work_and_go_without_a_trace(self):
        """In a system of apt alone what they depend on comes with them, and nothing that they do not name."""
        root = self.folder / "bare"
        # By apt's own lists: /etc/os-release of unstable names the release that is to come.
        release = min(told("apt-get", "indextargets", "--format", "$(CODENAME)").split(), key=len)
        told("mmdebstrap", "--quiet", "--variant=apt", f"--aptopt={ANY_DATE}", release, root)
        shutil.copy("/etc/resolv.conf", root / "etc/resolv.conf")
        (root / "packages").mkdir()
        installed = ("swirl", FIGURES, MODULE)
        for name in installed:
            shutil.copy(self.packages[name], root / "packages")
        with processes_seen_in(root):
            self.install_work_and_purge(root)
        own = set().union(*(files_below(self.unpacked(name)) for name in installed))
        self.assertEqual({name for name in own if (root / name).exists()}, set())
        elsewhere = ("packages/", "var/log/", "var/lib/apt/")
        left = {name for name in files_below(root) if "swirl" in name and not name.startswith(elsewhere)}
        self.assertEqual(left, set())

    def install_work_and_purge(self, root):
        def inside(*command):
            return told("chroot", root, "env", "-i", "PATH=/usr/sbin:/usr/bin:/sbin:/bin", "LC_ALL=C.UTF-8", "HOME=/root",
                        "DEBIAN_FRONTEND=noninteractive", *command)
        inside("apt-get", "update")
        inside("apt-get", "install", "--yes", "--no-install-recommends",
               *(f"/packages/{self.packages[name].name}" for name in ("swirl", FIGURES, MODULE)))
        present = set(inside("dpkg-query", "--show", "--showformat=${Package}\n").split())
        self.assertEqual(present & {"libswirl-dev", "python3-nbformat", "ffmpeg", "libhdf5-dev", "libtbb-dev"}, set())
        self.assertIn("chaotic", inside("swirl", "tour", "-o", "/root/tour.h5"))
        inside("swirl", "plot", "/root/tour.h5", "-o", "/root/tour.png")
        self.assertTrue((root / "root/tour.png").read_bytes().startswith(b"\x89PNG"))
        scene = "swirl.Scene(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95)"
        told_by_python = inside("python3", "-c", f"import swirl; print(swirl.classify({scene}))")
        self.assertIn("quasi-steady", told_by_python)
        self.assertIn("period 8", told_by_python)
        inside("python3", "-c", f"import swirl; swirl.simulate({scene}, collisions=50).plot().savefig('/root/orbit.png')")
        inside("apt-get", "purge", "--yes", "swirl", FIGURES, MODULE)

    @unittest.skipUnless(shutil.which("lintian"), "lintian is not installed: what it says is not tested")
    def test_lintian_finds_no_error(self):
        result = subprocess.run(["lintian", "--allow-root", "--fail-on", "error", *self.packages.values()],
                                capture_output=True, text=True, timeout=600)
        print(result.stdout, end="", file=sys.stderr)
        self.assertEqual(result.returncode, 0, result.stdout)


if __name__ == "__main__":
    unittest.main()
