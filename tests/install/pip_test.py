"""The module as pip installs it: an sdist, a wheel of that, and what is imported from it. pip_test.py ROOT VERSION

Without a network: --no-build-isolation takes scikit-build-core and pybind11 from the system (Debian 13 and newer, Ubuntu 24.04)."""

import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path

ROOT, VERSION = Path(sys.argv.pop(1)).resolve(), sys.argv.pop(1)

#: Of the README, with a record, its arrays and a figure: what lies in the package and what stands beside it.
USE = """
import sys, swirl
found = swirl.classify(swirl.Scene(sides=6, alpha=0.635, beta=0.5, mu=0.5, restitution=0.95))
assert (found.mode, found.period) == ("quasi-steady", 8), found
assert swirl.__version__ == sys.argv[1], swirl.__version__
orbit = swirl.simulate(swirl.Scene(6, 0.4, 0.5, 0.5, 0.9), collisions=20)
assert orbit.to_xarray().sizes["collision"] == 20
assert orbit.plot("spin").axes
print(swirl.__file__)
"""


#: Not in packages.txt: the rest needs neither.
HAS_TOOLS = subprocess.run([sys.executable, "-B", "-c", "import ensurepip, scikit_build_core"], capture_output=True).returncode == 0


@unittest.skipUnless(HAS_TOOLS, "scikit-build-core or venv is not there (Debian 13: python3-scikit-build-core, python3-venv)")
class PipNightly(unittest.TestCase):
    def done(self, command, **options):
        result = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=3000, **options)
        self.assertEqual(result.returncode, 0, result.stdout[-4000:] + result.stderr[-4000:])
        return result.stdout

    def test_an_sdist_builds_and_what_it_installs_runs(self):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            self.done([sys.executable, "-B", "-c", "import scikit_build_core.build as b; b.build_sdist('" + name + "')"], cwd=ROOT)
            sdist = folder / f"swirl-{VERSION}.tar.gz"
            with tarfile.open(sdist) as archive:
                names = {member.name.split("/", 1)[1] for member in archive if "/" in member.name}
            self.assertLessEqual({"CMakeLists.txt", "packages.txt", "map/collision_map.hpp", "apps/python/make_commands.py", "LICENSE"}, names)
            self.assertFalse([name for name in names if name.startswith(("build/", ".git/")) or name.endswith(".pyc")])
            self.done([sys.executable, "-m", "venv", "--system-site-packages", folder / "venv"])
            python = folder / "venv/bin/python"
            self.done([python, "-m", "pip", "install", "--no-index", "--no-build-isolation", "--no-deps", sdist])
            where = self.done([python, "-B", "-c", USE, VERSION], cwd=folder)
            self.assertIn(str(folder / "venv"), where)
            self.done([python, "-m", "pip", "uninstall", "--yes", "swirl"])
            self.assertFalse(Path(where.strip()).exists())


if __name__ == "__main__":
    unittest.main()
