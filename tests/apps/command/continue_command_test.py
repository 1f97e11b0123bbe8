"""swirl continue, from outside: continue_command_test.py SWIRL"""

import json
import unittest

import xarray

from driving import Keeping, Refusing, document, run

HEXAGON = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
POINT = "-0.083922288419212287574,0.027966794811174552721,-0.55420644250323559488,0.88979354385790028771,-0.97926605821858726645"
SIXTEEN = "-0.026219269284145853,-0.2654954168157097,-0.8791296891707485,1.0811361378190747,-1.506037574690808"


class Continue(Refusing):
    def test_a_branch_with_its_special_points(self):
        branches = document(f"continue {HEXAGON} --from={POINT} --along alpha=0.1:0.9")["branches"]
        kinds = [s["kind"] for s in branches[0]["special"]]
        for kind in ("fold", "flip", "neimark-sacker"):
            self.assertIn(kind, kinds)
        for point in branches[0]["points"]:
            self.assertLessEqual(point["residual"], 1e-12)
            self.assertTrue(0.1 <= point["parameter"] <= 0.9)
        for special in branches[0]["special"]:
            moduli = [complex(*m) for m in special["multipliers"]]
            critical = {"fold": lambda m: abs(m - 1), "flip": lambda m: abs(m + 1),
                        "neimark-sacker": lambda m: abs(abs(m) - 1) if m.imag else 1}[special["kind"]]
            self.assertLess(min(map(critical, moduli)), 1e-6)
            self.assertEqual(set(special["point"]), {"psi", "chi", "vn", "vt", "S"})
            self.assertIsNotNone(special["normal_form"])
        doubled = branches[1]
        self.assertEqual((doubled["period"], doubled["begins"], doubled["switched_from"]), (2, "switched", 0))

    def test_the_disks_family_loses_its_stability(self):
        branch, = document("continue --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 "
                           "--from=0,-0.576,0.192,-0.305 --along tau=1:3")["branches"]
        special, = branch["special"]
        self.assertEqual(special["kind"], "neimark-sacker")
        self.assertAlmostEqual(special["parameter"], 2.33112237041442, delta=1e-8)

    def test_the_ends_of_the_range_are_on_the_branch(self):
        branch = document(f"continue {HEXAGON} --from={POINT} --along beta=0.48:0.52 --switch 0")["branches"][0]
        self.assertEqual(sorted({branch["points"][0]["parameter"], branch["points"][-1]["parameter"]}), [0.48, 0.52])
        self.assertEqual((branch["begins"], branch["ends"]), ("range", "range"))

    def test_a_family_at_the_end_of_the_range_is_not_followed(self):
        # At beta = 0 psi is free by symmetry.
        steady = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1 " \
                 "--from=0,0,-0.5161526339171516,0.917202293555976,-1.0430057338899403"
        branches = document(f"continue {steady} --along beta=0:1")["branches"]
        self.assertLess(len(branches), 5)
        for branch in branches:
            self.assertLess(sum(point["parameter"] < 1e-9 for point in branch["points"]), 3)
            self.assertLess(len(branch["points"]), 3000)

    def test_nothing_happens_where_friction_ends(self):
        steady = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 1 " \
                 "--from=0,0,-0.5161526339171516,0.917202293555976,-1.0430057338899403"
        branch = document(f"continue {steady} --along mu=0:1 --switch 0")["branches"][0]
        self.assertEqual([s["kind"] for s in branch["special"] if s["parameter"] < 1e-6], [])

    def test_the_record_holds_what_the_document_says(self):
        path = self.folder / "b.h5"
        branches = document(f"continue {HEXAGON} --from={POINT} --along alpha=0.01:0.99 -o {path}")["branches"]
        special = xarray.open_dataset(path, group="special", engine="h5netcdf")
        listed = [s for b in branches for s in b["special"]]
        self.assertEqual(list(special["kind"].values), [s["kind"] for s in listed])
        self.assertEqual([bool(x) for x in special["located"].values], [s.get("located", True) for s in listed])
        for row, s in enumerate(listed):
            if "normal_form" in s:
                self.assertEqual(special["form_nonlinear_re"].values[row], s["normal_form"]["nonlinear"][0])
            if "word_before" in s:
                self.assertEqual(special["word_before"].values[row] == "", s["word_before"] == [])
        ends = xarray.open_dataset(path, group="branch_ends", engine="h5netcdf")
        self.assertEqual(list(ends["ends"].values), [b["ends"] for b in branches])
        self.assertEqual(list(ends["switched_from"].values), [b.get("switched_from", -1) for b in branches])

    def test_nothing_there_is_exit_3(self):
        result = run(f"continue {HEXAGON} --from=1,0.1,-0.3,2,3 --period 5 --along alpha=0.3:0.5 --json")
        self.assertEqual(result.returncode, 3, result.stderr)
        self.assertEqual(json.loads(result.stdout)["branches"], [])

    def test_wrong_input(self):
        rest = f"continue {HEXAGON}"
        for extra, mention in [("--along alpha=0.3:0.5", "from"), (f"--from={POINT}", "along"),
                               (f"--from={POINT} --along alpha=0.5:0.6", "outside"),
                               (f"--from={POINT} --along sides=3:6", "NAME"), (f"--from={POINT} --along alpha=0.3:0.5:3", "A:B"),
                               (f"--from={POINT} --along alpha=0.3:x", "x"), (f"--from={POINT} --along alpha=0.4:0.4", "differ"),
                               ("--from=1,2,3 --along alpha=0.3:0.5", "numbers"),
                               (f"--from={POINT} --along alpha=0.3:0.5 --longest-step nan", "longest-step"),
                               (f"--from={POINT} --along alpha=0.3:0.5 --longest-step 2", "longest-step")]:
            self.refused(f"{rest} {extra}", mention)


class KeptBranches(Keeping):
    def test_a_branch_is_kept_as_far_as_it_came(self):
        """The branch of a cycle of period 16: 40,000 points, which took 20 s; ten are there after 0.1 s."""
        answer = self.interrupt(f"continue {HEXAGON} --from={SIXTEEN} --period 16 --switch 0 --along alpha=0.1:0.9 "
                                "--longest-step 1e-6", 1)
        self.assertGreater(len(answer["branches"][0]["points"]), 10)
        self.assertEqual(answer["branches"][0]["ends"], "stopped")
        self.assertEqual(self.samples("branches").sizes["point"], len(answer["branches"][0]["points"]))


if __name__ == "__main__":
    unittest.main(verbosity=2)
