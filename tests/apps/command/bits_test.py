"""Equal bits from every compiler and version of the libraries: bits_test.py SWIRL REFERENCES [--print]

SHA-256 of what a fixed set of commands answers, against REFERENCES/bits.json. --print: prints that file anew."""

import hashlib
import json
import platform
import sys
import unittest
from pathlib import Path

PRINT = "--print" in sys.argv and not sys.argv.remove("--print")
REFERENCES = Path(sys.argv.pop(2)) / "bits.json"

from driving import run

CHAOS = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
STATE = ("t x y vx vy angle spin vertex psi chi vn vt flight_time impulse_normal impulse_tangential contact_mode jacobi").split()
CYCLE = ("period", "points", "return_time", "multipliers", "residual")


def _rows(document, key, columns):
    return [[row[column] for column in columns] for row in document[key]]


#: command -> what is compared of its document. All in one lane and in several: the same bits.
COMMANDS = {
    f"simulate {CHAOS} --collisions 20000": lambda found: _rows(found, "collisions", STATE),
    "simulate --sides 7 --alpha 0.35 --beta 0.8 --mu 0.2 --restitution 0.6 --law stronge --collisions 2000":
        lambda found: _rows(found, "collisions", STATE),
    f"lyapunov {CHAOS} --collisions 20000": lambda found: [found["exponents"], found["exponents_per_time"]],
    "orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --period 1 --max-time 20": lambda found: _rows(found, "orbits", CYCLE),
    "sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.2:0.6:3 --grid beta=0.3:0.9:3 --runs 4 --transient 500 "
    "--collisions 500": lambda found: _rows(found, "cells", ("parameters", "mean_S")),
}


def digests():
    found = {}
    for command, chosen in COMMANDS.items():
        result = run(f"{command} --json --quiet")
        assert result.returncode == 0, (command, result.stderr)
        found[command] = hashlib.sha256(json.dumps(chosen(json.loads(result.stdout))).encode()).hexdigest()
    return found


@unittest.skipUnless(platform.machine() == "x86_64", f"the digests are of x86-64; this is {platform.machine()}")
class Bits(unittest.TestCase):
    def test_are_those_of_other_compilers_and_libraries(self):
        self.assertEqual(digests(), json.loads(REFERENCES.read_text())["x86_64"])


if __name__ == "__main__":
    if PRINT:
        print(json.dumps({"about": "SHA-256 of what tests/apps/command/bits_test.py compares: bits_test.py SWIRL . --print",
                          "x86_64": digests()}, indent=1))
    else:
        unittest.main()
