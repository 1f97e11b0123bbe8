"""--accuracy on every command that follows orbits: accuracy_test.py SWIRL

In more digits regular orbits are the same to rounding; another search for the contact makes other orbits, and is heeded
by each command.
"""

import unittest

from driving import InFolder, document, run

STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # of period 8
TORUS = "--sides 4 --alpha 0.52 --beta 0.46 --mu 0.6 --restitution 0.75"  # attracts
FAMILY = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"
NEAR_STEADY = "-0.0839,0.028,-0.5542,0.8898,-0.9793"
ON_FAMILY = "0,-0.5058,0.5152,-1.3842"  # a start far away comes to another member where a last bit differs
NEAR_CYCLE = "0.1094,0.0547,-0.3184,0.8533,-0.5619"  # past the chaos that leads there, where a last bit matters
SHORT = "--transient 600 --collisions 600"

#: The commands that hold scene and states in double, each with an orbit that settles at once.
COMMANDS = {
    "classify": f"classify {STEADY} --point={NEAR_STEADY} --transient 50 --collisions 64",
    "classify --runs": f"classify {STEADY} --runs 2 {SHORT}",
    "lyapunov": f"lyapunov {STEADY} --point={NEAR_STEADY} --transient 50 --collisions 200",
    "orbits": f"orbits {STEADY} --near={NEAR_STEADY}",
    "continue": f"continue {STEADY} --from={NEAR_STEADY} --along beta=0.49:0.51",
    "bifurcate": f"bifurcate {STEADY} --along beta=0.49:0.5:2 --starts 1 {SHORT}",
    "ramp": f"ramp {STEADY} --point={NEAR_STEADY} --along beta=0.5:0.49 --duration 100 --windows 4 --transient 200",
    "sweep": f"sweep {STEADY.replace('--beta 0.5', '')} --grid beta=0.49:0.5:2 {SHORT}",
}
#: Those that keep all digits.
OTHERS = {
    "simulate": f"simulate {STEADY} --collisions 20",
    "recurrence": f"recurrence {CYCLE} --transient 0 --collisions 100 --threshold 1e-3",
    "spectrum": f"spectrum {CYCLE} --transient 0 --collisions 100",
}


def without_settings(found):
    """What a document says beside its settings; sweep's and bifurcate's numbers of work vary with nothing else."""
    return {key: value for key, value in found.items() if key != "settings"}


def numbers_of(found):
    """All numbers of a document, in order, but for those that are rounding's own, and how long chaos lasted before."""
    if isinstance(found, dict):
        return [x for key, value in found.items() if key not in ("settings", "residual", "evidence", "distance", "impacts", "impacts_spent")
                for x in numbers_of(value)]
    if isinstance(found, list):
        return [x for value in found for x in numbers_of(value)]
    return [found] if isinstance(found, (int, float)) and not isinstance(found, bool) else []


class InMoreDigits(unittest.TestCase):
    def assert_near(self, first, second, tolerance, what):
        self.assertEqual(len(first), len(second), what)
        for a, b in zip(first, second):
            self.assertLess(abs(a - b), tolerance * (1 + abs(b)), what)

    def test_a_verdict_and_its_cycle_are_the_same(self):
        for scene, kind, period in ((f"{STEADY} --point={NEAR_STEADY}", "fixed-point", 1), (f"{CYCLE} --point={NEAR_CYCLE}", "cycle", 8),
                                    (TORUS, "quasi-periodic", None), (f"{FAMILY} --point={ON_FAMILY}", "family", 1)):
            plain = document(f"classify {scene} {SHORT}")
            self.assertEqual((plain["kind"], plain["period"]), (kind, period), scene)
            for accuracy in ("extended", "quad"):
                found = document(f"classify {scene} {SHORT} --accuracy {accuracy}")
                for key in ("mode", "kind", "period", "outcome", "impacts"):
                    self.assertEqual(found[key], plain[key], (scene, accuracy, key))
                self.assertEqual(found["settings"]["accuracy"], accuracy)
                if kind in ("fixed-point", "cycle"):  # isolated: not the member that rounding leads to
                    self.assert_near(found["point"], plain["point"], 1e-12, (scene, accuracy))
                    self.assertLess(abs(found["mean_S"] - plain["mean_S"]), 1e-12)
                else:  # neutral directions keep each rounding, over 1,200 impacts
                    self.assertLess(abs(found["mean_S"] - plain["mean_S"]), 1e-9)

    def test_every_command_finds_the_same(self):
        for name, arguments in COMMANDS.items():
            plain = document(f"{arguments} --quiet")
            self.assertEqual(plain["settings"]["accuracy"], "double", name)
            found = document(f"{arguments} --quiet --accuracy quad")
            self.assertEqual(found["settings"]["accuracy"], "quad", name)
            if name == "continue":  # steps along the branch are chosen by rounding's size, too: its ends are not
                ends = [numbers_of(branch["points"][i]) for branch in found["branches"] for i in (0, -1)]
                self.assert_near(sorted(map(tuple, ends))[0],
                                 sorted(tuple(numbers_of(b["points"][i])) for b in plain["branches"] for i in (0, -1))[0],
                                 1e-9, name)
                continue
            self.assert_near(numbers_of(found), numbers_of(plain), 1e-9, name)

    def test_extended_is_taken_by_every_command(self):
        for name, arguments in {**COMMANDS, **OTHERS}.items():
            self.assertEqual(document(f"{arguments} --quiet --accuracy extended")["settings"]["accuracy"], "extended", name)


class OtherSearches(InFolder):
    def test_each_command_heeds_the_name(self):
        for name, arguments in {**COMMANDS, **OTHERS}.items():
            plain = run(f"{arguments} --quiet --json")
            stepped = run(f"{arguments} --quiet --json --accuracy fixed-step")
            self.assertIn(stepped.returncode, (0, 3), (name, stepped.stderr))
            self.assertNotEqual(stepped.stdout.replace("fixed-step", "double"), plain.stdout, name)

    def test_the_papers_and_brents_are_right_where_contacts_are_far_apart(self):
        for name, arguments in COMMANDS.items():
            for accuracy in ("paper", "brent"):
                result = run(f"{arguments} --quiet --json --accuracy {accuracy}")
                self.assertEqual(result.returncode, 0, (name, accuracy, result.stderr))
        for accuracy in ("paper", "brent"):
            found = document(f"{COMMANDS['classify']} --accuracy {accuracy}")
            plain = document(COMMANDS["classify"])
            self.assertEqual(found["kind"], "fixed-point")
            for a, b in zip(found["point"], plain["point"]):
                self.assertLess(abs(a - b), 1e-10)  # the paper's contacts are short of the wall by up to 1e-13

    def test_no_fixed_point_of_the_exact_map_is_said_to_be_all_there_are(self):
        search = f"orbits {STEADY} --period 1 --starts 0 --trajectories 0"
        for accuracy, some in (("fixed-step", False), ("brent", True)):
            counts = document(f"{search} --accuracy {accuracy}")["fixed_points"]
            self.assertEqual(counts["found"] + counts["not_fixed"], 31)
            self.assertEqual((counts["found"] > 0, counts["complete"]), (some, counts["not_fixed"] == 0))
            shown = run(f"{search} --accuracy {accuracy}").stdout
            self.assertEqual("of the exact map's 31 fixed points" in shown, counts["not_fixed"] > 0, shown)

    def test_a_record_is_classified_in_the_accuracy_that_made_it(self):
        record = self.folder / "brent.h5"
        self.assertEqual(run(f"simulate {STEADY} --collisions 200 --accuracy brent --quiet -o {record}").returncode, 0)
        found = document(f"classify {record} --accuracy brent")
        self.assertNotIn("orbit from the start repeats the record", [e["name"] for e in found["evidence"]])

    def test_a_sweep_in_another_accuracy_is_another_sweep(self):
        record = self.folder / "sweep.h5"
        self.assertEqual(run(f"{COMMANDS['sweep']} --quiet -o {record}").returncode, 0)
        refused = run(f"{COMMANDS['sweep']} --quiet --accuracy quad -o {record}")
        self.assertEqual(refused.returncode, 2)
        self.assertIn("accuracy", refused.stderr)


class WrongNames(unittest.TestCase):
    def test_one_line_lists_what_is_allowed(self):
        for name, arguments in {**COMMANDS, **OTHERS, "tour": "tour"}.items():
            result = run(f"{arguments} --accuracy half")
            self.assertEqual((result.returncode, result.stdout), (2, ""), name)
            self.assertEqual(result.stderr.count("\n"), 1, name)
            self.assertIn("accuracy = half", result.stderr)
            for allowed in ("double", "quad", "paper", "brent", "fixed-step"):
                self.assertIn(allowed, result.stderr)

    def test_what_follows_no_orbit_refuses_another(self):
        for arguments in (f"describe {STEADY}", ):
            for accuracy in ("quad", "brent"):
                self.assertEqual(run(f"{arguments} --accuracy {accuracy}").returncode, 2)


if __name__ == "__main__":
    unittest.main()
