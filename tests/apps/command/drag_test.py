"""--drag, --spin-drag and --floor, from outside: drag_test.py SWIRL. What follows a floor that drags, and what refuses
it."""

import cmath
import math
import re
import sys
import unittest
from pathlib import Path

import h5py

import every_command
from driving import InFolder, document, run

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
ELASTIC = "--sides 6 --alpha 0.3 --beta 0.8 --mu 0.3 --restitution 1"
POINT = "--near=-0.0839,0.028,-0.5542,0.8898,-0.9793 --period 1"
#: How a command is asked, beside its scene; none has a word on drag of its own.
ASKED = every_command.ASKED | {
    "orbits": "--max-period 1 --starts 100 --trajectories 1 --collisions 200", "certify": POINT,
    "continue": "--from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.39:0.41",
}
REFUSED = {"tradeoff", "certify", "boundaries"}
#: Those that take no scene's flags.
WITHOUT_SCENE = {"join", "show", "plot", "animate", "explore", "notebook", "manual", "completion", "inspect", "tour",
                 "fit", "help"}


class Drag(InFolder, every_command.FollowedOrRefused):
    def test_every_command_follows_or_refuses_it(self):
        commands = set(re.findall(r"^  (\w+)  +\S", run("--help").stdout, re.M))
        self.assertLessEqual(set(ASKED), commands)
        self.assertEqual(commands - set(ASKED) - WITHOUT_SCENE, set())
        self.check_every_command(ASKED, lambda name: f"{HEXAGON} --drag 0.2", REFUSED, ["drag = 0.2"], {"drag": 0.2, "floor": "dish"})

    def test_axes_over_drag(self):
        cells = document(f"sweep {HEXAGON} --grid drag=0:0.2:3 --runs 1 --transient 50 --collisions 100")["cells"]
        self.assertEqual([cell["parameters"]["drag"] for cell in cells], [0, 0.1, 0.2])
        columns = document(f"bifurcate {HEXAGON} --along drag=0:0.1:2 --transient 50 --collisions 100")["columns"]
        self.assertEqual([column["parameter"] for column in columns], [0, 0.1])
        for line in ("boundaries --plane drag=0:1 --plane beta=0.1:0.2",
                     "certify --plane drag=0:1 --plane beta=0.1:0.2"):
            command, axes = line.split(" ", 1)
            result = run(f"{command} --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 {axes}")
            self.assertEqual(result.returncode, 2, line)
            self.assertIn("drag=0:1", result.stderr)

    def test_without_drag_nothing_changes(self):
        plain = run(f"simulate {HEXAGON} --collisions 50 --json").stdout
        self.assertEqual(run(f"simulate {HEXAGON} --collisions 50 --drag 0 --json").stdout, plain)
        self.assertNotIn("drag", plain)

    def test_a_record_is_followed_again(self):
        for floor in ("dish", "table"):
            record = self.folder / f"{floor}.h5"
            scene = f"{ELASTIC} --drag 0.02 --spin-drag 0.1 --floor {floor}"
            self.assertEqual(run(f"simulate {scene} --collisions 300 --quiet -o {record}").returncode, 0)
            with h5py.File(record) as file:
                kept = dict(file["scene"].attrs)
            self.assertEqual((kept["drag"], kept["spin_drag"]), (0.02, 0.1))
            direct = document(f"spectrum {scene} --transient 0 --collisions 300")
            again = document(f"spectrum {record}")
            self.assertEqual(direct["power"], again["power"])

    def test_a_scene_file_has_it(self):
        file = self.folder / "scene.toml"
        file.write_text("[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\n"
                        "drag = 0.1\nspin-drag = 0.3\nfloor = \"table\"\n")
        found = document(f"simulate --scene {file} --collisions 10")
        self.assertEqual([found["scene"][key] for key in ("drag", "spin_drag", "floor")], [0.1, 0.3, "table"])
        flags = f"{HEXAGON} --drag 0.1 --spin-drag 0.3 --floor table"
        self.assertEqual(found, document(f"simulate {flags} --collisions 10"))

    def test_the_spin_falls_in_flight(self):
        """S before an impact, from the impulse, is that after the one before times exp(-gamma_r tau)."""
        found = document(f"simulate {ELASTIC} --drag 0.05 --spin-drag 0.3 --collisions 200")["collisions"]
        inertia = (2 + math.cos(math.pi / 3)) / 6 * 0.3 ** 2
        for a, b in zip(found, found[1:]):
            arm = 0.3 * math.cos(b["chi"]), 0.3 * math.sin(b["chi"])
            before = b["spin"] - (arm[0] * b["impulse_tangential"] + arm[1] * b["impulse_normal"]) / inertia
            self.assertAlmostEqual(before, a["spin"] * math.exp(-0.3 * b["flight_time"]), delta=1e-12)

    def test_samples_between_impacts_solve_the_motion(self):
        record = self.folder / "orbit.h5"
        gamma, beta, step = 0.2, 0.8, 0.01
        line = f"simulate {ELASTIC} --drag {gamma} --collisions 40 --sample {step} --quiet -o {record}"
        self.assertEqual(run(line).returncode, 0)
        with h5py.File(record) as file:
            t, x, y, spin = (file[f"samples/{name}"][:] for name in ("t", "x", "y", "spin"))
            impacts = file["collisions/t"][:]
        place, looked, worst = x + 1j * y, 0, 0
        for i in range(1, len(t) - 1):
            if any(t[i - 1] <= impact <= t[i + 1] for impact in impacts):
                continue
            velocity = (place[i + 1] - place[i - 1]) / (2 * step)
            force = (place[i + 1] - 2 * place[i] + place[i - 1]) / step ** 2
            wind = 1j * beta * complex(math.cos(t[i]), math.sin(t[i]))
            worst = max(worst, abs(force + gamma * (velocity - wind)))
            self.assertAlmostEqual(spin[i + 1], spin[i] * math.exp(-gamma * step), delta=1e-9)
            looked += 1
        self.assertGreater(looked, 500)
        self.assertLess(worst, 1e-4)  # of second order in the step: x''' step^2/6

    def test_endings_have_names(self):
        rides = document("simulate --sides 6 --alpha 0.3 --beta 0.4 --mu 0.5 --restitution 0.9 --drag 1 --x 0", 3)
        self.assertEqual(rides["outcome"], "riding")
        disk = document("simulate --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.5 --drag 0.1 "
                        "--collisions 10000", 3)
        self.assertEqual(disk["outcome"], "in-contact")

    def test_a_disk_that_comes_to_roll_is_locked_where_describe_says(self):
        scene = "--sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.5"
        for floor in ("dish", "table"):
            dragged = f"{scene} --drag 0.1 --floor {floor}"
            floor_facts = document(f"describe {dragged}")["floor"]
            found = document(f"classify {dragged}")
            self.assertEqual([found[key] for key in ("mode", "kind", "outcome")], ["steady", "rolling", "in-contact"])
            self.assertAlmostEqual(found["mean_S"], floor_facts["locked_S"], delta=1e-9)
            record = self.folder / f"{floor}.h5"
            run(f"simulate {dragged} --collisions 10000 --sample 100 --quiet -o {record}")
            with h5py.File(record) as file:
                t, x, y, spin = (file[f"samples/{name}"][-1] for name in ("t", "x", "y", "spin"))
            self.assertGreater(t, 500)
            psi = cmath.phase((complex(x, y) - 0.5 * cmath.exp(1j * t)) * cmath.exp(-1j * t))
            self.assertAlmostEqual(psi, floor_facts["locked_psi"], delta=1e-9)
            self.assertAlmostEqual(spin, floor_facts["locked_S"], delta=1e-9)
        # Without friction nothing but the drag turns it, until it does not turn.
        slides = document("classify --sides disk --alpha 0.4 --beta 0.5 --mu 0 --restitution 0.5 --drag 0.1 --spin 2 "
                          "--vx 0.3 --x 0.5")
        self.assertEqual((slides["mode"], slides["kind"], slides["mean_S"]), ("steady", "sliding", 0))

    def test_a_body_that_rides_is_steady(self):
        """S = 0, and the room at the wall is that of where the drag leaves the body, from its last impact alone."""
        beta, gamma, alpha = 0.2, 0.2, 0.3
        for sides, floor, outcome in (("6", "dish", "riding"), ("disk", "dish", "riding"), ("6", "table", "no-contact"),
                                      ("disk", "table", "no-contact")):
            scene = (f"--sides {sides} --alpha {alpha} --beta {beta} --mu 0.5 --restitution 0.9 --drag {gamma} "
                     f"--floor {floor}")
            found = document(f"classify {scene}")
            self.assertEqual([found[key] for key in ("mode", "kind", "outcome", "mean_S", "mean_S_kind")],
                             ["steady", "riding", outcome, 0, "exact"], scene)
            last = document(f"simulate {scene} --collisions 1000", 3)["collisions"][-1]
            response = 1 / complex(1, -gamma) if floor == "dish" else 1
            normal = cmath.exp(1j * (last["psi"] + last["t"]))
            chi = last.get("chi") or 0
            arm = alpha * normal * cmath.exp(1j * chi)
            swirl = beta * cmath.exp(1j * last["t"])
            velocity = normal * complex(last["vn"], last["vt"])
            stream = velocity - (gamma * response * swirl if floor == "dish" else 0)
            place = normal - arm + response * swirl + stream / gamma
            end = arm * cmath.exp(1j * last["spin"] / gamma)
            reach = max(abs(place + end * cmath.exp(2j * math.pi * k / 6)) for k in range(6)) if sides == "6" else \
                abs(place) + alpha
            evidence = found["evidence"][0]
            self.assertEqual(evidence["name"], "room at the wall")
            self.assertAlmostEqual(evidence["value"], 1 - abs(response) * beta - reach, delta=1e-9)
            self.assertGreater(evidence["value"], 0)
        spinning = document("classify --sides disk --alpha 0.3 --beta 0.2 --mu 0.5 --restitution 0.9 --drag 0.2 "
                            "--spin-drag 0")
        last = document("simulate --sides disk --alpha 0.3 --beta 0.2 --mu 0.5 --restitution 0.9 --drag 0.2 "
                        "--spin-drag 0 --collisions 1000", 3)["collisions"][-1]
        self.assertEqual((spinning["kind"], spinning["mean_S"]), ("riding", last["spin"]))

    def test_a_start_that_meets_no_wall_rides(self):
        found = document("classify --sides 6 --alpha 0.3 --beta 0.4 --mu 0.5 --restitution 0.9 --drag 1 --x 0.4")
        self.assertEqual((found["kind"], found["impacts"], found["mean_S"]), ("riding", 0, 0))
        none = document("classify --sides 6 --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 0.9 --x 0.1 --floor table "
                        "--drag 0 --spin-drag 1")
        self.assertEqual((none["kind"], none["outcome"]), (None, "no-contact"))  # nothing slows its centre

    def test_a_map_has_a_letter_for_riding(self):
        sweep = f"sweep --sides 6 --alpha 0.3 --mu 0.5 --restitution 0.9 --runs 2 --transient 300 --collisions 300"
        text = run(f"{sweep} --grid beta=0.1:0.6:2 --grid drag=0.2:0.5:2").stdout
        self.assertIn("R riding", text)
        rows = [line.split("|")[1].split() for line in text.splitlines() if "|" in line]
        self.assertEqual([row[0] for row in rows], ["R", "R"])
        record = self.folder / "sweep.h5"
        self.assertEqual(run(f"{sweep} --grid beta=0.1,0.6 --grid spin-drag=0,0.2 --drag 0.2 --quiet -o {record}")
                         .returncode, 0)
        with h5py.File(record) as file:
            self.assertIn("riding", file["sweep/run_kind"].attrs["flag_meanings"].split())
            self.assertEqual(list(file["sweep/spin_drag"][:]), [0, 0.2])
        # A figure shows it as a mode of its own: the shares are still of all runs.
        sys.path.insert(0, str(Path(__file__).parents[3] / "notebooks-export"))
        from swirl_figures.record import open_record
        from swirl_figures.sweep_grid import SweepGrid
        grid = SweepGrid(open_record(record))
        self.assertEqual(grid.modes, ["steady", "riding", "quasi-steady", "chaotic", "undecided"])
        self.assertTrue((abs(grid.share.sum(axis=-1) - 1) < 1e-15).all())
        self.assertEqual(grid.share[0, :, 1].tolist(), [1, 1])
        plain = self.folder / "plain.h5"
        self.assertEqual(run(f"{sweep} --grid beta=0.1,0.6 --quiet -o {plain}").returncode, 0)
        with h5py.File(plain) as file:
            self.assertNotIn("riding", file["sweep/run_kind"].attrs["flag_meanings"])
        self.assertNotIn("riding", run(f"{sweep} --grid beta=0.1:0.6:2 --grid mu=0.2:0.5:2").stdout)

    def test_a_floor_without_drag_is_refused(self):
        for command in ("simulate --collisions 5", "classify", "describe"):
            name, *more = command.split()
            result = run(f"{name} {HEXAGON} {' '.join(more)} --floor table")
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertEqual(len(result.stderr.splitlines()), 1)
            self.assertIn("floor = table", result.stderr)
            self.assertIn("--drag", result.stderr)
        found = document(f"bifurcate {HEXAGON} --floor table --along drag=0:0.1:2 --transient 50 --collisions 100")
        self.assertEqual(len(found["columns"]), 2)

    def test_a_key_with_an_underscore_is_understood_as_meant(self):
        file = self.folder / "scene.toml"
        file.write_text("[scene]\nsides = 6\nalpha = 0.4\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\ndrag = 0.1\n"
                        "spin_drag = 0.3\n")
        result = run(f"simulate --scene {file} --collisions 5")
        self.assertEqual(result.returncode, 2)
        self.assertIn("unknown key 'spin_drag' under [scene]; did you mean spin-drag?", result.stderr)

    def test_completion_offers_drag_where_it_is_followed(self):
        script = run("completion bash").stdout
        offered = {name for name in ("continue --along", "bifurcate --along", "boundaries --plane", "certify --along", "ramp --along",
                                     "sweep --grid")
                   if any(f"'{name}'" in line and "'drag='" in line for line in script.splitlines())}
        self.assertEqual(offered, {"continue --along", "bifurcate --along", "ramp --along", "sweep --grid"})

    def test_steady_modes_are_fixed_points(self):
        """Each that describe lists comes back to itself; the one that attracts is what an orbit comes to."""
        scene = f"{HEXAGON} --drag 0.1"
        record = self.folder / "modes.h5"
        found = document(f"describe {scene} --max-time 6 -o {record}")
        modes = found["steady_modes"]
        self.assertGreaterEqual(len(modes), 4)
        self.assertEqual(found["searched_to"], 6)
        for mode in modes:
            point = ",".join(repr(mode["point"][key]) for key in ("psi", "chi", "vn", "vt", "S"))
            back = document(f"simulate {scene} --point={point} --collisions 1")["collisions"][0]
            self.assertAlmostEqual(back["flight_time"], mode["tau"], delta=1e-8)
            self.assertAlmostEqual(back["spin"], mode["S"], delta=1e-8)
            self.assertAlmostEqual(back["psi"], mode["point"]["psi"], delta=1e-8)
        stable = [mode for mode in modes if mode["stability"] == "stable"]
        settled = document(f"classify {scene}")
        self.assertEqual((len(stable), settled["kind"]), (1, "fixed-point"))
        self.assertAlmostEqual(settled["mean_S_per_impact"], stable[0]["S"], delta=1e-9)
        with h5py.File(record) as file:
            self.assertEqual(len(file["steady_modes/tau"]), len(modes))

    def test_describe_says_what_is_known(self):
        floor = document("describe --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.5 --drag 0.2")["floor"]
        ratio = (0.2 + 0.5 * 0.2) * 0.6 / 0.5
        self.assertAlmostEqual(floor["locking_ratio"], ratio, delta=1e-15)
        self.assertTrue(floor["rolls_locked"])
        self.assertAlmostEqual(floor["locked_S"], -1.5, delta=1e-15)
        self.assertAlmostEqual(floor["riding_radius"], 0.5 / math.sqrt(1.04), delta=1e-15)
        self.assertTrue(floor["rides"])
        swept = document("describe --sides 6 --alpha 0.4 --beta 0.7 --mu 0.5 --restitution 0.5 --drag 0.2")["floor"]
        self.assertFalse(swept["rides"])
        fast = document("describe --sides disk --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.5 --drag 0.2")["floor"]
        self.assertFalse(fast["rolls_locked"])

    def test_orbits_has_every_steady_mode_of_describe(self):
        few = "--starts 100 --trajectories 1 --collisions 200"
        for scene in ("--sides 4 --alpha .5 --beta .2 --mu .4 --restitution .85", "--sides 6 --alpha .4 --beta .5 --mu .5 --restitution .9"):
            found = document(f"orbits {scene} --drag .05 --period 1 {few}")
            points = [orbit["points"][0] for orbit in found["orbits"]]
            modes = document(f"describe {scene} --drag .05")["steady_modes"]
            self.assertGreater(len(modes), 5)
            for mode in modes:
                near = min(max(abs(point[key] - mode["point"][key]) for key in ("chi", "vn", "vt", "S")) for point in points)
                self.assertLess(near, 1e-8, (scene, mode))
            search, = found["searches"]
            self.assertGreater(search["from_equations"], 0)
            self.assertEqual(search["cycles"] + search["from_equations"], len(points))
            self.assertEqual(sum(orbit["found"] == 0 for orbit in found["orbits"]), search["from_equations"])
        self.assertNotIn("from_equations", document(f"orbits {scene} --period 1 {few}")["searches"][0])

    def test_an_elastic_disk_bounces_ever_lower_to_rolling(self):
        scene = "--sides disk --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
        for drag in (0.01, 0.1):
            verdict = document(f"classify {scene} --drag {drag}")
            self.assertEqual((verdict["mode"], verdict["kind"]), ("steady", "rolling"), drag)
            self.assertAlmostEqual(verdict["mean_S"], -0.7 / 0.3, delta=1e-12)
            floor = document(f"describe {scene} --drag {drag}")["floor"]
            # The orbit, of which nothing but v and tau of two impacts is used: v^2 tau falls at the rate of describe.
            rows = document(f"simulate {scene} --drag {drag} --collisions 20001 --skip 18000")["collisions"]
            size = [2 * math.log(0.5 * math.sin(row["psi"]) - row["vn"]) + math.log(after["flight_time"])
                    for row, after in ((rows[0], rows[1]), (rows[-2], rows[-1]))]
            rate = (size[0] - size[1]) / (rows[-2]["t"] - rows[0]["t"])
            self.assertAlmostEqual(rate / floor["locked_bounce_decay"], 1, delta=0.02, msg=drag)
        frictionless = "--sides disk --alpha 0.3 --beta 0.5 --mu 0 --restitution 1 --drag 0.1"
        slides = document(f"classify {frictionless}")
        self.assertEqual([slides[key] for key in ("mode", "kind", "mean_S")], ["steady", "sliding", 0])
        self.assertEqual(document(f"classify {frictionless} --spin-drag 0")["kind"], "transient")  # its S is any
        ring = "--sides disk --alpha 0.3 --beta 0.1 --mu 5 --restitution 1 --inertia-factor 1 --drag 0.05"
        self.assertLess(document(f"describe {ring}")["floor"]["locked_bounce_decay"], 0)
        self.assertIn("bounces on it grow", run(f"describe {ring}").stdout)
        self.assertNotEqual(document(f"classify {ring}")["kind"], "rolling")

    def test_a_cycle_is_found_and_continued(self):
        """The hexagon's steady mode goes on from gamma = 0."""
        found = document(f"continue {HEXAGON} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along drag=0:0.02")
        points = found["branches"][0]["points"]
        values = [point["parameter"] for point in points]
        self.assertAlmostEqual(min(values), 0, delta=1e-9)
        self.assertGreater(max(values), 0)
        middle = points[len(points) // 2]
        section = middle["points"][0] if "points" in middle else middle["point"]
        near = ",".join(repr(section[key]) for key in ("psi", "chi", "vn", "vt", "S"))
        orbits = document(f"orbits {HEXAGON} --drag {middle['parameter']!r} --near={near} --period 1")["orbits"]
        self.assertEqual(len(orbits), 1)
        for key in ("psi", "chi", "vn", "vt", "S"):
            self.assertAlmostEqual(orbits[0]["points"][0][key], section[key], delta=1e-9)

    def test_wrong_values_are_named(self):
        for flags, word in (("--drag -1", "drag = -1"), ("--drag 1e4", "drag = 10000"), ("--drag x", "drag"),
                            ("--drag 0.1 --spin-drag -2", "spin-drag = -2"), ("--drag 0.1 --floor sea", "floor = sea"),
                            ("--drag 0.1 --accuracy paper", "drag")):
            result = run(f"simulate {HEXAGON} --collisions 5 {flags}")
            self.assertEqual(result.returncode, 2, flags)
            self.assertIn(word, result.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)
