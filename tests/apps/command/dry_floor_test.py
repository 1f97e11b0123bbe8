"""--floor-friction and --gravity-ratio, from outside: dry_floor_test.py SWIRL. What follows a floor with dry friction, and what
refuses it."""

import math
import unittest

import h5py

from driving import InFolder, document, run
from every_command import ASKED, FollowedOrRefused

PLAIN = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
DRY = f"{PLAIN} --floor-friction 0.05 --gravity-ratio 1"
DISK = DRY.replace("--sides 6", "--sides disk")
REFUSED = {"tradeoff", "certify", "boundaries", "describe"}


class DryFloor(InFolder, FollowedOrRefused):
    def test_every_command_with_a_scene_follows_or_refuses_it(self):
        self.check_every_command(ASKED, lambda name: DRY, REFUSED, ["floor-friction = 0.05"],
                                 {"floor_friction": 0.05, "gravity_ratio": 1, "floor": "dish"})

    def test_without_friction_nothing_changes(self):
        plain = run(f"simulate {PLAIN} --collisions 50 --json").stdout
        self.assertEqual(run(f"simulate {PLAIN} --collisions 50 --floor-friction 0 --json").stdout, plain)
        self.assertNotIn("friction_", plain)

    def test_the_cycle_that_classify_finds_is_that_of_orbits(self):
        mode = document(f"classify {DRY}")
        self.assertEqual((mode["mode"], mode["kind"], mode["period"]), ("steady", "fixed-point", 1))
        found = document(f"orbits {DRY} --period 1 --starts 300 --trajectories 2")["orbits"]
        self.assertLess(min(abs(orbit["mean_S"] - mode["mean_S"]) for orbit in found if orbit["stability"] == "stable"), 1e-9)

    def test_a_cycle_through_contact_is_found(self):
        hexagon = "--sides 6 --alpha 0.8 --beta 0.3 --mu 0.3 --restitution 0.1 --gravity-ratio 0.620655 --collisions 500 --transient 500"
        for friction, period in ((0, 1), (0.02, 1), (0.44, 6)):
            mode = document(f"classify {hexagon} --floor-friction {friction} --seed 3")
            self.assertEqual((mode["mode"], mode["kind"], mode["period"]), ("quasi-steady", "landing", period), friction)

    def test_endings_have_names(self):
        slow = "--x 0.5 --y 0 --vx 0.02 --vy 0.3 --angle 0.1 --spin 0.2"
        stops = f"{PLAIN} --floor-friction 0.3 --gravity-ratio 2"  # a_f = 0.6 > beta: it stops, and the dish carries it
        self.assertEqual(document(f"simulate {stops} {slow} --collisions 10", 3)["outcome"], "riding")
        mode = document(f"classify {stops} {slow}")
        self.assertEqual((mode["mode"], mode["kind"], mode["mean_S"]), ("steady", "riding", 0))

    def test_a_disk_rolls_on_the_wall(self):
        found = document(f"simulate {DISK} --collisions 1000", 3)
        self.assertEqual((found["outcome"], found["contacts"][-1]["motion"]), ("in-contact", "rolling"))
        mode = document(f"classify {DISK}")
        self.assertEqual((mode["mode"], mode["kind"]), ("quasi-steady", "rolling-librating"))
        self.assertAlmostEqual(mode["mean_S"], -1.5, delta=1e-9)  # locked to the swirl: -(1 - alpha)/alpha

    def test_a_disk_rests_on_the_wall_and_is_torn_loose(self):
        disk = "--sides disk --alpha 0.216 --beta 0.951 --mu 0.565 --restitution 0.047 --floor-friction 0.8521 --gravity-ratio 1"
        found = document(f"orbits {disk} --period 1 --starts 20 --trajectories 2 -o cycles.h5")["orbits"]
        stable = [orbit for orbit in found if orbit["stability"] == "stable"]
        self.assertEqual([abs(complex(*m)) for m in stable[0]["multipliers"]], [0] * 4)  # it forgets all while it rests
        point = ",".join(f"{stable[0]['points'][0][name]!r}" for name in ("psi", "vn", "vt", "S"))
        orbit = document(f"simulate {disk} --point={point} --collisions 12")
        returns = [impact["t"] for impact in orbit["collisions"] if abs(impact["spin"] - stable[0]["points"][0]["S"]) < 1e-9]
        self.assertEqual(len(returns), 2)  # the rebounds that end in contact count as one impact of a cycle
        self.assertAlmostEqual(returns[0], stable[0]["return_time"], delta=1e-9)
        rests = [piece for piece in orbit["contacts"] if piece["motion"] == "resting"]
        self.assertEqual([piece["end"] for piece in rests], ["slip"] * len(rests))
        self.assertGreater(len(rests), 0)

    def test_a_polygon_rests_on_the_wall_and_is_torn_loose(self):
        hexagon = "--sides 6 --alpha 0.7 --beta 0.86 --mu 0.55 --restitution 0.06 --floor-friction 0.808 --gravity-ratio 1 --seed 1 --speed 1"
        orbit = document(f"simulate {hexagon} --collisions 60 --sample 0.02")
        rests = [piece for piece in orbit["contacts"] if piece["motion"] == "resting"]
        self.assertGreater(len(rests), 3)
        for piece in rests:
            self.assertEqual((piece["end"], piece["mean_S"], len(piece["vertices"])), ("slip", 0, 1))
        motions = {(piece["motion"], len(piece["vertices"])) for piece in orbit["contacts"]}
        self.assertLessEqual({("sliding", 1), ("sticking", 1)}, motions)
        for sample in orbit["samples"]:
            place = complex(sample["x"], sample["y"]) - 0.86 * complex(math.cos(sample["t"]), math.sin(sample["t"]))
            corners = [abs(place + 0.7 * complex(math.cos(sample["angle"] + k * math.pi / 3), math.sin(sample["angle"] + k * math.pi / 3)))
                       for k in range(6)]
            self.assertLess(max(corners), 1 + 1e-10)
            if sample["in_contact"]:
                self.assertGreater(max(corners), 1 - 1e-10)
                self.assertLess(abs(sample["friction"]), 0.55 * sample["normal_force"] + 1e-7)

    def test_an_edge_that_ceases_to_rest_on_a_table_lifts(self):
        square = "--sides 4 --alpha 0.8551 --beta 5 --mu 0.3 --restitution 0 --floor-friction 0.25 --gravity-ratio 1 --floor table"
        orbit = document(f"simulate {square} --seed 463 --speed 1 --time 1")
        self.assertEqual(orbit["outcome"], "completed")
        self.assertLess(len(orbit["collisions"]), 30)  # no impacts of no duration without end

    def test_a_body_that_rolls_past_its_vertices_stays_inside(self):
        body = "--sides 12 --alpha 0.99 --beta 5 --mu 0.1 --restitution 0 --law stronge --floor-friction 3.8977404 --gravity-ratio 1"
        for sample in document(f"simulate {body} --floor table --seed 668352 --speed 1 --time 0.3 --sample 0.005")["samples"]:
            place = complex(sample["x"], sample["y"]) - 5 * complex(math.cos(sample["t"]), math.sin(sample["t"]))
            turns = (sample["angle"] + k * math.pi / 6 for k in range(12))
            self.assertLess(max(abs(place + 0.99 * complex(math.cos(turn), math.sin(turn))) for turn in turns), 1 + 1e-10)

    def test_what_rests_does_not_turn(self):
        disk = "--sides disk --alpha 0.97 --beta 0.8 --mu 0.5 --restitution 0.354 --floor-friction 0.008 --gravity-ratio 1"
        contacts = document(f"simulate {disk} --seed 569335 --speed 2 --time 20")["contacts"]
        self.assertGreater(len(contacts), 10)  # it swings from rest to rest, and rests in the end
        self.assertEqual([piece["mean_S"] for piece in contacts if piece["motion"] == "resting"], [0])

    def test_hardly_any_friction_joins_none(self):
        for body in ("--sides 3 --alpha 0.544 --beta 1.9 --mu 1e6 --restitution 0 --seed 916803",
                     "--sides 3 --alpha 0.901 --beta 0.262 --mu 2 --restitution 0 --law newton --seed 132802",
                     "--sides 2 --alpha 0.317 --beta 0.728 --mu 2 --restitution 0 --seed 508289"):
            ends = [document(f"simulate {body} --speed 1 --collisions 5 --floor-friction {m} --gravity-ratio 1")["collisions"][-1]
                    for m in (0, 1e-12)]
            for name in ("t", "x", "y", "spin"):
                self.assertAlmostEqual(ends[0][name], ends[1][name], delta=1e-8, msg=f"{body} {name}")

    def test_a_slip_too_short_to_be_seen_ends_with_a_name(self):
        disk = "--sides disk --alpha 0.647 --beta 0.263 --mu 1000 --restitution 0.3 --floor-friction 0.2104 --gravity-ratio 1"
        result = run(f"simulate {disk} --floor table --seed 852 --speed 1 --time 20")
        self.assertIn(result.returncode, (0, 3))
        self.assertNotIn("unexpected", result.stderr)

    def test_a_disk_that_the_dish_holds_at_its_wall_rides(self):
        for mu in (0, 0.3):
            held = f"--sides disk --alpha 0.4 --beta 0.5 --restitution 0 --floor-friction 0.6 --gravity-ratio 1 --mu {mu}"
            mode = document(f"classify {held} --x 1.0 --y 0 --vx 0.2 --vy 0.8")
            self.assertEqual((mode["mode"], mode["kind"], mode["mean_S"]), ("steady", "riding", 0))

    def test_samples_of_a_slip_from_rest_are_even(self):
        disk = "--sides disk --alpha 0.519 --beta 0.397 --mu 0.2 --restitution 0 --floor-friction 0.2472 --gravity-ratio 1"
        samples = document(f"simulate {disk} --seed 6 --speed 1 --sample 0.0001 --time 1.72")["samples"]
        late = [sample for sample in samples if 1.715 < sample["t"] < 1.719]
        steps = [abs(complex(b["x"] - a["x"], b["y"] - a["y"])) for a, b in zip(late, late[1:])]
        self.assertGreater(len(steps), 30)
        self.assertLess(max(steps) - min(steps), 1e-8)  # the swirl carries it 4e-5 a sample, and it creeps

    def test_samples_in_contact_are_on_the_wall(self):
        disk = DISK.replace("--mu 0.5 --restitution 0.9", "--mu 0.1 --restitution 0.5").replace("0.05", "0.2")
        found = document(f"simulate {disk} --time 40 --sample 0.05")
        on_wall = [sample for sample in found["samples"] if sample["in_contact"]]
        self.assertGreater(len(on_wall), 100)
        for sample in on_wall:
            place = complex(sample["x"], sample["y"]) - 0.5 * complex(math.cos(sample["t"]), math.sin(sample["t"]))
            self.assertLess(abs(abs(place) - 0.6), 1e-12)
            self.assertLess(abs(sample["friction"]), 0.1 * sample["normal_force"] + 1e-9)
        self.assertGreater(sum(abs(sample["slip"]) > 1e-3 for sample in on_wall), 5)

    def test_samples_are_inside_and_join_the_impacts(self):
        found = document(f"simulate {DRY} --floor table --collisions 30 --sample 0.01")
        self.assertGreater(len(found["samples"]), 1000)
        for sample in found["samples"]:
            place = complex(sample["x"], sample["y"]) - 0.5 * complex(math.cos(sample["t"]), math.sin(sample["t"]))
            corners = [place + 0.4 * complex(math.cos(sample["angle"] + k * math.pi / 3), math.sin(sample["angle"] + k * math.pi / 3))
                       for k in range(6)]
            self.assertLess(max(map(abs, corners)), 1 + 1e-9)
        for impact in found["collisions"]:  # speeds below 3: a sample within 0.01 of it is as near as that allows
            near = min(found["samples"], key=lambda sample: abs(sample["t"] - impact["t"]))
            self.assertLess(abs(complex(near["x"] - impact["x"], near["y"] - impact["y"])), 0.03)

    def test_a_record_is_followed_again(self):
        record = self.folder / "a.h5"
        self.assertEqual(run(f"simulate {DRY} --collisions 300 --quiet -o {record}").returncode, 0)
        with h5py.File(record) as file:
            self.assertEqual((file["scene"].attrs["floor_friction"], file["scene"].attrs["gravity_ratio"]), (0.05, 1))
        by_record = document(f"spectrum {record}")
        self.assertEqual(by_record["scene"], document(f"spectrum {DRY} --collisions 300")["scene"])

    def test_gravity_is_that_of_units(self):
        units = "--container-radius 0.1 --swirl-rate 14"
        scene = document(f"simulate {PLAIN} {units} --floor-friction 0.1 --collisions 3")["scene"]
        self.assertAlmostEqual(scene["gravity_ratio"], 9.80665 / (0.1 * 14 ** 2), delta=1e-15)
        self.assertIn("--gravity-ratio is missing", run(f"simulate {PLAIN} --floor-friction 0.1").stderr)
        along = run(f"bifurcate {DRY} --along floor-friction=0.02:0.05:3")
        self.assertEqual((along.returncode, "sweep --grid floor-friction=" in along.stderr), (2, True))

    def test_grids_over_friction(self):
        cells = document(f"sweep {PLAIN} --gravity-ratio 1 --grid floor-friction=0.01:0.05:2 --runs 1 --transient 50 "
                         "--collisions 100")["cells"]
        self.assertEqual([cell["parameters"]["floor-friction"] for cell in cells], [0.01, 0.05])
        short = "--transient 50 --collisions 100"
        for axis, rest in (("floor-friction=0,0.05", "--gravity-ratio 3.9"), ("gravity-ratio=0,3.9", "--floor-friction 0.05"),
                           ("floor-friction=0,0.05", "--container-radius 0.1 --swirl-rate 5"), ("spin-drag=0,2", "--drag 0.01")):
            name, values = axis.split("=")
            cells = document(f"sweep {PLAIN} {rest} --grid {axis} --runs 1 {short}")["cells"]
            for cell, value in zip(cells, values.split(",")):
                alone = document(f"sweep {PLAIN} {rest} --{name} {value} --grid alpha=0.4,0.41 --runs 1 {short}")["cells"][0]
                self.assertEqual(cell["runs"], alone["runs"], (axis, value))

    def test_wrong_input(self):
        self.assertIn("--floor-friction M is wanted", run(f"simulate {PLAIN} --gravity-ratio 3").stderr)
        for extra, mention in (("--drag 0.1", "floor-friction = 0.05"), ("--corner 0.1", "corner = 0.1"),
                               ("--sides 2000", "sides = 2000"), ("--gravity-ratio -1", "gravity-ratio = -1"),
                               ("--floor-friction=-1", "floor-friction = -1"), ("--floor-friction nan", "floor-friction"),
                               ("--accuracy quad", "double is wanted"), ("--accuracy brent", "dry friction")):
            flag = extra.replace("=", " ").split()[0]
            words = " ".join(w for w in DRY.replace(" --", "\n--").split("\n") if not w.startswith(f"{flag} "))
            result = run(f"simulate {words} {extra}")
            self.assertEqual((result.returncode, result.stdout), (2, ""), (extra, result.stderr))
            self.assertIn(mention, result.stderr)
            self.assertEqual(len(result.stderr.splitlines()), 1)


if __name__ == "__main__":
    unittest.main(verbosity=2)
