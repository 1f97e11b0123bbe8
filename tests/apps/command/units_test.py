"""Physical units: flags, tables and records have them, documents are dimensionless: units_test.py SWIRL"""

import unittest

import xarray

from driving import SEARCH, InFolder, document, run

# Powers of two, so that the conversions are exact and the orbits the same to the bit.
LENGTH, RATE, MASS = 2.0, 4.0, 8.0
PHYSICAL = (f"--sides 6 --container-radius {LENGTH} --polygon-radius 0.8 --swirl-radius 1 --swirl-rate {RATE} "
            f"--mass {MASS} --mu 0.5 --restitution 0.9")
PLAIN = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"


class Flags(unittest.TestCase):
    def test_a_start_is_in_the_users_units(self):
        speed = LENGTH * RATE
        for ours, plain in (
                (f"--x {0.45 * LENGTH} --y {0.1 * LENGTH} --vx {0.1 * speed} --vy {-0.2 * speed} --angle 0.3 "
                 f"--spin {0.5 * RATE}", "--x 0.45 --y 0.1 --vx 0.1 --vy -0.2 --angle 0.3 --spin 0.5"),
                (f"--speed {0.25 * speed} --seed 3", "--speed 0.25 --seed 3"),
                ("--seed 3", "--seed 3"),  # 1/7 R_c omega_s
                (f"--point=-0.0625,0.03125,{-0.5 * speed},{0.875 * speed},{-RATE}",
                 "--point=-0.0625,0.03125,-0.5,0.875,-1")):
            found, expected = (document(f"simulate {scene} --collisions 50")
                               for scene in (f"{PHYSICAL} {ours}", f"{PLAIN} {plain}"))
            self.assertEqual(found.pop("units"), {"length": LENGTH, "time": 1 / RATE, "mass": MASS})
            self.assertEqual(found, expected, ours)

    def test_every_command_with_a_start_takes_it_so(self):
        flags = "--transient 100 --collisions 100 --quiet"
        start = f"--speed {0.25 * LENGTH * RATE} --seed 3"
        for command, kept in (("classify", "mean_S"), ("lyapunov", "exponents"), ("recurrence", "RC"),
                              ("spectrum", "variance"), ("sweep --grid mu=0.5:0.5:1", "cells"),
                              ("bifurcate --along mu=0.5:0.6:2 --starts 1", "columns")):
            found = document(f"{command} {PHYSICAL} {start} {flags}")
            self.assertEqual(found[kept], document(f"{command} {PLAIN} --speed 0.25 --seed 3 {flags}")[kept], command)

    def test_help_says_unit_and_default(self):
        text = " ".join(run("simulate --help").stdout.split())
        for said in ("in your own units where the scene has --container-radius or --swirl-rate",
                     "velocity, in R_c omega_s (default 0)", "in R_c omega_s (default 1/7 R_c omega_s)",
                     "in radians (default 0)"):
            self.assertIn(said, text)

    def test_bad_units_are_refused_whatever_is_written(self):
        for flag, value in (("container-radius", "-1"), ("swirl-rate", "0"), ("mass", "nan"), ("swirl-rate", "-2")):
            for command in ("simulate", "classify", "lyapunov", "orbits --period 1", "describe"):
                result = run(f"{command} {PLAIN} --{flag}={value}")
                self.assertEqual((result.returncode, result.stdout), (2, ""), (command, flag))
                self.assertIn(f"{flag} = {value}", result.stderr)


class Tables(unittest.TestCase):
    def test_simulate(self):
        ours, plain = (run(f"simulate {scene} --collisions 20").stdout.splitlines() for scene in (PHYSICAL, PLAIN))
        self.assertEqual(ours[0].split(), plain[0].split())
        names = plain[0].split()[:-1]  # but for the mode
        scale = {"impact": 1, "vertex": 1, "psi": 1, "chi": 1, "t": 1 / RATE, "vn": LENGTH * RATE, "vt": LENGTH * RATE,
                 "S": RATE, "p": MASS * LENGTH * RATE, "q": MASS * LENGTH * RATE, "J": MASS * LENGTH**2 * RATE**2}
        self.assertEqual(set(names), set(scale))
        for a, b in zip(ours[1:21], plain[1:21]):
            for name, x, y in zip(names, a.split(), b.split()):
                digits = 5e-3 * abs(float(x)) if "e" in x else 0  # 1.26e+02 has three
                self.assertAlmostEqual(float(x), float(y) * scale[name], delta=digits + 1e-6 * (1 + scale[name]),
                                       msg=name)
        self.assertIn("in your units: R_c = 2, 1/omega_s = 0.25, m = 8", ours)
        self.assertNotIn("units", "".join(plain))

    def test_classify(self):
        flags = "--transient 1000 --collisions 500"
        mean = document(f"classify {PLAIN} {flags}")["mean_S"]
        text = run(f"classify {PHYSICAL} {flags}").stdout
        self.assertIn(f"mean S {mean * RATE:.8g};", text)
        self.assertIn(f"{mean * RATE:.8g}", run(f"classify {PHYSICAL} {flags} --runs 1").stdout)


class Records(InFolder):
    def test_columns_say_what_they_are_in_the_users_units(self):
        record = self.folder / "o.h5"
        self.assertEqual(run(f"simulate {PHYSICAL} --collisions 20 --sample 0.5 --quiet -o {record}").returncode, 0)
        expected = {"t": 1 / RATE, "x": LENGTH, "vx": LENGTH * RATE, "spin": RATE, "impulse_normal": MASS * LENGTH * RATE,
                    "jacobi": MASS * LENGTH**2 * RATE**2, "psi": None, "vertex": None}
        with xarray.open_dataset(record, group="collisions", engine="h5netcdf") as data:
            for name, scale in expected.items():
                self.assertEqual(data[name].attrs.get("physical_scale"), scale, name)
            plain = document(f"simulate {PLAIN} --collisions 20")["collisions"]
            self.assertEqual(list(data["spin"].values), [impact["spin"] for impact in plain])  # dimensionless
        with xarray.open_dataset(record, group="units", engine="h5netcdf") as data:
            self.assertEqual(dict(data.attrs), {"length": LENGTH, "time": 1 / RATE, "mass": MASS})

    def test_every_command_that_writes_one(self):
        flags = "--transient 100 --collisions 100 --quiet"
        for command, group, column, scale in (
                ("classify --runs 2", "runs", "mean_S", RATE), ("sweep --grid mu=0.5:0.6:2", "sweep", "mean_S", RATE),
                ("spectrum", "spectrum", "frequency", RATE), ("orbits --period 1", "orbits", "return_time", 1 / RATE)):
            record = self.folder / "r.h5"
            more = f"{SEARCH} --quiet" if command.startswith("orbits") else flags
            self.assertEqual(run(f"{command} {PHYSICAL} {more} -o {record}").returncode, 0, command)
            with xarray.open_dataset(record, group=group, engine="h5netcdf") as data:
                self.assertEqual(data[column].attrs["physical_scale"], scale, command)
            record.unlink()

    def test_without_units_there_are_none(self):
        record = self.folder / "p.h5"
        self.assertEqual(run(f"simulate {PLAIN} --collisions 5 --quiet -o {record}").returncode, 0)
        with xarray.open_dataset(record, group="collisions", engine="h5netcdf") as data:
            self.assertNotIn("physical_scale", data["spin"].attrs)


if __name__ == "__main__":
    unittest.main()
