"""An installed swirl finds the library by which its ranks talk: installed_ranks_test.py PREFIX"""

import os
import subprocess
import sys
import unittest
from pathlib import Path

SWIRL = Path(sys.argv.pop(1)).resolve() / "bin/swirl"


class InstalledRanks(unittest.TestCase):
    def test_mpi_is_loaded_and_asked_where_others_were_started(self):
        # No launcher has done so: MPI is what says that this is one of one.
        command = [SWIRL, *"sweep --sides disk --mu 0 --restitution 0.5 --grid alpha=0.2:0.3:2 --collisions 64".split()]
        result = subprocess.run(command, env={**os.environ, "OMPI_COMM_WORLD_SIZE": "2"}, capture_output=True, text=True,
                                timeout=60)
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("the MPI of this build of swirl sees 1", result.stderr)


if __name__ == "__main__":
    unittest.main()
