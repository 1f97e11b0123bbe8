"""Physical units: flags, tables and records have them, documents are dimensionless: units_test.py SWIRL"""

import re
import unittest

import xarray

from driving import SEARCH, InFolder, document, run

# Powers of two, so that the conversions are exact and the orbits the same to the bit.
LENGTH, RATE, MASS = 2.0, 4.0, 8.0
PHYSICAL = (f"--sides 6 --container-radius {LENGTH} --polygon-radius 0.8 --swirl-radius 1 --swirl-rate {RATE} "
            f"--mass {MASS} --mu 0.5 --restitution 0.9")
PLAIN = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DISK = ("--sides disk --mu 0.5 --restitution {}", f" --container-radius {LENGTH} --swirl-rate {RATE} --mass {MASS}")
#: What a number in a unit that a table names is, over the same number where R_c = omega_s = m = 1.
SCALE = {"s": 1 / RATE, "m": LENGTH, "m/s": LENGTH * RATE, "rad/s": RATE, "1/s": RATE, "1/s^2": RATE**2, "rad": 1,
         "m^2": LENGTH**2, "m^2/s^2": (LENGTH * RATE) ** 2, "N s": MASS * LENGTH * RATE, "N": MASS * LENGTH * RATE**2, "J": MASS * (LENGTH * RATE) ** 2}
SPEED = LENGTH * RATE
NUMBER = re.compile(r"(?<![\w.^-])-?\d+(?:\.\d+)?(?:e[-+]\d+)?(?![\w./])")
UNIT = re.compile(r"[mun]?N s|\S+")


def places(line):
    """Where the units of a line of units end."""
    return {unit.end(): unit[0] for unit in UNIT.finditer(line)}


def is_units(line):
    return bool(line.strip()) and all(unit in SCALE for unit in places(line).values())


class Rate(unittest.TestCase):
    def test_it_is_said_in_turns_too(self):
        text = run(f"describe {PHYSICAL.replace(f'--swirl-rate {RATE}', '--swirl-rate 60')}").stdout
        self.assertIn(f"\nSI units: R_c = 2 m, omega_s = 60 rad/s ({60 / 6.283185307:.4g} Hz, {3600 / 6.283185307:.4g} rpm), m = 8 kg\n", text)


class Same(unittest.TestCase):
    """The tables of one scene, in SI units and dimensionless, number by number."""

    def digit(self, text):
        """One in the last digit that is shown."""
        mantissa, _, power = text.partition("e")
        return 10.0 ** (int(power or 0) - len(mantissa.partition(".")[2]))

    def same(self, ours, plain):
        """Every number of one table is that of the other in the unit that is named above or behind it. How many are
        not the same number."""
        found, expected = (run(command) for command in (ours, plain))
        self.assertEqual(found.returncode, expected.returncode, (ours, found.stderr))
        lines = [line for line in found.stdout.splitlines() if not line.startswith("SI units:")]
        units, rows, scaled, velocities = {}, "", 0, False
        others, last_line = iter(expected.stdout.splitlines()), ""
        for line in lines:
            if is_units(line):
                units = places(line)
                continue
            other = next(others)
            listed = re.match(r" +\d+  (?=-?\d\S*,)", line)  # a point psi,chi,vn,vt,S behind its number
            velocities = last_line.endswith("(vn and vt in m/s):") or (listed and velocities)
            last_line = line
            ordinate = re.fullmatch(r"\w+ \[(.*)\]", line)  # above a map whose rows are in this unit
            rows = ordinate[1] if ordinate else rows
            abscissa = re.search(r"\d +\w+ \[(.*)\]$", line)  # behind the values of the map's columns
            a, b = list(NUMBER.finditer(line)), list(NUMBER.finditer(other))
            self.assertEqual(len(a), len(b), (line, other))
            for k, (x, y) in enumerate(zip(a, b)):
                behind = re.match(r"\]? (N s|[A-Za-z/^\d]+)(?![\w-])", line[x.end():])
                before = re.findall(r"\[([^\]]*)\]", line[:x.start()])  # of an axis: vx [m/s] from -8 to 8
                unit = behind[1] if behind and behind[1] in SCALE else before[-1] if before else units.get(x.end(), "")
                if velocities:
                    unit = "m/s" if k - bool(listed) in (2, 3) else ""
                elif abscissa or re.match(r"\s*\S+ \|", line):
                    unit = abscissa[1] if abscissa else rows
                scale = SCALE.get(unit, 1)
                allowed = 0.51 * (self.digit(x[0]) + scale * self.digit(y[0]))
                self.assertLessEqual(abs(float(x[0]) - scale * float(y[0])), allowed, (ours, line, other, x[0], unit))
                scaled += scale != 1
        self.assertIsNone(next(others, None), ours)
        return scaled

    def test_every_number_of_every_table(self):
        short = "--transient 100 --collisions 100 --quiet".replace(" --quiet", "")
        for command, ours, plain, least in (
                ("simulate", f"--speed {0.25 * SPEED} --seed 3 --collisions 20", "--speed 0.25 --seed 3 --collisions 20", 120),
                ("simulate", f"--time {60 / RATE}", "--time 60", 100),
                ("classify", short, short, 0), ("classify --runs 3 --verbose", short, short, 0),
                ("lyapunov", short, short, 5), ("spectrum", short, short, 1),
                ("recurrence --observable vn", f"{short} --threshold {0.01 * SPEED}", f"{short} --threshold 0.01", 1),
                ("describe", f"--max-time {4 / RATE}", "--max-time 4", 5),
                (f"orbits --period 1 {SEARCH}", f"--max-time {4 / RATE}", "--max-time 4", 5),
                ("orbits --period 1", f"--near=-0.084,0.028,{-0.554 * SPEED},{0.89 * SPEED},-0.979",
                 "--near=-0.084,0.028,-0.554,0.89,-0.979", 1),
                ("continue --along alpha=0.39:0.41", f"--from=-0.084,0.028,{-0.554 * SPEED},{0.89 * SPEED},-0.979",
                 "--from=-0.084,0.028,-0.554,0.89,-0.979", 0),
                ("certify --all", f"--max-time {2 / RATE}", "--max-time 2", 1),
                (f"sweep {short}", f"--grid vx={-SPEED}:{SPEED}:2 --grid y=0:{0.1 * LENGTH}:2", "--grid vx=-1:1:2 --grid y=0:0.1:2", 4),
                (f"sweep --sample sobol:3 {short}", f"--grid speed=0:{SPEED}", "--grid speed=0:1", 0),
                (f"bifurcate --along mu=0.5:0.6:2 --starts 1 {short}", "", "", 0)):
            if command.startswith("continue"):  # over alpha, so that the length is R_c's
                physical = PHYSICAL.replace("--polygon-radius 0.8", "--alpha 0.4")
            else:
                physical = PHYSICAL
            with self.subTest(command=command, flags=plain):
                self.assertGreaterEqual(self.same(f"{command} {physical} {ours}", f"{command} {PLAIN} {plain}"), least)

    def test_a_disks_families(self):
        plain, units = DISK[0].format(1) + " --alpha 0.3 --beta 0.1", DISK[1]
        for command, ours, bare, least in (
                ("orbits --period 1", f"--pin tau={2.5 / RATE}", "--pin tau=2.5", 2),
                ("continue", f"--from=0,{-0.43056 * SPEED},{0.19151 * SPEED},-0.30504 --along tau={1 / RATE}:{3 / RATE}",
                 "--from=0,-0.43056,0.19151,-0.30504 --along tau=1:3", 2),
                ("describe", "", "", 2)):
            with self.subTest(command=command):
                self.assertGreaterEqual(self.same(f"{command} {plain}{units} {ours}", f"{command} {plain} {bare}"), least)
        rolling = DISK[0].format(0.5) + " --alpha 0.4 --beta 0.3"
        self.assertGreaterEqual(self.same(f"describe {rolling}{units}", f"describe {rolling}"), 3)

    def test_s_has_no_unit_and_every_column_names_its_own(self):
        head, units = run(f"simulate {PHYSICAL} --collisions 2").stdout.splitlines()[:2]
        named = {name: places(units).get(end, "") for end, name in places(head).items()}
        self.assertEqual(named, {"impact": "", "t": "s", "vertex": "", "psi": "rad", "chi": "rad", "vn": "m/s", "vt": "m/s",
                                 "S": "", "p": "N s", "q": "N s", "J": "J", "mode": ""})
        self.assertNotIn("rad", run(f"simulate {PLAIN} --collisions 2").stdout)

    def test_small_impulses_and_energies_have_a_prefix_and_two_digits(self):
        found = document(f"simulate {PLAIN} --collisions 40")["collisions"]
        for mass, prefix, factor in ((1 / 32, "m", 1e3), (1e-5, "u", 1e6)):  # R_c omega_s = 1 m/s
            lines = run(f"simulate {PLAIN} --container-radius 0.125 --swirl-rate 8 --mass {mass} --collisions 40").stdout.splitlines()
            heads, units, rows = places(lines[0]), places(lines[1]), [line for line in lines[2:] if re.match(r" +\d+ ", line)]
            ends = {name: end for end, name in heads.items()}
            self.assertEqual([units[ends[name]] for name in ("p", "q", "J")], [f"{prefix}N s", f"{prefix}N s", f"{prefix}J"])
            for row, impact in zip(rows, found, strict=True):
                for name, key in (("p", "impulse_normal"), ("q", "impulse_tangential"), ("J", "jacobi")):
                    exact = impact[key] * mass * factor
                    self.assertLessEqual(abs(float(row[:ends[name]].split()[-1]) - exact), 0.05 * abs(exact), (row, name))

    def test_curves_and_what_accuracy_costs(self):
        units = f" --container-radius {LENGTH} --swirl-rate {RATE} --mass {MASS}"
        plane = "boundaries --sides 6 --mu 0.5 --restitution 0.95 --plane alpha=0.5:0.6 --plane beta=0.3:0.4 --max-period 1 --lines 1"
        self.assertEqual(self.same(plane + units, plane), 0)  # ratios alone
        found, expected = (document(command) for command in (plane + units, plane))
        self.assertEqual(found.pop("units"), {"length": LENGTH, "time": 1 / RATE, "mass": MASS})
        self.assertEqual(found, expected)
        ours, plain = (document(f"tradeoff {scene} --budget 0.2") for scene in (PHYSICAL, PLAIN))
        self.assertEqual(ours["units"], {"length": LENGTH, "time": 1 / RATE, "mass": MASS})
        for row, other in zip(ours["rungs"], plain["rungs"], strict=True):
            if row["flights"] != other["flights"]:  # a slow machine leaves some out, and the document says so
                cut = min(((row, ours), (other, plain)), key=lambda pair: pair[0]["flights"] or 0)[1]
                self.assertTrue(cut["cut_short"], (row["name"], row["flights"], other["flights"]))
                continue
            self.assertEqual(row["missed_contacts"], other["missed_contacts"], row["name"])
            # Lengths in SI units are rounded, so that errors of one rounding are drawn anew: half or twice.
            for key in ("error", "error_of_ten"):
                self.assertTrue(row[key] == other[key] or 0.5 < row[key] / other[key] < 2, (row["name"], key, row[key], other[key]))
        lines = run(f"tradeoff {PHYSICAL} --budget 0.2").stdout.splitlines()
        head = next(i for i, line in enumerate(lines) if line.endswith("J drift"))
        self.assertEqual(places(lines[head + 1]), {len(lines[head]): "J"})


class Flags(unittest.TestCase):
    def test_a_start_is_in_the_users_units(self):
        for ours, plain in (
                (f"--x {0.45 * LENGTH} --y {0.1 * LENGTH} --vx {0.1 * SPEED} --vy {-0.2 * SPEED} --angle 0.3 "
                 f"--spin {0.5 * RATE}", "--x 0.45 --y 0.1 --vx 0.1 --vy -0.2 --angle 0.3 --spin 0.5"),
                (f"--speed {0.25 * SPEED} --seed 3", "--speed 0.25 --seed 3"),
                ("--seed 3", "--seed 3"),  # 1/7 R_c omega_s
                (f"--point=-0.0625,0.03125,{-0.5 * SPEED},{0.875 * SPEED},-1", "--point=-0.0625,0.03125,-0.5,0.875,-1")):
            found, expected = (document(f"simulate {scene} --collisions 50")
                               for scene in (f"{PHYSICAL} {ours}", f"{PLAIN} {plain}"))
            self.assertEqual(found.pop("units"), {"length": LENGTH, "time": 1 / RATE, "mass": MASS})
            self.assertEqual(found, expected, ours)

    def test_documents_are_without_units_whatever_was_given_in_them(self):
        point = f"-0.084,0.028,{-0.554 * SPEED!r},{0.89 * SPEED!r},-0.979"
        bare = "-0.084,0.028,-0.554,0.89,-0.979"
        for command, ours, plain in (
                ("simulate", f"--time {60 / RATE} --sample {0.5 / RATE}", "--time 60 --sample 0.5"),
                ("describe", f"--max-time {4 / RATE}", "--max-time 4"),
                ("orbits --period 1", f"--near={point}", f"--near={bare}"),
                ("certify", f"--near={point}", f"--near={bare}"),
                ("certify --all", f"--max-time {2 / RATE}", "--max-time 2"),
                ("recurrence --observable x --transient 100 --collisions 100", f"--threshold {0.5 * LENGTH}", "--threshold 0.5"),
                ("sweep --transient 100 --collisions 100 --quiet", f"--grid speed=0:{SPEED}:3", "--grid speed=0:1:3")):
            with self.subTest(command=command, flags=plain):
                found, expected = (document(line) for line in (f"{command} {PHYSICAL} {ours}", f"{command} {PLAIN} {plain}"))
                found.pop("units", None), found.pop("checksum", None), expected.pop("checksum", None)
                self.assertEqual(found, expected)

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
        for said in ("with any of these six all that you give and read is in m, s, kg", "velocity, in R_c omega_s (default 0)",
                     "in R_c omega_s (default 1/7 R_c omega_s)", "in radians (default 0)", "in SI units in rad/s"):
            self.assertIn(said, text)

    def test_bad_units_are_refused_whatever_is_written(self):
        for flag, value in (("container-radius", "-1"), ("swirl-rate", "0"), ("mass", "nan"), ("swirl-rate", "-2")):
            for command in ("simulate", "classify", "lyapunov", "orbits --period 1", "describe"):
                result = run(f"{command} {PLAIN} --{flag}={value}")
                self.assertEqual((result.returncode, result.stdout), (2, ""), (command, flag))
                self.assertIn(f"{flag} = {value}", result.stderr)


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
                ("sweep --grid vx=0:1:2", "sweep", "vx", LENGTH * RATE), ("simulate", "collisions", "spin", RATE),
                ("spectrum", "spectrum", "frequency", RATE), ("orbits --period 1", "orbits", "return_time", 1 / RATE)):
            record = self.folder / "r.h5"
            more = {"orb": f"{SEARCH} --quiet", "sim": "--collisions 20 --quiet"}.get(command[:3], flags)
            self.assertEqual(run(f"{command} {PHYSICAL} {more} -o {record}").returncode, 0, command)
            with xarray.open_dataset(record, group=group, engine="h5netcdf") as data:
                self.assertEqual(data[column].attrs["physical_scale"], scale, command)
                for ratio in {"mean_S", "S"} & set(data):
                    self.assertNotIn("physical_scale", data[ratio].attrs, command)
            record.unlink()

    def test_without_units_there_are_none(self):
        record = self.folder / "p.h5"
        self.assertEqual(run(f"simulate {PLAIN} --collisions 5 --quiet -o {record}").returncode, 0)
        with xarray.open_dataset(record, group="collisions", engine="h5netcdf") as data:
            self.assertNotIn("physical_scale", data["spin"].attrs)


if __name__ == "__main__":
    unittest.main()
