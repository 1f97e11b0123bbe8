"""generate.py: it recomputes what lies here, and it notices what is wrong. A few entries; all of them at night."""

import copy
import json
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from mpmath import mp, mpc, mpf

import dragged
import dynamics
from row_lines import row_lines

HERE = Path(__file__).resolve().parent


def generate(*arguments):
    command = [sys.executable, "-B", str(HERE / "generate.py"), *map(str, arguments)]
    return subprocess.run(command, capture_output=True, text=True, timeout=300)


class Generator(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.file = Path(folder.name) / "changed.json"

    def check(self, document):
        self.file.write_text(json.dumps(document))
        return generate(self.file, "--check")

    def part(self, name, key, *numbers):
        document = json.loads((HERE / name).read_text())
        return {key: [document[key][n] for n in numbers]}

    def test_a_sample_of_each_file_is_recomputed(self):
        for name, count in (("trajectories.json", 2), ("dragged_trajectories.json", 2), ("tangential_trajectories.json", 2), ("rod_trajectories.json", 1), ("corner_trajectories.json", 1), ("dry_trajectories.json", 1), ("dry_contact.json", 1), ("dry_wall.json", 1), ("cycles.json", 1),
                            ("steady_e1.json", 1), ("fixed_points.json", 2)):
            result = generate(HERE / name, "--check", "--sample", count, "--seed", 5)
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            self.assertIn(f"{count} of ", result.stdout)

    def test_a_flight_over_a_floor_that_drags_solves_its_equations(self):
        """Its closed form against Taylor's method for V' = -gamma (V - V_floor), S' = -gamma_r S."""
        for kind in ("dish", "table"):
            scene = dynamics.Scene(3, mpf("0.4"), mpf("0.7"), 0, 1, "poisson", 1)
            floor = dragged.Floor(mpf("0.31"), mpf("0.13"), kind)
            start = dynamics.State(mpf("0.9"), mpc("0.2", "-0.1"), mpc("0.4", "0.8"), mpf("0.3"), mpf("-1.7"))

            def rates(t, y, carries=int(kind == "dish"), floor=floor, scene=scene):
                x, y_, vx, vy, _, spin = y
                wind = carries * 1j * dynamics.swirl(scene, t)
                return [vx, vy, -floor.drag * (vx - wind.real), -floor.drag * (vy - wind.imag), spin,
                        -floor.spin_drag * spin]

            first = [start.x.real, start.x.imag, start.v.real, start.v.imag, start.angle, start.spin]
            with mp.workdps(32):
                solved = mp.odefun(rates, start.t, first)(start.t + mpf("2.5"))
            end = dragged.moved(scene, floor, start, mpf("2.5"))
            for a, b in zip(solved, (end.x.real, end.x.imag, end.v.real, end.v.imag, end.angle, end.spin)):
                self.assertLess(abs(a - b), mpf(10) ** -28)

    def test_a_wrong_digit_is_noticed(self):
        def in_orbit(entry):
            row = entry["collisions"][-1]
            row["vx"] = row["vx"][:-2] + str((int(row["vx"][-2]) + 5) % 10) + row["vx"][-1]

        def in_vertex(entry):
            entry["collisions"][3]["vertex"] += 1

        def in_growth(entry):
            entry["collisions"][3]["amplification"] *= 1000

        def in_period(entry):
            entry["return_time"] = entry["return_time"][:-2] + "99"

        def in_multiplier(entry):
            entry["multipliers"][0][0] += 1e-14

        orbit, cycle = self.part("trajectories.json", "cases", 2), self.part("cycles.json", "cycles", 0)
        for document, key, changes in ((orbit, "cases", (in_orbit, in_vertex, in_growth)),
                                       (cycle, "cycles", (in_period, in_multiplier))):
            self.assertEqual(self.check(document).returncode, 0)
            for change in changes:
                changed = copy.deepcopy(document)
                change(changed[key][0])
                result = self.check(changed)
                self.assertEqual(result.returncode, 1, (change.__name__, result.stdout, result.stderr))

    def test_what_it_writes_it_confirms(self):
        self.file.write_text(json.dumps(self.part("cycles.json", "cycles", 0, 5)))
        written = self.file.with_name("written.json")
        self.assertEqual(generate(self.file, "-o", written).returncode, 0)
        self.assertEqual(generate(written, "--check").returncode, 0)

    def test_files_have_a_row_a_line(self):
        for file in HERE.glob("*.json"):
            text = file.read_text()
            if file.name != "bits.json":  # holds no rows
                self.assertEqual(row_lines(json.loads(text)) + "\n", text, file.name)

    def test_wrong_input_exits_with_2(self):
        for arguments in ((HERE / "none.json", "--check"), (HERE / "README.md", "--check"), (HERE / "cycles.json",),
                          (HERE / "cycles.json", "--check", "--sample", 21)):
            self.assertEqual(generate(*arguments).returncode, 2, arguments)


if __name__ == "__main__":
    unittest.main()
