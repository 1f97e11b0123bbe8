"""What people read: short tables, numbers, and what a sweep says of its runs: tables_test.py SWIRL"""

import json
import re
import unittest

import xarray

from driving import SEARCH, InFolder, document, run

CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
CHAOS = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
ROLLING = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.5"
SHORT = "--transient 1000 --collisions 500"


class Classify(unittest.TestCase):
    def lines(self, arguments):
        result = run(arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout.splitlines()

    def test_a_verdict_says_what_was_found_and_why_and_what_would_change_it(self):
        for flags, mode, sure, because in (
                (CYCLE, "mode quasi-steady (cycle), period 8; mean S -0.44491411", "settled: the cycle attracts, slowest "
                 "multiplier 0.895", "after 8 impacts"),
                (CHAOS, "mode chaotic (chaotic)", "as far as it was followed: largest exponent 1.", "positive"),
                (ROLLING, "mode quasi-steady (rolling-librating)", "as far as it was followed: no impact for",
                 "psi settles on the pendulum"),  # whose mean S is named, though the periods still change
                ("--sides disk --alpha 0.4 --beta 0 --mu 0 --restitution 0", "after 1 impact", "no impact for",
                 "range of S 0: S is constant")):
            text = re.sub("\n    +", " ", run(f"classify {flags} {SHORT}").stdout)  # broken at 100 columns
            lines = text.splitlines()
            settled = lines[2].strip().startswith("settled")
            point = [line for line in lines if line.startswith(("  point ", "  to go on from it: "))]
            self.assertEqual(lines[len(lines) - len(point):], point, lines)  # a cycle's come last
            self.assertEqual(len(point), 2 if "cycle" in mode else 0, lines)
            self.assertEqual(len(lines) - len(point), 4 if settled else 5, lines)
            self.assertIn(mode, lines[1])
            self.assertIn(sure, lines[2])
            self.assertIn("because: ", lines[3])
            self.assertIn(because, lines[3])
            if not settled:  # nothing changes what is settled
                self.assertRegex(lines[4], "^  changes if: .{20}")

    def test_verbose_adds_all_of_the_evidence(self):
        short, long = (self.lines(f"classify {CYCLE} {SHORT} {flag}") for flag in ("", "--verbose"))
        *verdict, point, to_go_on = short  # the cycle's point comes last in both; it is broken after its head
        self.assertEqual(long[-2:], [point, to_go_on])
        self.assertEqual(long[:len(verdict) - 1], verdict[:-1])
        self.assertEqual(long[-3], verdict[-1])
        names = [piece["name"] for piece in document(f"classify {CYCLE} {SHORT}")["evidence"]]
        self.assertEqual([re.search("evidence: (.*?)  ", line)[1] for line in long if "evidence:" in line], names)

    def test_quiet_prints_nothing_anywhere(self):
        for command in (f"classify {CYCLE} {SHORT}", f"classify {CYCLE} {SHORT} --runs 2", "tour",
                        f"simulate {CYCLE}", f"describe {CYCLE}", f"lyapunov {CYCLE} {SHORT}",
                        f"orbits {CYCLE} --period 1 {SEARCH}", f"recurrence {CYCLE} {SHORT}", f"spectrum {CYCLE} {SHORT}",
                        f"sweep --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --grid alpha=0.3:0.4:2 {SHORT}",
                        f"bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --along alpha=0.3:0.4:2 {SHORT}"):
            result = run(command + " --quiet")
            self.assertEqual((result.returncode, result.stdout, result.stderr), (0, "", ""), command)

    def test_runs_show_the_multiplier_of_a_cycle_and_a_dash_for_what_is_not_there(self):
        found = document(f"classify {CYCLE} {SHORT} --runs 6 --quiet")
        attracting = [a for a in found["attractors"] if a["kind"] in ("cycle", "fixed-point")]
        self.assertTrue(attracting)
        for attractor in attracting:
            self.assertLess(attractor["ln_multiplier"], 0)
        rolling = run(f"classify {ROLLING} {SHORT} --runs 2")
        self.assertNotIn("nan", rolling.stdout)
        self.assertRegex(rolling.stdout, r"rolling-librating .* - .* - ")


class Tour(unittest.TestCase):
    def test_a_scene_is_a_line(self):
        result = run("tour")
        lines = result.stdout.splitlines()
        self.assertEqual([line.split()[0] for line in lines], list(json.loads(run("tour --json --quiet").stdout)))
        for line in lines:
            self.assertRegex(line, r"^[a-z-]+ +mode [a-z-]+ \(.*mean S +-?\d")


class Simulate(unittest.TestCase):
    def test_a_chatter_is_a_line(self):
        text = run(f"simulate {ROLLING} --collisions 100").stdout
        impacts = document(f"simulate {ROLLING} --collisions 100", code=3)["collisions"]
        said = re.findall(r"^ +chatter .* impacts (\d+) to (\d+) on 0: flights from ([\d.e+-]+) down to ([\d.e+-]+)$",
                          text, re.M)
        self.assertEqual(len(said), 1)
        first, last = int(said[0][0]), int(said[0][1])
        self.assertEqual(last, len(impacts))
        self.assertAlmostEqual(float(said[0][2]) / impacts[first - 1]["flight_time"], 1, delta=1e-2)
        self.assertAlmostEqual(float(said[0][3]) / impacts[last - 1]["flight_time"], 1, delta=1e-2)
        listed = [int(line.split()[0]) for line in text.splitlines() if re.match(r" +\d+ ", line)]
        self.assertEqual(listed, list(range(1, first)))

    def test_impacts_that_do_not_land_are_all_listed(self):
        text = run(f"simulate {CHAOS} --collisions 200").stdout
        self.assertEqual([int(line.split()[0]) for line in text.splitlines() if re.match(r" +\d+ ", line)],
                         list(range(1, 201)))


class Numbers(unittest.TestCase):
    def test_json_has_the_shortest_numbers_that_read_back(self):
        text = run(f"simulate {CHAOS} --collisions 300 --json").stdout
        numbers = re.findall(r"(?<=[:\[ ])-?\d[\d.e+-]*(?=[,\]}\s])", text)
        self.assertGreater(len(numbers), 4000)
        for number in numbers:
            significant = re.sub(r"e.*", "", number).lstrip("-").replace(".", "").lstrip("0").rstrip("0")
            shortest = re.sub(r"e.*", "", repr(float(number))).lstrip("-").replace(".", "").lstrip("0").rstrip("0")
            self.assertEqual(significant, shortest)
        self.assertIn('"alpha": 0.3,', text)


class Sweep(InFolder):
    def test_mean_per_impact_stands_beside_the_mean_per_time(self):
        base = "--sides 6 --beta 0.5 --mu 0.5 --restitution 0.95"
        cell = document(f"sweep {base} --grid alpha=0.635:0.635:1 {SHORT} --quiet")["cells"][0]
        verdict = document(f"classify {base} --alpha 0.635 {SHORT}")
        self.assertEqual(cell["mean_S_per_impact"], verdict["mean_S_per_impact"])
        self.assertEqual(cell["runs"][0]["mean_S_per_impact"], verdict["mean_S_per_impact"])
        self.assertGreater(abs(cell["mean_S_per_impact"] - cell["mean_S"]), 0.01)

    def test_the_grid_may_run_over_the_speed_of_the_starts(self):
        record = self.folder / "speeds.h5"
        cells = document(f"sweep {CYCLE} --grid speed=0.1:0.5:5 {SHORT} --quiet -o {record}")["cells"]
        with xarray.open_dataset(record, group="sweep", engine="h5netcdf") as data:
            self.assertEqual(data["speed"].attrs["units"], "R_c omega_s")
        for cell, speed in zip(cells, (0.1, 0.2, 0.3, 0.4, 0.5)):
            self.assertEqual(cell["parameters"], {"speed": speed})
            self.assertEqual(cell["mean_S"], document(f"classify {CYCLE} --speed {speed} {SHORT}")["mean_S"])
        result = run(f"sweep {CYCLE} --grid speed=-0.1:0.5:7")
        self.assertEqual((result.returncode, result.stdout), (2, ""))
        self.assertIn("speed = -0.1 is outside its range", result.stderr)

    def test_a_record_has_names_for_its_flags_and_is_read_again(self):
        record = self.folder / "s.h5"
        command = f"sweep --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --grid restitution=0.9:1:2 {SHORT} -o {record}"
        first = document(f"{command} --quiet")
        with xarray.open_dataset(record, group="sweep", engine="h5netcdf") as data:
            for name, values in (("mode", [c["runs"][0]["mode"] for c in first["cells"]]),
                                 ("kind", [c["runs"][0]["kind"] for c in first["cells"]]),
                                 ("outcome", [c["runs"][0]["outcome"] for c in first["cells"]])):
                flags = data[f"run_{name}"]
                meanings = flags.attrs["flag_meanings"].split()
                self.assertEqual([meanings[int(v)] for v in flags.values.ravel()], values)
            self.assertEqual(data["run_impacts"].dtype, "int64")
        self.assertEqual(document(f"{command} --quiet"), first)


class OtherInertia(InFolder):
    """A record of another kappa is another sweep's."""

    def refused(self, command, mention):
        result = run(command)
        self.assertEqual((result.returncode, result.stdout), (2, ""), result.stderr)
        self.assertIn(mention, result.stderr)

    def test_over_sides(self):
        record = self.folder / "s.h5"
        sweep = f"sweep --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --grid sides=4:8:5 {SHORT} --quiet -o {record}"
        self.assertEqual(run(sweep).returncode, 0)
        with xarray.open_dataset(record, group="settings", engine="h5netcdf") as settings:
            self.assertEqual(settings.attrs["inertia_factor"], "uniform")  # not that of N = 4
        self.refused(f"{sweep} --inertia-factor 0.3333", "inertia_factor")
        record.unlink()
        self.assertEqual(run(f"{sweep} --inertia-factor 0.3333").returncode, 0)
        with xarray.open_dataset(record, group="settings", engine="h5netcdf") as settings:
            self.assertEqual(settings.attrs["inertia_factor"], 0.3333)
        self.refused(sweep, "inertia_factor")
        self.assertEqual(run(f"{sweep} --inertia-factor 0.3333").returncode, 0)

    def test_over_kappa_itself(self):
        record = self.folder / "k.h5"
        sweep = (f"sweep --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --grid inertia-factor=0.2:0.4:2 "
                 f"{SHORT} --quiet -o {record}")
        self.assertEqual(run(sweep).returncode, 0)
        with xarray.open_dataset(record, group="settings", engine="h5netcdf") as settings:
            self.assertNotIn("inertia_factor", settings.attrs)


if __name__ == "__main__":
    unittest.main()
