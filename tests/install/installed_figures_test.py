"""An installed swirl draws with what was installed beside it: installed_figures_test.py PREFIX"""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PREFIX = Path(sys.argv.pop(1)).resolve()
SWIRL = PREFIX / "bin/swirl"
SCENE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9".split()


class InstalledFigures(unittest.TestCase):
    def test_the_script_is_the_installed_one_and_draws(self):
        with tempfile.TemporaryDirectory() as folder:
            record, figure = Path(folder) / "orbit.h5", Path(folder) / "orbit.png"
            subprocess.run([SWIRL, "simulate", *SCENE, "--quiet", "-o", record], check=True, timeout=60)
            command = [SWIRL, "plot", record, "-o", figure]
            echo = {**os.environ, "SWIRL_PYTHON": "/bin/echo"}  # an interpreter that only says what it is to run
            told = subprocess.run(command, env=echo, capture_output=True, text=True, check=True, timeout=60)
            self.assertIn(str(PREFIX / "share/swirl/notebooks-export/plot_record.py"), told.stdout)
            subprocess.run(command, check=True, timeout=60)
            self.assertTrue(figure.read_bytes().startswith(b"\x89PNG"))


if __name__ == "__main__":
    unittest.main()
