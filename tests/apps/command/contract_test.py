"""Drives the built `swirl` as a user does. Arguments: the binary, the project's root, the folder of references."""

import json
import math
import re
import shlex
import subprocess
import sys
import unittest
from pathlib import Path

import xarray

from driving import SEARCH, SWIRL, InFolder, document, examples_of, interrupted, run, sized

ROOT, REFERENCES = (Path(sys.argv.pop(1)) for _ in range(2))
HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
ROW = """t x y vx vy angle spin vertex psi chi vn vt flight_time impulse_normal impulse_tangential contact_mode jacobi
jacobi_restitution jacobi_friction""".split()


class BadInput(InFolder):
    def check(self, arguments, *mentions):
        result = run(arguments)
        self.assertEqual(result.returncode, 2, arguments)
        self.assertEqual(result.stdout, "", arguments)
        self.assertEqual(len(result.stderr.splitlines()), 1, result.stderr)
        for mention in mentions:
            self.assertIn(mention, result.stderr)

    def test_scene_parameters_out_of_range(self):
        rest = {"sides": "6", "alpha": "0.4", "beta": "0.5", "mu": "0.5", "restitution": "0.9"}
        for name, value in [("alpha", "1.2"), ("alpha", "0"), ("sides", "1"), ("sides", "1000001"), ("sides", "six"),
                            ("restitution", "nan"), ("restitution", "1.01"), ("mu", "-1"), ("beta", "-0.1"),
                            ("beta", "inf"), ("alpha", "abc"), ("alpha", "1e-300"), ("mu", "1e+300")]:
            flags = " ".join(f"--{k} {v}" for k, v in {**rest, name: value}.items())
            for command in ("simulate", "classify"):
                self.check(f"{command} {flags}", name, value)

    def test_flags_and_files(self):
        self.check(f"simulate {HEXAGON} --bogus 3", "--bogus")
        self.check("nonsense", "nonsense")
        self.check("", "command")
        self.check("simulate --sides 6", "missing")
        self.check(f"simulate --scene {self.folder}/none.toml", "none.toml")
        for name, text, mention in [
                ("key.toml", "[scene]\nsides = 6\nalhpa = 0.4\n", "alhpa"),
                ("table.toml", "[scene]\nsides = 6\n[bogus]\nx = 1\n", "bogus"),
                ("cut.toml", "[scene]\nsides = 6\nalpha = ", "line"),
                ("empty.toml", "", "[scene]")]:
            self.check(f"simulate --scene {self.file(name, text)}", mention)

    def test_sides_are_a_whole_number(self):
        for sides, mention in (("6.5", "no whole number"), ("six", "no whole number"), ("1", "outside its range"), ("1e7", "outside its range")):
            self.check(f"describe --sides {sides} --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9", f"sides = {sides} is {mention}: 2 to 1000000")

    def test_an_inertia_that_no_body_has_is_noted(self):
        for factor, noted in (("1", False), ("3", True)):
            result = run(f"simulate {HEXAGON} --collisions 3 --inertia-factor {factor}")
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual("note: inertia-factor = 3 is above 1" in result.stderr, noted)
            self.assertEqual(run(f"simulate {HEXAGON} --collisions 3 --inertia-factor {factor} --quiet").stderr, "")

    def test_starts(self):
        self.check(f"simulate {HEXAGON} --x 3", "start")
        self.check(f"simulate {HEXAGON} --x 1.2", "start")  # inside, but a vertex is not
        self.check("simulate --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --x 1.2", "start")
        self.check(f"simulate {HEXAGON} --point 0,0,1,0,0", "leaving")
        self.check(f"simulate {HEXAGON} --point 0,1.5,-1,0,0", "point")
        self.check(f"simulate {HEXAGON} --point 0,0,-1,0", "5")
        self.check(f"simulate {HEXAGON} --point 0,0,-1,0,nan", "S")
        self.check(f"simulate {HEXAGON} --point 0,0,-1,0,0 --x 0.5", "--point")
        self.check(f"simulate {HEXAGON} --seed 3 --x 0.5", "--seed")
        self.check(f"simulate {HEXAGON} --seed -1", "--seed", "-1")
        self.check(f"simulate {HEXAGON} --collisions 5 --time 3", "--time")
        for step in ("0", "-1", "nan", "inf", "1e-300"):
            self.check(f"simulate {HEXAGON} --sample {step} --json", "sample", "1e-09")
        self.check(f"simulate {HEXAGON} --sample 0.1", "--json")
        self.check(f"simulate {HEXAGON} --time 0", "time", "0")
        self.check(f"simulate {HEXAGON} --collisions 5 --skip 5", "skip", "5")
        self.check(f"simulate {HEXAGON} --vx 1e-300", "speed", "1e-300")
        self.check(f"simulate {HEXAGON} --accuracy half", "half")

    def test_an_output_that_cannot_be_created(self):
        self.check(f"simulate {HEXAGON} -o {self.folder}/no/such/a.h5", "no/such")
        self.check(f"classify {HEXAGON} -o {self.folder}", str(self.folder))
        kept = self.file("kept.h5", "not touched")
        self.check(f"simulate {HEXAGON} --alpha 0.4 --x 3 -o {kept}")
        self.assertEqual(kept.read_text(), "not touched")
        self.assertEqual([p.name for p in self.folder.iterdir()], ["kept.h5"])


class Simulate(InFolder):
    def test_rows_have_the_fixed_keys(self):
        rows = document(f"simulate {HEXAGON} --collisions 3")["collisions"]
        self.assertEqual(len(rows), 3)
        for row in rows:
            self.assertLessEqual(set(ROW), set(row))
        disk = document("simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --collisions 3")
        self.assertEqual(disk["scene"]["sides"], "disk")
        for row in disk["collisions"]:
            self.assertNotIn("chi", row)
            self.assertEqual(row["vertex"], 0)

    def orbits(self):
        return json.loads((REFERENCES / "trajectories.json").read_text())["cases"]

    def check_orbit(self, case, accuracy, tolerance):
        scene = {k: case[k] for k in ("alpha", "beta", "mu", "restitution", "law")}
        scene["sides"] = "disk" if case["sides"] == 0 else case["sides"]
        flags = " ".join(f"--{k} {v}" for k, v in {**scene, **case["initial"]}.items())
        rows = document(f"simulate {flags} --collisions {len(case['collisions'])} --accuracy {accuracy}")["collisions"]
        self.assertEqual(len(rows), len(case["collisions"]))
        for row, expected in zip(rows, case["collisions"]):
            if expected["amplification"] > 1e10 and accuracy == "double":
                break
            self.assertEqual(row["vertex"], expected["vertex"])
            for key in "t x y vx vy angle spin psi".split():
                allowed = tolerance(expected["amplification"], abs(float(expected[key])))
                self.assertLessEqual(abs(row[key] - float(expected[key])), allowed, (flags, key))

    def test_reference_orbits_in_double(self):
        for case in self.orbits()[::sized(1, 4)]:
            self.check_orbit(case, "double", lambda amplification, _: max(1e-12, 1e-13 * amplification))

    def test_reference_orbits_in_quad_are_right_to_the_printed_double(self):
        for case in self.orbits()[:12:sized(1, 3)]:
            self.check_orbit(case, "quad", lambda _, size: 3e-16 * (1 + size))

    def test_endings_exit_with_3(self):
        for sides in ("disk", "6"):
            ended = document(f"simulate --sides {sides} --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.9 --x 0.1", 3)
            self.assertEqual((ended["outcome"], ended["collisions"]), ("no-contact", []))
        chatter = document("simulate --sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9 "
                           "--collisions 9999", 3)
        self.assertEqual(chatter["outcome"], "in-contact")
        self.assertLess(len(chatter["collisions"]), 1000)
        last = chatter["contacts"][-1]
        self.assertEqual((last["vertices"], last["begin"], last["end"], last["motion"]),
                         ([0], "landing", "horizon", "rolling"))
        self.assertAlmostEqual(last["t_end"] - last["t_start"], 1000, delta=1e-9)
        for row in chatter["collisions"]:
            for value in row.values():
                self.assertFalse(value is None)

    def test_the_mean_of_fewer_than_two_impacts_is_the_flights_own_spin(self):
        for_ever = document("simulate --sides disk --alpha 0.3 --beta 0.1 --mu 0 --restitution 1 --x 0.05 --vx 0 --spin 1",
                            code=3)
        self.assertEqual(for_ever["result"]["mean_S"], 1)
        before = document(f"simulate {HEXAGON} --vx 0.1 --spin 2 --time 0.5")
        self.assertEqual(before["result"]["mean_S"], 2)

    def test_a_scene_file_and_physical_units_give_the_same_orbit(self):
        flags = document(f"simulate {HEXAGON} --collisions 5")["collisions"]
        file = self.file("s.toml", "[scene]\nsides = 6\nalpha = 0.9\nbeta = 0.5\nmu = 0.5\nrestitution = 0.9\n")
        self.assertEqual(document(f"simulate --scene {file} --alpha 0.4 --collisions 5")["collisions"], flags)
        physical = document("simulate --sides 6 --container-radius 2 --polygon-radius 0.8 --swirl-radius 1 --mu 0.5 "
                            "--restitution 0.9 --swirl-rate 4 --mass 3 --collisions 5")
        self.assertEqual(physical["collisions"], flags)
        self.assertEqual(physical["units"], {"length": 2, "time": 0.25, "mass": 3})

    def test_skip_every_and_time(self):
        every = document(f"simulate {HEXAGON} --collisions 20")["collisions"]
        some = document(f"simulate {HEXAGON} --collisions 20 --skip 3 --every 5")["collisions"]
        self.assertEqual(some, every[3::5])
        until = document(f"simulate {HEXAGON} --time 10")["collisions"]
        self.assertEqual(until, [row for row in every if row["t"] <= 10])

    def test_equal_work_gives_equal_files_that_open_in_xarray(self):
        for name in ("a.h5", "b.h5"):
            self.assertEqual(run(f"simulate {HEXAGON} --collisions 500 -o {self.folder / name}").returncode, 0)
        self.assertEqual((self.folder / "a.h5").read_bytes(), (self.folder / "b.h5").read_bytes())
        rows = document(f"simulate {HEXAGON} --collisions 500")["collisions"]
        with xarray.open_dataset(self.folder / "a.h5", group="collisions", engine="h5netcdf") as data:
            self.assertEqual(dict(data.sizes), {"collision": 500})
            self.assertEqual(list(data["psi"].values), [row["psi"] for row in rows])
            self.assertEqual(data["t"].attrs["units"], "1/omega_s")
        for group in ("/", "scene", "start", "settings", "result"):
            xarray.open_dataset(self.folder / "a.h5", group=group, engine="h5netcdf").close()

    def test_sampling_can_be_interrupted(self):
        record = self.folder / "samples.h5"
        command = ("simulate --sides disk --alpha 0.3 --beta 0.3 --mu 0.4 --restitution 0.5 --collisions 1000 "
                   f"--sample 1e-6 --quiet -o {record}")
        self.assertEqual(interrupted(command, 1), 130)
        with xarray.open_dataset(record, group="samples", engine="h5netcdf") as samples:
            self.assertGreater(samples.sizes["sample"], 0)

    def test_an_interrupted_orbit_is_kept(self):
        record = self.folder / "long.h5"
        command = f"simulate {HEXAGON} --collisions 1000000000 --every 1000 --quiet -o {record}"
        self.assertEqual(interrupted(command, 1), 130)
        with xarray.open_dataset(record, group="result", engine="h5netcdf") as result:
            self.assertEqual(result.attrs["outcome"], "interrupted")
            impacts = int(result.attrs["impacts"])
        with xarray.open_dataset(record, group="collisions", engine="h5netcdf") as data:
            self.assertEqual(data.sizes["collision"], (impacts - 1) // 1000 + 1)

    def test_memory_does_not_grow_with_the_number_of_impacts(self):
        def peak(collisions):
            flags = f"simulate {HEXAGON} --quiet --every 1000000000 --collisions {collisions}"
            code = (f"import resource, subprocess; subprocess.run({[SWIRL, *shlex.split(flags)]!r}, check=True); "
                    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)")
            return int(subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout)
        self.assertLess(peak(2_000_000) - peak(20_000), 8 * 1024)  # KiB; the allocator's own scatter is below this


    def test_a_full_disk_exits_with_4(self):
        for layout in ("", "--json"):
            with open("/dev/full", "w") as full:
                flags = shlex.split(f"simulate {HEXAGON} --collisions 3 {layout}")
                result = subprocess.run([SWIRL, *flags], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
            self.assertEqual(result.returncode, 4)
            self.assertEqual(len(result.stderr.splitlines()), 1)


class Classify(unittest.TestCase):
    def test_the_modes_of_the_references(self):
        steady = document(f"classify {HEXAGON}")
        self.assertEqual((steady["mode"], steady["kind"], steady["period"]), ("steady", "fixed-point", 1))
        self.assertAlmostEqual(steady["mean_S"], -0.97926605821858726645, delta=1e-9)
        self.assertLess(steady["largest_exponent"], 0)
        cycle = document("classify --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95")
        self.assertEqual((cycle["mode"], cycle["kind"], cycle["period"]), ("quasi-steady", "cycle", 8))
        self.assertAlmostEqual(cycle["recurrence_rate"], 1 / 8, delta=1e-9)
        chaotic = document("classify --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1")
        self.assertEqual((chaotic["mode"], chaotic["kind"], chaotic["period"]), ("chaotic", "chaotic", None))
        self.assertGreater(chaotic["mean_S"], 0)
        self.assertLess(chaotic["mean_S_per_impact"], 0)
        family = document("classify --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1")
        self.assertEqual((family["mode"], family["kind"], family["period"]), ("steady", "family", 1))
        self.assertTrue(any(math.hypot(re - 1, im) < 1e-9 for re, im in family["multipliers"]))

    def test_every_cycle_of_the_references_by_its_period(self):
        for case in json.loads((REFERENCES / "cycles.json").read_text())["cycles"][::sized(1, 4)]:
            flags = " ".join(f"--{k} {case[k]}" for k in ("sides", "alpha", "beta", "mu", "restitution", "law"))
            point = ",".join(case["point"][k] for k in ("psi", "chi", "vn", "vt", "S"))
            verdict = document(f"classify {flags} --point {point} --transient 100 --collisions 1000")
            self.assertEqual(verdict["period"], case["period"], flags)
            self.assertEqual(verdict["mode"], "steady" if case["period"] == 1 else "quasi-steady")
            largest = max(math.hypot(*m) for m in case["multipliers"])
            self.assertAlmostEqual(max(math.hypot(*m) for m in verdict["multipliers"]), largest, delta=1e-8)

    def test_an_orbit_that_stays_on_the_wall_is_named_by_its_contact(self):
        for scene, mode, kind, mean in [
                ("disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9", "quasi-steady", "rolling-librating", -1.5),
                ("disk --alpha 0.15 --beta 1 --mu 0.4 --restitution 0.97", "quasi-steady", "rolling-librating",
                 -0.85 / 0.15),
                # Slips a little in each turn for ever; mean S of the pendulum that it settles on by SciPy's ellipk.
                ("disk --alpha 0.1 --beta 0.05 --mu 0.4 --restitution 0.3", "quasi-steady", "rolling-circulating",
                 -2.1446596606),
                ("disk --alpha 0.4 --beta 0.3 --mu 0 --restitution 0.5", "steady", "sliding", 0),
                # Without a swirl a disk rolls on evenly, its angular momentum about the contact kept (kappa = 1/2);
                # in a swirl of 1e-20 no differently.
                ("disk --alpha 0.4 --beta 0 --mu 0.5 --restitution 0 --spin 0.5 --vx 0.1", "steady", "rolling", 0.5 / 3),
                ("disk --alpha 0.4 --beta 1e-20 --mu 0.5 --restitution 0 --spin 0.5 --vx 0.1", "steady", "rolling", 0.5 / 3),
                ("3 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.3", "steady", "two-vertex", 1)]:
            verdict = document(f"classify --sides {scene}")
            self.assertEqual((verdict["mode"], verdict["kind"], verdict["outcome"]), (mode, kind, "in-contact"), scene)
            self.assertAlmostEqual(verdict["mean_S"], mean, delta=1e-6)

    def test_a_frictionless_disk_whose_impacts_fade_is_named_before_their_end(self):
        """Each lowers J, none changes S; a polygon's S is not known before."""
        scene = "--alpha 0.127 --beta 0.809 --mu 0 --restitution 0.409 --x 0.3 --vx 0.2 --vy 0.1 --spin 0.25"
        disk = document(f"classify --sides disk {scene} --transient 300 --collisions 300")
        self.assertEqual((disk["mode"], disk["kind"], disk["outcome"]), ("steady", "sliding", "completed"))
        self.assertAlmostEqual(disk["mean_S"], 0.25, delta=1e-14)
        polygon = document(f"classify --sides 8 {scene} --transient 300 --collisions 300")
        self.assertEqual((polygon["mode"], polygon["kind"], polygon["outcome"]), ("undecided", "transient", "completed"))

    def test_no_contact_is_no_mode(self):
        verdict = document("classify --sides 6 --alpha 0.4 --beta 0.1 --mu 0.5 --restitution 0.9 --x 0.1")
        self.assertEqual((verdict["mode"], verdict["outcome"]), ("undecided", "no-contact"))


class Help(InFolder):
    def check_examples(self, examples, name):
        """In a folder of their own and in their order, as some read what others wrote."""
        folder = self.folder / name
        folder.mkdir()
        for example in examples:
            if example.startswith("orbits ") and "--near" not in example:
                example += f" {SEARCH}"
            example = re.sub(r"--budget \S+", "--budget 1", example)  # what it answers is tradeoff's own test
            self.assertEqual(run(example, cwd=folder).returncode, 0, example)

    def test_every_example_of_the_help_and_of_the_documents_runs(self):
        shown = []
        commands = re.findall(r"^  (\w+) ", run("--help").stdout.split("Subcommands:")[1], re.M)
        self.assertGreaterEqual(len(commands), 12)
        own = {"plot", "animate", "notebook", "fit", "explore", "ramp"}  # their own tests run those
        for command in sorted(set(commands) - own)[::sized(1, 3)]:
            examples = examples_of(command)
            self.assertTrue(examples, command)
            shown += examples
        self.check_examples(shown, "help")
        readme, more = (re.findall(r"^swirl (.*?)(?:\s+#.*)?$", (ROOT / name).read_text(), re.M)
                        for name in ("README.md", "docs/examples.md"))
        self.assertEqual(len(readme), 5)
        self.assertLessEqual(set(readme), set(more))
        self.assertGreater(len(more), 20)
        self.check_examples(sized([one for one in more if one not in shown or ".h5" in one], []), "documents")

    def test_what_quickstart_says_to_try_next_runs(self):
        script = (ROOT / "quickstart").read_text()
        tried = re.findall(r"^\$build/apps/swirl (.*)$", script.split("try next")[1], re.M)
        self.assertEqual(len(tried), 3)
        self.assertEqual(run(f"tour --quiet -o {self.folder}/swirl-tour.h5").returncode, 0)
        for command in tried:
            result = run(command.replace("$record", "swirl-tour.h5"), cwd=self.folder)
            self.assertEqual(result.returncode, 0, (command, result.stderr))

    def test_version(self):
        self.assertRegex(run("--version").stdout, r"^swirl \d+\.\d+\.\d+")

    def test_tour_names_six_scenes(self):
        scenes = document("tour")
        self.assertEqual([v["mode"] for v in scenes.values()],
                         ["chaotic", "quasi-steady", "steady", "steady", "chaotic", "quasi-steady"])
        self.assertEqual(scenes["disk-that-rolls"]["kind"], "rolling-librating")


if __name__ == "__main__":
    unittest.main()
