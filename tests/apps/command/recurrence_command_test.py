"""swirl recurrence, from outside: recurrence_command_test.py SWIRL REFERENCES"""

import math
import json
import re
import sys
import tempfile
import unittest
from pathlib import Path

import xarray

from driving import InFolder, document, run

REFERENCES = Path(sys.argv.pop(1)).resolve()
STEADY = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # of period 8
CHAOTIC = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"
CHATTER = "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9"
MEASURES = "RR DET L Lmax DIV ENTR LAM TT Vmax VENTR MRT RTE TREND RC".split()
GOLDEN = (math.sqrt(5) - 1) / 2


class RandomPairs(InFolder):
    ROSSLER = f"--series {REFERENCES / 'rossler_3000.txt'} --dimension 3 --delay 6 --threshold 1.2"

    def test_an_estimate_lies_by_the_exact_measures_and_says_what_it_is(self):
        exact = document(f"recurrence {self.ROSSLER}")
        for seed in (1, 2, 3):
            found = document(f"recurrence {self.ROSSLER} --sample-pairs 100000 --sample-seed {seed}")
            errors = found["standard_errors"]
            self.assertEqual(list(errors), ["RR", "DET", "L", "LAM", "TT", "RC", "RC_without_diagonal"])
            for name, error in errors.items():
                self.assertGreater(error, 0, name)
                self.assertLess(abs(found[name] - exact[name]), 4.5 * error, (name, seed))
            for name in "Lmax DIV ENTR Vmax VENTR MRT RTE TREND".split():
                self.assertIsNone(found[name], name)
            self.assertEqual((found["pairs_sampled"], found["settings"]["sample_pairs"], found["settings"]["sample_seed"]),
                             (100_000, 100_000, seed))
            self.assertAlmostEqual(found["pairs_recurrent"] / 100_000, found["RR"], places=12)
            self.assertTrue(any("estimated from 100000 random pairs" in note for note in found["notes"]))
            self.assertTrue(any("all pairs of 2988 points are counted as fast" in note for note in found["notes"]))
        self.assertNotIn("standard_errors", exact)

    def test_threads_change_nothing_and_people_see_errors(self):
        command = f"recurrence {self.ROSSLER} --sample-pairs 20000"
        one, three = (run(f"{command} --json --threads {threads}").stdout for threads in (1, 3))
        self.assertEqual(one, three)
        shown = dict(re.findall(r"^(\w+) +([\d.]+ \+- [\d.]+)$", run(command).stdout, re.M))
        found = json.loads(one)
        self.assertEqual(list(shown), list(found["standard_errors"]))
        for name, text in shown.items():  # as many decimals as the error leaves
            value, error = text.split(" +- ")
            self.assertEqual(len(value.split(".")[1]), len(error.split(".")[1]), text)
            self.assertLess(abs(float(error) / found["standard_errors"][name] - 1), 0.4, text)
            self.assertLess(abs(float(value) - found[name]), found["standard_errors"][name], text)

    def test_what_needs_all_pairs_is_refused(self):
        for extra, mention in (("--image 20 --json", "--image"), ("--threshold 1,2", "one threshold"), ("--theiler 0", "theiler"),
                               ("--convention pyunicorn", "window"), ("--border-lines discarded", "border-lines"),
                               ("--cross-column 1", "--cross"), ("--sample-pairs 0", "sample-pairs"), ("--sample-pairs 999", "1000"),
                               ("--sample-seed -1", "--sample-seed: -1 is outside its range: 0 to 18446744073709551615")):
            base = self.ROSSLER if "--threshold" not in extra else self.ROSSLER.replace("--threshold 1.2", "")
            result = run(f"recurrence {base} {'' if 'sample' in extra else '--sample-pairs 1000'} {extra}")
            self.assertEqual((result.returncode, result.stdout, result.stderr.count("\n")), (2, "", 1), (extra, result.stderr))
            self.assertIn(mention, result.stderr)
        result = run(f"recurrence {self.ROSSLER} --sample-seed 4")
        self.assertEqual((result.returncode, result.stderr.count("\n")), (2, 1))


class PublishedRecurrence(unittest.TestCase):
    """RecurrenceAnalysis.jl's tests, which were checked against the CRP Toolbox (tests/references/README.md)."""

    def check(self, arguments, published):
        found = document(f"recurrence {arguments} --dimension 3 --delay 6 --threshold 1.2")
        for name, value in published.items():
            # 16 printed digits of a sum of some hundred terms: a few tens of epsilon.
            self.assertLessEqual(abs(found[name] - value), 50 * sys.float_info.epsilon * abs(value), (arguments, name))
        return found

    def test_rossler_250(self):
        file = REFERENCES / "rossler_250.txt"
        found = self.check(f"--series {file}", {
            "RR": 0.03808105520689288, "DET": 0.9990689013035382, "L": 18.1864406779661, "Lmax": 237,
            "ENTR": 3.044979404476836, "LAM": 0.9548417132216015, "TT": 3.8408239700374533})
        self.assertEqual(set(MEASURES) - set(found), set())
        self.assertEqual(found["settings"]["theiler"], 1)
        self.check(f"--series {file} --norm maximum", {
            "RR": 0.05485232067510549, "DET": 0.9941822882999354, "L": 17.477272727272727,
            "ENTR": 3.1418178182603116, "LAM": 0.9786683904330963, "TT": 4.791139240506329})

    def test_rossler_3000(self):
        file = REFERENCES / "rossler_3000.txt"
        self.check(f"--series {file}", {
            "RR": 0.034497548278147744, "DET": 0.998194195442617, "L": 18.085206543485935, "Lmax": 758,
            "ENTR": 3.6108687203622942, "LAM": 0.9889573102606075, "TT": 5.380358341873697})
        self.check(f"--series {file} --rate-pairs all", {"RR": 0.034486002913931495})

    def test_rossler_has_one_answer_whatever_the_threads_and_the_file_looks_like(self):
        values = (REFERENCES / "rossler_250.txt").read_text().split()
        arguments = "--dimension 3 --delay 6 --threshold 1.2"
        expected = document(f"recurrence --series {REFERENCES / 'rossler_250.txt'} {arguments} --threads 1")
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "a.csv"
            file.write_bytes("".join(f'"{i * 0.5}";"{v}";text\r\n' for i, v in enumerate(values)).encode())
            found = document(f"recurrence --series {file} --column 2 {arguments} --threads 2")
        for name in MEASURES:
            self.assertEqual(found[name], expected[name], name)


class RecurrenceOfOrbits(InFolder):
    def test_a_cycle_of_k_values_has_rc_one_over_k(self):
        found = document(f"recurrence {CYCLE} --collisions 2000 --threshold 1e-6")
        self.assertAlmostEqual(found["RC"], 1 / 8, delta=1e-15)
        self.assertEqual((found["DET"], found["Lmax"], found["outcome"]), (1, 2000 - 8, "completed"))
        whole = document(f"recurrence {CYCLE} --collisions 2000 --threshold 1e-6 --theiler 0")
        self.assertEqual(whole["MRT"], 7)  # single points 8 apart: 7 between them, as RecurrenceAnalysis.jl counts

    def test_a_steady_orbit_recurs_everywhere_and_the_document_says_which_threshold_that_was(self):
        found = document(f"recurrence {STEADY} --collisions 500")
        self.assertEqual((found["RR"], found["RC"], found["LAM"]), (1, 1, found["DET"]))
        self.assertTrue(found["settings"]["threshold_is_rounding_floor"])
        self.assertEqual(document(f"recurrence {STEADY} --collisions 500 --threshold 1e-6")["RR"], 1)

    def test_chaos_has_short_lines(self):
        found = document(f"recurrence {CHAOTIC} --collisions 2000 --observable psi,chi,vn,vt,S")
        self.assertLess(found["DET"], 0.5)
        self.assertLess(found["Lmax"], 100)

    def test_a_record_gives_what_its_scene_gives(self):
        record = self.folder / "orbit.h5"
        self.assertEqual(run(f"simulate {CHAOTIC} --collisions 600 --quiet -o {record}").returncode, 0)
        for rest in ("", "--observable psi,vt --threshold 0.2", "--observable x --dimension 2 --delay 3"):
            scene = document(f"recurrence {CHAOTIC} --transient 100 --collisions 500 {rest}")
            for way in (f"{record}", f"--record {record}"):
                found = document(f"recurrence {way} --transient 100 {rest}")
                for key in (*MEASURES, "scene", "start"):
                    self.assertEqual(found[key], scene[key], (rest, key))

    def test_angles_are_compared_as_angles(self):
        turned = [((i * GOLDEN) % 1) * 360 for i in range(300)]
        across = self.series("angle.csv", turned)
        shifted = self.series("shifted.csv", [(v + 180) % 360 for v in turned])
        for name in ("RR", "DET", "LAM", "RC"):
            found = [document(f"recurrence --series {f} --period 360 --threshold 10")[name] for f in (across, shifted)]
            self.assertAlmostEqual(found[0], found[1], delta=1e-12)
        plain = document(f"recurrence --series {across} --threshold 10")
        self.assertLess(plain["RR"], document(f"recurrence --series {across} --period 360 --threshold 10")["RR"])

    def test_chatter_is_told_with_exit_3_and_what_there_was_is_quantified(self):
        none = document(f"recurrence {CHATTER}", 3)
        self.assertEqual(none["outcome"], "in-contact")
        self.assertTrue(all(none[name] is None for name in MEASURES))
        some = document(f"recurrence {CHATTER} --transient 0", 3)
        self.assertEqual((some["outcome"], some["settings"]["points"]), ("in-contact", some["impacts"]))
        self.assertIsNotNone(some["RR"])

    def test_several_thresholds_in_one_pass_are_those_one_by_one(self):
        file = REFERENCES / "rossler_250.txt"
        for flag in ("threshold", "threshold-std", "recurrence-rate"):
            together = document(f"recurrence --series {file} --{flag} 0.3,0.1 --{flag} 0.05")
            self.assertEqual(len(together["thresholds"]), 3)
            for i, value in enumerate(("0.3", "0.1", "0.05")):
                alone = document(f"recurrence --series {file} --{flag} {value}")
                self.assertEqual([together[name][i] for name in MEASURES], [alone[name] for name in MEASURES])
                self.assertEqual(together["thresholds"][i], alone["settings"]["threshold"])
        rate = document(f"recurrence --series {file} --recurrence-rate 0.05")
        self.assertAlmostEqual(rate["RR"], 0.05, delta=1 / (250 * 249 / 2))

    def test_conventions_are_the_packages(self):
        file, flags = REFERENCES / "rossler_250.txt", "--dimension 3 --delay 6 --threshold 1.2"
        ours = document(f"recurrence --series {file} {flags}")
        same = document(f"recurrence --series {file} {flags} --convention recurrenceanalysis.jl")
        self.assertEqual([ours[m] for m in MEASURES], [same[m] for m in MEASURES])
        pyunicorn = document(f"recurrence --series {file} {flags} --convention pyunicorn")
        # All points over n^2: the diagonal's n are among them. No distance equals the threshold.
        n = ours["settings"]["points"]
        self.assertAlmostEqual(pyunicorn["RR"], ours["RC"], delta=1e-15)
        self.assertAlmostEqual(ours["RC"], (ours["RR"] * n * (n - 1) + n) / n**2, delta=1e-15)
        self.assertTrue(pyunicorn["settings"]["strict"])

    def test_a_series_against_itself_is_its_recurrence_matrix(self):
        values = (REFERENCES / "rossler_250.txt").read_text().split()
        two = self.file("two.csv", "a b\n" + "".join(f"{v} {v}\n" for v in values))
        flags = f"--series {two} --column a --threshold 1 --theiler 1"
        whole = document(f"recurrence {flags}")
        for cross in ("--cross-column b", f"--cross {two} --cross-column 2"):
            found = document(f"recurrence {flags} {cross}")
            for name in ("RR", "DET", "L", "Lmax", "ENTR", "LAM", "TT", "MRT"):
                self.assertEqual(found[name], whole[name], name)
            self.assertIsNone(found["RC"])

    def test_the_record_opens_in_xarray_and_holds_counts_and_plot(self):
        for name in ("a.h5", "b.h5"):
            self.assertEqual(run(f"recurrence {CYCLE} --transient 3000 --collisions 400 --threshold 1e-6 --image 50 "
                                 f"--quiet -o {self.folder / name}").returncode, 0)
        self.assertEqual((self.folder / "a.h5").read_bytes(), (self.folder / "b.h5").read_bytes())
        found = document(f"recurrence {CYCLE} --transient 3000 --collisions 400 --threshold 1e-6")
        with xarray.open_dataset(self.folder / "a.h5", group="recurrence", engine="h5netcdf") as data:
            for name in MEASURES:
                value = float(data[name].values[0])
                self.assertEqual(None if math.isnan(value) else value, found[name], name)
            self.assertEqual(data["image"].shape, (50, 50))
            self.assertAlmostEqual(float(data["image"].mean()), found["RC"], delta=1e-12)
            lengths = data["diagonal_lines"].values[0]
            self.assertEqual(len(lengths) - 1, found["Lmax"])
        for group in ("/", "scene", "start", "settings"):
            xarray.open_dataset(self.folder / "a.h5", group=group, engine="h5netcdf").close()


class UnevenRecurrence(InFolder):
    def test_what_was_done_is_said(self):
        times = [i + (0.3 if i % 2 else 0) for i in range(400)]
        file = self.series("uneven.csv", [math.sin(0.3 * t) for t in times], times)
        plain = document(f"recurrence --series {file}")
        self.assertFalse(plain["series"]["even"])
        self.assertTrue(any("uneven" in note for note in plain["notes"]))
        even = document(f"recurrence --series {file} --resample 1")
        self.assertEqual((even["notes"], even["resampled"]["spacing"], even["settings"]["points"]), ([], 1, 400))

    def test_gaps_leave_out_the_points_that_embed_across_them(self):
        values = [f"{math.sin(0.3 * i)!r}" for i in range(400)]
        whole = self.file("whole.csv", "\n".join(values) + "\n")
        values[100] = values[101] = "nan"
        holed = self.file("holed.csv", "\n".join(values) + "\n")
        found = document(f"recurrence --series {holed} --dimension 3 --delay 5")
        self.assertEqual(found["series"]["missing"], 2)
        self.assertEqual(found["settings"]["points_left_out"], 6)  # each sample is in three points
        self.assertEqual(found["settings"]["points"], 400 - 10 - 6)
        self.assertTrue(any("gap" in note for note in found["notes"]))
        self.assertEqual(document(f"recurrence --series {whole} --dimension 3 --delay 5")["notes"], [])


if __name__ == "__main__":
    unittest.main()
