"""One version everywhere: version_test.py ROOT SWIRL"""

import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT, SWIRL = Path(sys.argv.pop(1)), Path(sys.argv.pop(1))


class Version(unittest.TestCase):
    def test_is_that_of_the_packages(self):
        packages = re.match(r"swirl \(([0-9.]+)\) ", (ROOT / "debian/changelog").read_text())[1]
        program = subprocess.run([SWIRL, "--version"], capture_output=True, text=True, check=True, timeout=60).stdout
        self.assertIn(packages, program.split())
        self.assertEqual(re.search(r"^version: (\S+)$", (ROOT / "CITATION.cff").read_text(), re.M)[1], packages)
        self.assertRegex((ROOT / "CHANGELOG.md").read_text(), rf"(?m)^## (Unreleased: )?{re.escape(packages)}$")


if __name__ == "__main__":
    unittest.main()
