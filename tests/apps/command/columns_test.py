"""What people read fits into 100 columns: helps, tables, verdicts: columns_test.py SWIRL"""

import re
import unittest

from driving import SEARCH, InFolder, examples_in, run

MOST = 100
HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DISK = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"
ROLLING = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.5"
CHAOS = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
TRANSIENT = "--sides 6 --alpha 0.5 --beta 0.54 --mu 0.5 --restitution 0.95"
PLANE = "--sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.5:0.6 --plane beta=0.3:0.4 --max-period 1 --lines 1"
SHORT = "--transient 100 --collisions 100"
COMMANDS = re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1], re.M)


class Columns(InFolder):
    def fits(self, text, what):
        self.assertTrue(text.strip(), what)
        wide = [line for line in text.splitlines() if len(line) > MOST]
        self.assertEqual(wide, [], what)

    def test_of_every_help(self):
        """An example that is broken is one for the shell."""
        self.assertGreaterEqual(len(COMMANDS), 20)
        broken = 0
        for command in ["", *COMMANDS]:
            with self.subTest(command=command):
                shown = run(f"{command} --help").stdout
                self.fits(shown, command)
                broken += shown.count("\\\n")
                for example in examples_in(shown):
                    self.assertNotIn("\\", example)
        self.assertGreater(broken, 0)

    def test_of_tables(self):
        for command in (f"simulate {HEXAGON} --collisions 40", f"simulate {CHAOS} --collisions 40", f"simulate {ROLLING} --collisions 100",
                        "simulate --sides 6 --alpha 0.4 --beta 0.5 --mu 0 --restitution 1 --collisions 40",
                        f"classify {HEXAGON} --verbose", f"classify {CHAOS} {SHORT} --verbose", f"classify {ROLLING} {SHORT} --verbose",
                        f"lyapunov {HEXAGON} {SHORT}", f"spectrum {HEXAGON} {SHORT}", f"recurrence {HEXAGON} {SHORT}",
                        f"orbits {HEXAGON} --max-period 2 {SEARCH}", f"orbits {DISK} --period 1", f"certify {HEXAGON} --all --max-time 2",
                        f"classify {TRANSIENT} --runs 8", f"tradeoff {CHAOS} --budget 0.2", f"tradeoff {HEXAGON} --budget 0.2",
                        f"boundaries {PLANE}", "ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.374:0.384 --rate 1e-5 --windows 4 --branches",
                        f"bifurcate {SHORT} --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.38:0.42:2 --branches",
                        f"describe {HEXAGON}", f"describe {DISK}", f"describe {ROLLING}",
                        f"continue {HEXAGON} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.38:0.42",
                        f"sweep {SHORT} --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --grid mu=0.1:1:4",
                        f"sweep {SHORT} {HEXAGON} --grid vx=-1:1:3 --grid vy=-1:1:3",
                        f"bifurcate {SHORT} --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --along mu=0.5:0.6:2 --starts 2"):
            with self.subTest(command=command):
                result = run(command)
                self.fits(result.stdout, command)
                self.fits(result.stderr + "-", command)


if __name__ == "__main__":
    unittest.main()
