"""swirl lyapunov, from outside: lyapunov_command_test.py SWIRL REFERENCES"""

import json
import math
import sys
import tempfile
import unittest
from pathlib import Path

import xarray

from driving import document, run, sized

REFERENCES = Path(sys.argv.pop(1))


class Lyapunov(unittest.TestCase):
    def test_cycles_have_the_logarithms_of_their_multipliers(self):
        largest = 0
        for case in json.loads((REFERENCES / "cycles.json").read_text())["cycles"][::sized(1, 4)]:
            flags = " ".join(f"--{k} {case[k]}" for k in ("sides", "alpha", "beta", "mu", "restitution", "law"))
            point = ",".join(case["point"][k] for k in ("psi", "chi", "vn", "vt", "S"))
            found = document(f"lyapunov {flags} --point={point} --transient 1000 --collisions 20000")
            moduli = sorted((math.hypot(*m) for m in case["multipliers"]), reverse=True)
            for exponent, modulus in zip(found["exponents"], moduli):
                if modulus < 1e-12:
                    self.assertIsNone(exponent, flags)
                else:
                    self.assertIsNotNone(exponent, (flags, modulus))
                    error = abs(exponent - math.log(modulus) / case["period"])
                    largest = max(largest, error)
                    self.assertLess(error, 1e-6, (flags, modulus))
        print(f"largest error of an exponent {largest:.1e}")

    def test_without_friction_and_loss_exponents_pair_to_zero(self):
        for sides in sized(("3", "6", "1000", "disk"), ("6", "disk")):
            found = document(f"lyapunov --sides {sides} --alpha 0.3 --beta 0.5 --mu 0 --restitution 1 "
                             "--collisions 20000")
            exponents, errors = found["exponents"], found["standard_errors"]
            # Time reversal pairs them; both growths are of one orbit, so they differ by what is bounded: 1/n each.
            for a, b in zip(exponents, reversed(exponents)):
                self.assertLess(abs(a + b), 1e-3, (sides, exponents, errors))
            self.assertLess(abs(found["result"]["sum"]), 1e-3)
            self.assertTrue(any("J is conserved" in n["reason"] for n in found["neutral"]), sides)
            self.assertLess(found["result"]["jacobi_residual"], 1e-9, sides)

    def test_regimes(self):
        fixed = document("lyapunov --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9")
        self.assertTrue(fixed["exponents"][0] < -0.04)
        self.assertAlmostEqual(fixed["exponents"][0], math.log(math.hypot(0.603654650944, 0.745364501151)), delta=1e-6)
        family = document("lyapunov --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 20000")
        self.assertEqual(family["signs"][0], "neutral")
        chaotic = document("lyapunov --sides 6 --alpha 0.3 --beta 0.1 --mu 0 --restitution 1 --collisions 20000")
        self.assertEqual(chaotic["signs"][0], "positive")

    def test_an_orbit_that_ends_is_told_with_exit_3(self):
        ended = document("lyapunov --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9", 3)
        self.assertEqual(ended["outcome"], "in-contact")
        none = document("lyapunov --sides 6 --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.9 --x 0.1", 3)
        self.assertEqual((none["outcome"], none["exponents"]), ("no-contact", []))
        for found in (ended, none):
            for key in ("exponents", "exponents_per_time", "standard_errors", "standard_errors_per_time",
                        "plain_means", "weighted_means", "signs"):
                self.assertEqual(found[key], [], key)
            self.assertIsNone(found["result"]["sum"])

    def test_bad_input(self):
        scene = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
        for flags in ("--collisions 0", "--collisions -3", "--transient -1", "--accuracy half", "--collisions nan",
                      "--bogus"):
            result = run(f"lyapunov {scene} {flags}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                             result.stderr)

    def test_equal_work_gives_equal_records_that_open_in_xarray(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder) / name for name in ("a.h5", "b.h5")]
            for file in files:
                run(f"lyapunov --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --collisions 1000 -o {file}")
            self.assertEqual(files[0].read_bytes(), files[1].read_bytes())
            with xarray.open_dataset(files[0], group="lyapunov", engine="h5netcdf") as opened:
                self.assertEqual(opened["exponents"].sizes, {"exponent": 5})
                self.assertEqual(opened["convergence"].dims, ("checkpoint", "exponent"))


if __name__ == "__main__":
    unittest.main()
