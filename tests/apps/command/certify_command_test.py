"""swirl certify, from outside: certify_command_test.py SWIRL REFERENCES [EDITS]"""

import json
import random
import re
import signal
import subprocess
import sys
import time
import unittest
from pathlib import Path

from certificates import with_new_checksum
from driving import SWIRL, InFolder, document, run, start, wait_until_it_listens

REFERENCES = Path(sys.argv.pop(1))
EDITS = int(sys.argv.pop(1)) if len(sys.argv) > 1 and sys.argv[1].isdigit() else 40

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
STABLE = "--near=-0.08392228841921229,0.02796679481117455,-0.5542064425032355,0.8897935438579003,-0.9792660582185873"


class Certify(InFolder):
    def certificate(self, arguments=f"{HEXAGON} {STABLE}"):
        file = self.folder / "cert.json"
        self.assertEqual(run(f"certify {arguments} -o {file} --force --quiet").returncode, 0)
        return file

    def refused(self, text, codes):
        result = run(f"certify --check {self.file('edited.json', text)} --quiet")
        self.assertIn(result.returncode, codes, text[:3000])

    def test_a_fixed_point_is_proven_and_its_certificate_holds(self):
        found = document(f"certify {HEXAGON} {STABLE}")
        orbit = found["orbits"][0]
        self.assertEqual((orbit["period"], orbit["proven"], orbit["stability"], orbit["reason"]),
                         (1, True, "attracting", None))
        self.assertTrue(0 < orbit["radius"] < 1e-8)
        self.assertEqual([len(m) for m in orbit["multipliers"]], [3] * 5)
        known = json.loads((REFERENCES / "fixed_points.json").read_text())["cycles"][1]
        for key, value in known["point"].items():
            self.assertLessEqual(abs(float(value) - orbit["point"][key]), orbit["steps"][0]["half_widths"][key])
        self.assertEqual(orbit["multipliers"][-1], [0, 0, 0])  # it sticks
        again = document(f"certify --check {self.certificate()}")
        self.assertEqual((again["stated"], again["proven"], again["reason"]), (1, 1, None))
        self.assertEqual(json.loads(self.certificate().read_text()), found)  # the document is the certificate

    def test_a_certificate_edited_in_one_digit_is_refused(self):
        text = self.certificate().read_text()
        places = [m.start() for m in re.finditer(r"\d", text)]
        draw = random.Random(1)
        for place in draw.sample(places, min(EDITS, len(places))):
            digit = draw.choice([d for d in "0123456789" if d != text[place]])
            self.refused(text[:place] + digit + text[place + 1:], (2,))

    def test_an_edit_with_a_new_checksum_has_to_be_true(self):
        text = self.certificate().read_text()
        self.assertEqual(with_new_checksum(text), text)
        whole = json.loads(text)

        def edited(old, new):
            self.assertIn(old, text)
            self.refused(with_new_checksum(text.replace(old, new, 1)), (2, 3))

        edited('"alpha": 0.4', '"alpha": 0.40001')
        edited('"beta": 0.5', '"beta": 0.5001')
        edited('"restitution": 0.9', '"restitution": 0.91')
        edited('"sides": 6', '"sides": 7')
        edited('"law": "poisson"', '"law": "newton"')
        edited('"period": 1', '"period": 2')
        edited('"vertex_step": 2', '"vertex_step": 3')
        edited('"contact_mode": "c-sticking"', '"contact_mode": "r-sticking"')
        edited('"attracting"', '"repelling"')
        orbit = whole["orbits"][0]
        re0 = json.dumps(orbit["multipliers"][0][0])
        edited(re0, json.dumps(orbit["multipliers"][0][0] + 1e-6))
        edited(json.dumps(orbit["steps"][0]["flight_time"]), json.dumps(orbit["steps"][0]["flight_time"] + 1e-6))
        for key in ("psi", "chi", "vn", "vt", "S"):  # twice in the text: the point and the step's
            value = orbit["point"][key]
            self.refused(with_new_checksum(text.replace(json.dumps(value), json.dumps(value + 1e-6))), (3,))

    def test_what_its_reader_would_cut_off_or_leave_out_is_no_certificate(self):
        text = run(f"certify {HEXAGON} {STABLE} --json").stdout
        path = self.folder / "c.json"
        for old, new in (('"sides": 6', '"sides": 6.9'), ('"vertex_step": 2', '"vertex_step": 2.7'),
                         ('"period": 1', '"period": 1.5'), ('"period": 1', '"period": 4294967297'),
                         ('"sides": 6', '"sides": 4294967302'), ('"uniform lamina"', '"banana"'),
                         ('"alpha": 0.4', '"alpha": 0.7, "alpha": 0.4')):
            self.assertIn(old, text)
            path.write_text(with_new_checksum(text.replace(old, new, 1)))
            result = run(f"certify --check {path}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), (new, result.stderr))

    def test_a_check_that_is_interrupted_says_so(self):
        stated = json.loads(self.certificate().read_text())
        stated.pop("checksum")
        count = 4000  # some five seconds' work
        stated["orbits"] = stated["orbits"] * count
        file = self.file("many.json", with_new_checksum(json.dumps(stated)[:-1] + ',\n  "checksum"'))
        for delay in (0.8, 1.6, 3.2, 6.4, 12.8):  # while the file is still read a signal ends the program, without a document
            process = start(f"certify --check {file} --json", stdout=subprocess.PIPE)
            time.sleep(delay)
            process.send_signal(signal.SIGINT)
            said, _ = process.communicate(timeout=60)
            if process.returncode == 130 and said:
                break
        self.assertEqual(process.returncode, 130)
        self.assertTrue(said)
        found = json.loads(said)
        self.assertEqual((found["stated"], found["outcome"], found["reason"]), (count, "interrupted", "the check was stopped"))
        self.assertLess(found["proven"], count)

    def test_a_file_that_is_no_certificate_is_bad_input(self):
        for content in ("", "{}", "no json", '{"certificate": "swirl"}', json.dumps({"orbits": []})):
            result = run(f"certify --check {self.file('x.json', content)}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), content)

    def test_all_fixed_points_are_thirty_one(self):
        found = document(f"certify {HEXAGON} --all --period 1 --max-time 12")
        self.assertEqual((found["all"]["complete"], found["all"]["found"], len(found["orbits"])), (True, 31, 31))
        self.assertTrue(all(o["proven"] for o in found["orbits"]))
        self.assertEqual(found["all"]["open"], [])

    def test_the_cycles_of_a_record(self):
        record = self.folder / "orbits.h5"
        run(f"orbits {HEXAGON} --max-period 2 --starts 200 --trajectories 4 --quiet -o {record}")
        listed = document(f"certify {record}", 0)
        self.assertGreater(len(listed["orbits"]), 31)
        self.assertEqual(listed["proven"], len(listed["orbits"]))
        self.assertEqual({o["period"] for o in listed["orbits"]}, {1, 2})

    def test_the_branches_of_a_record(self):
        record = self.folder / "branch.h5"
        run(f"continue {HEXAGON} --from={STABLE[7:]} --along alpha=0.39:0.41 --quiet -o {record}")
        result = run(f"certify {record} --json")
        found = json.loads(result.stdout)
        self.assertGreaterEqual(found["proven"], 0.9 * len(found["orbits"]), result.stdout[:2000])
        values = {o["parameters"]["alpha"] for o in found["orbits"]}
        self.assertEqual(len(values), len(found["orbits"]))

    def test_the_branches_of_a_diagram(self):
        record = self.folder / "diagram.h5"
        run("bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.9 --along alpha=0.39:0.41:3 --starts 2 --branches "
            f"--longest-branch 1 --quiet -o {record}")
        found = json.loads(run(f"certify {record} --json").stdout)
        self.assertGreaterEqual(len(found["orbits"]), 3)
        self.assertGreaterEqual(found["proven"], 0.9 * len(found["orbits"]))
        self.assertTrue(all(0.39 <= o["parameters"]["alpha"] <= 0.41 for o in found["orbits"]))

    def test_what_is_said_of_a_branch_is_what_its_boxes_say(self):
        file = self.certificate(f"{HEXAGON} {STABLE} --along alpha=0.4:0.42")
        whole = json.loads(file.read_text())
        self.assertEqual([(one["kind"], one["proven"]) for one in whole["branches"][0]["special"]], [("neimark-sacker", True)])
        branch, place = ["branches", 0], ["branches", 0, "special", 0]
        for path, value in (([*branch, "stability", 0, "stability"], "saddle"), ([*branch, "stability"], []), ([*place, "kind"], "flip"),
                            ([*place, "kind"], "fold"), ([*place, "box"], {}), ([*place, "outside_before"], 2),
                            ([*place, "outside_after"], 0), ([*branch, "special"], []), (["boxes"], whole["boxes"] + 1)):
            edited = json.loads(file.read_text())
            inner = edited
            for key in path[:-1]:
                inner = inner[key]
            inner[path[-1]] = value
            (self.folder / "edited.json").write_text(with_new_checksum(json.dumps(edited, indent=2)))
            result = run(f"certify --check {self.folder / 'edited.json'}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), (path, value, result.stderr))
        # What only the equations tell.
        for key, value in (("box", {"alpha": [0.41, 0.412]}), ("within", 1e-19), ("angle", [0.1, 0.2]), ("middle", [0.1] * 7)):
            edited = json.loads(file.read_text())
            edited["branches"][0]["special"][0][key] = value
            self.refused(with_new_checksum(json.dumps(edited, indent=2)), (3,))
        (self.folder / "edited.json").write_text(with_new_checksum(json.dumps(whole, indent=2)))
        self.assertEqual(run(f"certify --check {self.folder / 'edited.json'}").returncode, 0)

    def test_a_range_of_a_branch_is_wide_and_the_scenes(self):
        for along, words in (("alpha=0.4:0.40001", "a range of 0.0001 or more is wanted"), ("alpha=0.3:1.5", "alpha = 1.5 is outside its range"),
                             ("restitution=0.85:1.2", "restitution = 1.2 is outside its range")):
            result = run(f"certify {HEXAGON} {STABLE} --along {along}")
            self.assertEqual((result.returncode, len(result.stderr.splitlines())), (2, 1), (along, result.stderr))
            self.assertIn(words, result.stderr)

    def test_a_branch_is_proven_along_a_parameter_and_its_certificate_holds(self):
        file = self.certificate(f"{HEXAGON} {STABLE} --along alpha=0.39:0.41")
        found = json.loads(file.read_text())
        branch = found["branches"][0]
        self.assertEqual((found["proven"], branch["proven"], branch["range"]), (1, True, [0.39, 0.41]))
        self.assertEqual({s["stability"] for s in branch["stability"]}, {"attracting"})
        self.assertEqual([(e["kind"], e["proven"]) for e in branch["ends"]], [("range", True)] * 2)
        again = document(f"certify --check {file}")
        self.assertEqual((again["stated"], again["proven"], again["reason"]), (1, 1, None))
        text = file.read_text()
        edited, count = re.subn(r'"outside": 0,(\s*)"inside": 5', r'"outside": 1,\1"inside": 4', text)
        self.assertEqual(count, found["boxes"])
        edited = edited.replace('"attracting"', '"saddle"')  # all of it agrees, and is false
        self.refused(with_new_checksum(edited), (3,))

    def test_the_branches_of_a_record_are_covered(self):
        record = self.folder / "branch.h5"
        run(f"continue {HEXAGON} --from={STABLE[7:]} --along alpha=0.39:0.41 --quiet -o {record}")
        found = document(f"certify {record} --branches")
        self.assertGreaterEqual(found["proven_share"], 0.97)

    def test_a_branch_of_a_record_is_proven_to_where_it_ends_beyond_the_record(self):
        record = self.folder / "branch.h5"
        point = "-3.1394923622695364,0.0021002820554532,-0.0400900807191914,0.0883665218445566,-1.470916791839276"
        ran = document(f"continue {HEXAGON} --from={point} --along alpha=0.395:0.6 -o {record}")
        last = max(one["parameter"] for one in ran["branches"][0]["points"])
        self.assertLess(last, 0.499999)
        found = document(f"certify {record} --branches")
        self.assertEqual(found["along"]["alpha"], [0.395, 0.6])
        end = found["branches"][0]["ends"][1]
        low, high = end["box"]["alpha"]
        self.assertEqual((end["kind"], end["proven"]), ("contact-mode", True))
        self.assertTrue(last < low <= 0.5 <= high < 0.50001, (last, low, high))  # it touches where beta = 1 - alpha

    def test_what_an_interruption_leaves_is_a_certificate(self):
        record, certificate = self.folder / "diagram.h5", self.folder / "c.json"
        run("bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.3:0.7:100 --starts 2 --branches "
            f"--quiet -o {record}")
        process = subprocess.Popen([SWIRL, "certify", str(record), "-o", str(certificate), "--quiet", "--threads", "1"])
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        self.assertEqual(process.wait(60), 130)
        found = json.loads(certificate.read_text())
        self.assertEqual((found["outcome"], found["proven"] > 0), ("interrupted", True))
        self.assertEqual(document(f"certify --check {certificate}")["outcome"], "interrupted")
        # --all, too, and in time, in whatever part of it.
        for after in (0.3, 0.8, 1.5):
            process = subprocess.Popen([SWIRL, "certify", *HEXAGON.split(), "--all", "--max-time", "200", "-o", str(certificate),
                                        "--quiet"])
            wait_until_it_listens(process)
            time.sleep(after)
            process.send_signal(signal.SIGINT)
            self.assertEqual(process.wait(60), 130)
            found = json.loads(certificate.read_text())
            self.assertEqual(found["outcome"], "interrupted", after)
            self.assertFalse(found["all"] and found["all"]["complete"], after)  # None: before the search began
            certificate.unlink()

    def test_where_the_two_branches_that_slip_meet_their_lines_stay_open(self):
        found = document("certify --sides 3 --alpha 0.3 --beta 0.6 --mu 0.75 --restitution 0.9 --all --max-time 1", 3)
        lines = [part for part in found["all"]["open"] if "branches" in part["reason"]]
        self.assertEqual(len(lines), 2)
        for part in lines:
            self.assertLess(part["phi"][0], part["phi"][1])

    def test_bad_input(self):
        other = self.file("other.txt", "mine\n")
        for flags in ("", f"{HEXAGON}", f"{HEXAGON} {STABLE} --all", f"{HEXAGON} --all --period 2",
                      f"{HEXAGON} --all --max-time 0", f"{HEXAGON} --all --max-time nan", f"{HEXAGON} {STABLE} --max-time 3",
                      f"{HEXAGON} {STABLE} --accuracy quad", f"{other}", f"--check {other}", f"--check {self.folder}/none",
                      f"{HEXAGON} {STABLE} -o {other}", "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --all"):
            result = run(f"certify {flags}")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1),
                             (flags, result.stderr))
        self.assertEqual(other.read_text(), "mine\n")

    def test_none_exist_is_an_answer(self):
        found = document("certify --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 0.9 --all")
        self.assertEqual((found["orbits"], found["all"]["complete"]), ([], True))
        self.assertIn("disk", found["all"]["none_exist"])


if __name__ == "__main__":
    unittest.main()
