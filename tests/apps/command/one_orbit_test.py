"""One scene and one seed are one orbit, to the bit, in every command: one_orbit_test.py SWIRL"""

import unittest

from driving import InFolder, document, run

#: Within chaos a last bit makes another orbit: with alpha = 0.46 a torus, with 0.45999999999999996 a fixed point.
SCENE = "--sides 12 --alpha 0.46 --beta 0.748 --restitution 1 --seed 2"
AROUND = SCENE.replace("--alpha 0.46", "--mu 0.8")
SHORT = "--transient 1000 --collisions 1000"


def spins(scene, count):
    return [impact["spin"] for impact in document(f"simulate {scene} --collisions {count}")["collisions"]]


class OneOrbit(InFolder):
    def test_points_of_a_grid_are_the_decimals_that_a_user_writes(self):
        cells = document(f"sweep {SCENE} --grid mu=0.1:1:10 --transient 0 --collisions 64 --quiet")["cells"]
        self.assertEqual([c["parameters"]["mu"] for c in cells], [i / 10 for i in range(1, 11)])
        columns = document(f"bifurcate {SCENE} --along mu=0.1:1:10 --starts 1 --transient 0 --collisions 64 --quiet")
        self.assertEqual([c["parameter"] for c in columns["columns"]], [i / 10 for i in range(1, 11)])

    def test_classify_simulate_sweep_and_bifurcate_follow_the_same_bits(self):
        scene = f"{SCENE} --mu 0.8"
        orbit = spins(scene, 2000)[1000:]
        verdict = document(f"classify {scene} {SHORT}")
        self.assertEqual((verdict["kind"], verdict["settings"]["transient"]), ("quasi-periodic", 1000))
        self.assertAlmostEqual(verdict["mean_S_per_impact"], sum(orbit) / 1000, delta=1e-14)
        cell = document(f"sweep {AROUND} --grid alpha=0.16:0.66:6 {SHORT} --quiet")["cells"][3]
        for key in ("mean_S", "mean_S_per_impact", "recurrence_rate", "largest_exponent"):
            self.assertEqual(cell[key], verdict[key], key)
        column = document(f"bifurcate {AROUND} --along alpha=0.16:0.66:6 --starts 1 {SHORT} --quiet")["columns"][3]
        self.assertEqual(column["S"], orbit)  # of a torus the samples themselves
        recurrence = document(f"recurrence {scene} {SHORT} --threshold 1e-6 --quiet")
        self.assertEqual(recurrence["RC"], verdict["recurrence_rate"])

    def test_a_scene_file_is_the_flags_in_all_digits(self):
        # 0.3 of a file is a double; in 113 bits it is the decimal 0.3 all the same, as the flag's. (Chaos shows it.)
        scene = {"sides": "6", "alpha": "0.3", "beta": "0.1", "mu": "0.1", "restitution": "1"}
        file = self.file("s.toml", "[scene]\n" + "".join(f"{k} = {v}\n" for k, v in scene.items()))
        flags = " ".join(f"--{k} {v}" for k, v in scene.items())
        more = "--collisions 40 --accuracy quad"
        self.assertEqual(document(f"simulate --scene {file} {more}"), document(f"simulate {flags} {more}"))


class Records(InFolder):
    def record(self, arguments, name="orbit.h5"):
        path = self.folder / name
        self.assertIn(run(f"simulate {arguments} --quiet -o {path}").returncode, (0, 3))
        return path

    def test_a_record_is_judged_on_the_impacts_that_it_holds(self):
        scene = f"{SCENE} --mu 0.8"
        record = self.record(f"{scene} --collisions 2000")
        judged, followed = document(f"classify {record}"), document(f"classify {scene} {SHORT}")
        self.assertEqual(judged, followed)
        self.assertEqual(judged["impacts"], 2001)  # the step on from the last one, too

    def test_what_skip_left_out_is_the_transient_and_a_thinned_record_the_same_orbit(self):
        scene = f"{SCENE} --mu 0.8"
        followed = document(f"classify {scene} {SHORT}")
        for flags in ("--skip 1000", "--skip 1000 --every 7"):
            self.assertEqual(document(f"classify {self.record(f'{scene} --collisions 2000 {flags}')}"), followed)

    def test_an_orbit_in_more_digits_is_judged_from_its_own_state(self):
        # The frictionless disk's S is constant: its other coordinates tell.
        for scene, names in (("--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1", "psi chi vn vt spin"),
                             ("--sides disk --alpha 0.4 --beta 0.5 --mu 0 --restitution 1", "psi vn vt spin")):
            record = self.record(f"{scene} --collisions 400 --accuracy quad")
            found = document(f"classify {record}")
            self.assertEqual(found["evidence"][-1]["name"], "orbit from the start repeats the record")
            state = document(f"simulate {scene} --collisions 201 --accuracy quad")["collisions"][-1]
            point = ",".join(repr(state[key]) for key in names.split())
            from_there = document(f"classify {scene} --point={point} --transient 0 --collisions 200")
            self.assertEqual((found["mean_S"], found["largest_exponent"]),
                             (from_there["mean_S"], from_there["largest_exponent"]))

    def test_too_few_impacts_are_bad_input(self):
        record = self.record(f"{SCENE} --mu 0.8 --collisions 100")
        for flags, needed in (("", "114"), ("--transient 10 --collisions 200", "210")):
            result = run(f"classify {record} {flags}")
            self.assertEqual((result.returncode, result.stdout), (2, ""))
            self.assertIn("holds 100 impacts", result.stderr)
            self.assertIn(needed, result.stderr)
        for command in ("spectrum", "recurrence"):
            self.assertIn("has 100 impacts; --transient 5000 and 1 or more after these need 5001", run(f"{command} {record} --transient 5000").stderr)

    def test_an_orbit_that_ended_is_judged_by_its_end(self):
        scene = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"
        found = document(f"classify {self.record(f'{scene} --collisions 1000')}")
        self.assertEqual((found["kind"], found["outcome"]), ("rolling-librating", "in-contact"))


if __name__ == "__main__":
    unittest.main()
