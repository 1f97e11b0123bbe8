"""swirl show, and going on from what a record holds, from outside: show_command_test.py SWIRL

That every kind of record is shown whole is a part of command.records."""

import csv
import json
import re
import unittest

import h5py

from driving import Refusing, document, folder_of_module, made_records, run

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
COMMANDS = {
    "cycles": f"orbits {HEXAGON} --period 1",
    "modes": f"describe {HEXAGON}",
    "verdict": f"classify {HEXAGON}",
    "branch": f"continue {HEXAGON} --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.39:0.41 --switch 0",
    "map": "sweep --sides 6 --mu 0.5 --restitution 0.95 --beta 0.5 --grid alpha=0.3:0.5:2 --transient 100 --collisions 100",
}
#: A fixed point, and one of eight runs that is still in chaos.
SETTLING = "classify --sides 6 --alpha 0.5 --beta 0.54 --mu 0.5 --restitution 0.95 --runs 8"
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"


DOCUMENTED = ("cycles", "modes", "verdict")


def setUpModule():
    """Records, and of some commands the documents of the same runs."""
    global RECORDS, DOCUMENTS
    folder = folder_of_module()
    RECORDS = made_records({name: command for name, command in COMMANDS.items() if name not in DOCUMENTED}, folder)
    RECORDS.update({name: folder / f"{name}.h5" for name in DOCUMENTED})
    DOCUMENTS = {name: document(f"{COMMANDS[name]} --quiet -o {RECORDS[name]}") for name in DOCUMENTED}


def rows_of(text):
    """Of the printed table: the numbers of its rows."""
    return [int(number) for number in re.findall(r"^ +(\d+)  ", text, re.M)]


class Show(Refusing):
    def test_it_prints_what_made_it_and_numbers_the_rows(self):
        result = run(f"show {RECORDS['cycles']} --rows 40 --group orbits")
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        for words in ("Cycles of a swirled polygon", "written by swirl orbits", "orbits: 31 rows"):
            self.assertIn(words, result.stdout)
        self.assertLessEqual(max(map(len, result.stdout.splitlines())), 100)
        numbers = rows_of(result.stdout)
        self.assertEqual(numbers[:31], list(range(1, 32)))
        self.assertEqual(len(numbers) % 31, 0)  # several blocks of columns
        self.assertIn("scene: sides 6, alpha 0.4", run(f"show {RECORDS['cycles']}").stdout)
        few = run(f"show {RECORDS['cycles']} --rows 3 --group orbits").stdout
        self.assertIn("rows 1 to 3 of 31", few)
        self.assertEqual(set(rows_of(few)), {1, 2, 3})

    def test_json_has_what_the_record_has_by_the_documents_names(self):
        shown = document(f"show {RECORDS['cycles']}")
        found = DOCUMENTS["cycles"]
        self.assertEqual(shown["scene"], found["scene"])
        self.assertEqual(shown["record"]["command"], "orbits")
        self.assertEqual(shown["attributes"]["orbits_max_time"], 12)
        for orbit, row in zip(found["orbits"], shown["orbits"], strict=True):
            self.assertEqual(orbit["points"], row["points"])
            for key in ("period", "mean_S", "return_time", "stability", "residual"):
                self.assertEqual(orbit[key], row[key])
        verdict = document(f"show {RECORDS['verdict']}")["mode"]
        self.assertEqual([e["says"] for e in verdict["evidence"]], [e["says"] for e in DOCUMENTS["verdict"]["evidence"]])

    def test_csv_has_every_digit(self):
        path = self.folder / "cycles.csv"
        result = run(f"show {RECORDS['cycles']} --group orbits --csv {path}")
        self.assertEqual((result.returncode, result.stdout), (0, ""), result.stderr)
        lines = path.read_text().splitlines()
        head = [line for line in lines if line.startswith("#")]
        self.assertIn("# return_time [1/omega_s]: sum of the flights", head)
        self.assertIn("# scene alpha = 0.4", head)
        rows = list(csv.DictReader(lines[len(head):]))
        with h5py.File(RECORDS["cycles"]) as record:
            orbits = record["orbits"]
            self.assertEqual([float(row["points_S"]) for row in rows], list(orbits["points"][:, 0, 4]))
            self.assertEqual([float(row["multiplier_re_2"]) for row in rows], list(orbits["multiplier_re"][:, 1]))
            self.assertEqual([row["stability"] for row in rows], [x.decode() for x in orbits["stability"][:]])

    def test_csv_replaces_nothing_unasked(self):
        record = self.folder / "a.h5"
        record.write_bytes(RECORDS["cycles"].read_bytes())
        (self.folder / "there.csv").write_text("mine")
        (self.folder / "link.csv").symlink_to(record)
        for name, flags, mention in (("there.csv", "", "exists"), ("a.h5", "--force", "a.h5"), ("link.csv", "--force", "link.csv"),
                                     ("no/a.csv", "", "cannot create table")):
            result = run(f"show {record} --group orbits --csv {self.folder / name} {flags}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)
        self.assertEqual((self.folder / "there.csv").read_text(), "mine")
        self.assertEqual(record.read_bytes(), RECORDS["cycles"].read_bytes())
        self.assertEqual(run(f"show {record} --group orbits --csv {self.folder}/there.csv --force").returncode, 0)
        self.assertIn("points_psi", (self.folder / "there.csv").read_text())

    def test_a_map_keeps_to_the_columns(self):
        text = run(f"show {RECORDS['map']}").stdout
        self.assertLessEqual(max(map(len, text.splitlines())), 100)
        self.assertIn("kinds none fixed-point family", " ".join(text.split()))

    def test_wrong_input(self):
        several = RECORDS["map"]
        for flags, mention in ((f"{several} --csv a.csv", "choose one by --group"),
                               (f"{several} --group nothing", "no such group"),
                               (f"{several} --group nothing --json", "no such group"),
                               (f"{several} --group scene --csv a.csv", "no such table"),
                               (f"{several} --json --csv a.csv", "--csv and --json"),
                               (f"{several} --rows 0", "rows"), (f"{several} --force", "--csv"), ("missing.h5", "missing.h5")):
            result = run(f"show {flags}", cwd=self.folder)
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), (flags, result.stderr))
            self.assertIn(mention, result.stderr)
        self.assertEqual(list(self.folder.iterdir()), [])


class GoOn(Refusing):
    def through(self, document, spin):
        """Does a branch pass the cycle, at the scene's own alpha?"""
        points = document["branches"][0]["points"]
        return min(abs(p["point"]["S"] - spin) + abs(p["parameter"] - 0.4) for p in points) < 1e-9

    def test_continue_from_a_records_cycle(self):
        spins = [orbit["points"][0]["S"] for orbit in DOCUMENTS["cycles"]["orbits"]]
        for name, spins in (("cycles", spins), ("modes", [m["S"] for m in DOCUMENTS["modes"]["steady_modes"]])):
            for number in (1, 4):
                found = document(f"continue {RECORDS[name]} --orbit {number} --along alpha=0.399:0.401 --switch 0")
                self.assertEqual(found["scene"]["beta"], 0.5)
                self.assertTrue(self.through(found, spins[number - 1]), (name, number))
                again = document(f"continue {HEXAGON} --from={found['settings']['from']} --along alpha=0.399:0.401 --switch 0")
                self.assertTrue(self.through(again, spins[number - 1]))

    def test_continue_from_a_point_of_a_branch_has_that_points_parameter(self):
        with h5py.File(RECORDS["branch"]) as record:
            alpha, spin = record["branches/parameter"][2], record["branches/points"][2, 0, 4]
        found = document(f"continue {RECORDS['branch']} --orbit 3 --along beta=0.499:0.501 --switch 0")
        self.assertEqual(found["scene"]["alpha"], alpha)
        self.assertLess(min(abs(p["point"]["S"] - spin) for p in found["branches"][0]["points"]), 1e-9)

    def test_from_what_the_start_settles_on(self):
        verdict = DOCUMENTS["verdict"]
        self.assertEqual(list(verdict["section_point"].values()), verdict["point"])
        self.assertEqual(list(verdict["section_point"]), ["psi", "chi", "vn", "vt", "S"])
        for command in (f"continue {HEXAGON} --from attractor", f"continue {RECORDS['verdict']}"):
            found = document(f"{command} --along alpha=0.399:0.401 --switch 0")
            self.assertEqual(found["settings"]["period"], verdict["period"])
            self.assertTrue(self.through(found, verdict["point"][4]), command)
        proven, = document(f"certify {HEXAGON} --from attractor")["orbits"]
        self.assertTrue(proven["proven"])
        self.assertLess(abs(proven["point"]["S"] - verdict["point"][4]), 1e-9)

    def test_a_start_that_settles_on_no_cycle(self):
        for command in ("continue --along beta=0.4:0.6", "certify"):
            result = run(f"{command} {CHAOTIC} --from attractor --json")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (3, 1), result.stderr)
            self.assertIn("settles on no cycle", result.stderr)
            self.assertEqual(json.loads(result.stdout).get("branches", []), [])

    def test_certify_one_cycle_of_a_record(self):
        found = document(f"certify {RECORDS['cycles']} --orbit 3")["orbits"]
        self.assertEqual(len(found), 1)
        with h5py.File(RECORDS["cycles"]) as record:
            self.assertLess(abs(found[0]["point"]["S"] - record["orbits/points"][2, 0, 4]), 1e-9)
        self.assertTrue(found[0]["proven"])
        self.assertRegex(run(f"certify {RECORDS['modes']} --orbit 3").stdout, r"\n +3 +1 ")

    def test_the_cycles_among_the_attractors_of_several_runs(self):
        record = self.folder / "runs.h5"
        found = document(f"{SETTLING} --quiet -o {record}")["attractors"]
        self.assertEqual([(a["kind"], a["point"] is None) for a in found], [("fixed-point", False), ("transient", True)])
        text = run(SETTLING).stdout
        self.assertRegex(text, r"\n +1 +87\.50 % +steady +fixed-point .*\n +2 +12\.50 % +undecided +transient ")
        point, = re.findall(r"  points psi,chi,vn,vt,S:\n +1  (\S+)\n  to go on", text)
        self.assertEqual([float(f"{x:.12g}") for x in found[0]["point"].values()], [float(x) for x in point.split(",")])
        branch = document(f"continue {record} --orbit 1 --along beta=0.539:0.541 --switch 0")["branches"][0]["points"]
        self.assertLess(min(abs(p["point"]["S"] - found[0]["mean_S"]) + abs(p["parameter"] - 0.54) for p in branch), 1e-9)
        self.assertEqual([orbit["proven"] for orbit in document(f"certify {record}")["orbits"]], [True])
        for flags, mention in (("--orbit 2", "attractor 2 of record"), ("--orbit 3", "the cycles 1 to 2")):
            for command in ("certify", "continue --along beta=0.53:0.55"):
                result = run(f"{command} {record} {flags}")
                self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), result.stderr)
                self.assertIn(mention, result.stderr)
        self.assertEqual(run(f"classify {CHAOTIC} --runs 2 --transient 100 --collisions 100 --quiet -o {record}").returncode, 0)
        self.assertIn("holds no cycles: its attractors are chaotic", run(f"certify {record}").stderr)

    def test_stable_cycles_alone(self):
        every = DOCUMENTS["cycles"]["orbits"]
        stable = [orbit for orbit in every if orbit["stability"] == "stable"]
        self.assertTrue(0 < len(stable) < len(every))
        found = document(COMMANDS["cycles"] + " --stable")
        self.assertEqual(found["orbits"], stable)
        self.assertIn(f"{len(every) - len(stable)} cycles are left out", found["limits"][-1])

    def test_tables_number_the_cycles(self):
        for name in ("cycles", "modes"):
            self.assertEqual(rows_of(run(COMMANDS[name]).stdout), list(range(1, 32)))

    def test_wrong_input(self):
        cycles, sweep = RECORDS["cycles"], RECORDS["map"]
        for flags, mention in ((f"{cycles}", "choose one by --orbit I, 1 to 31"), (f"{cycles} --orbit 32", "the cycles 1 to 31"),
                               (f"{cycles} --orbit 0", "orbit"), (f"{sweep} --orbit 1", "holds no cycles"),
                               (f"{cycles} --orbit 1 {HEXAGON}", "the record has its own"), (f"{cycles} --orbit 1 --period 1", "--period"),
                               (f"{HEXAGON} --orbit 1 --from attractor", "--orbit"), (f"{HEXAGON} --from=0,0,0,0,0 --seed 3", "start")):
            self.refused(f"continue {flags} --along alpha=0.39:0.41", mention)
        copied = self.folder / "a.h5"
        copied.write_bytes(cycles.read_bytes())
        self.assertEqual(run(f"continue {copied} --orbit 1 --along alpha=0.39:0.41 -o {copied} --force").returncode, 2)
        self.assertEqual(copied.read_bytes(), cycles.read_bytes())
        for flags, mention in ((f"{cycles} --orbit 32", "the cycles 1 to 31"), (f"{sweep}", "holds no cycles"),
                               (f"{HEXAGON} --all --orbit 1", "--orbit"), ("--check c.json --orbit 1", "all cycles of a certificate"), (f"{HEXAGON} --from nowhere", "attractor")):
            result = run(f"certify {flags}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)


if __name__ == "__main__":
    unittest.main()
