"""swirl classify --runs and what a verdict says would change it: classify_runs_test.py SWIRL"""

import unittest

import numpy
import xarray

from driving import InFolder, document, interrupted, run

COEXISTING = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"  # a fixed point and an 8-cycle
FAMILY = "--sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1"
MIXED = "--sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1"


class Runs(InFolder):
    def test_a_run_is_what_classify_gives_for_its_seed_and_the_first_attractor_stands_at_top_level(self):
        found = document(f"classify {COEXISTING} --runs 16")
        self.assertEqual([r["seed"] for r in found["runs"]], list(range(1, 17)))
        for run_ in found["runs"][::5]:
            alone = document(f"classify {COEXISTING} --seed {run_['seed']}")
            for key in ("mode", "kind", "period", "mean_S", "mean_S_per_impact", "largest_exponent",
                        "recurrence_rate", "outcome"):
                self.assertEqual(alone[key], run_[key], key)
        first = found["attractors"][0]
        alone = document(f"classify {COEXISTING} --seed {first['seed']}")
        for key in ("mode", "kind", "period", "mean_S", "recurrence_rate", "largest_exponent", "evidence"):
            self.assertEqual(found[key], alone[key], key)

    def test_coexisting_modes_have_their_shares(self):
        found = document(f"classify {COEXISTING} --runs 16")
        modes = [(a["mode"], a["kind"], a["period"]) for a in found["attractors"]]
        self.assertEqual(modes, [("quasi-steady", "cycle", 8), ("steady", "fixed-point", 1)])
        # Which start goes where is decided in a chaotic transient, by rounding; about one in six becomes steady.
        steady = found["modes"]["steady"]
        self.assertIn(16 * steady, range(1, 7))
        self.assertEqual(found["modes"], {"steady": steady, "quasi-steady": 1 - steady})
        self.assertEqual(found["kinds"], {"fixed-point": steady, "cycle": 1 - steady})
        self.assertEqual(sum(a["share"] for a in found["attractors"]), 1)
        for place, attractor in enumerate(found["attractors"]):
            own = [r for r in found["runs"] if r["attractor"] == place]
            self.assertEqual(len(own) / 16, attractor["share"])
            self.assertEqual(own[0]["seed"], attractor["seed"])
            for r in own:
                self.assertAlmostEqual(r["mean_S"], attractor["mean_S"], delta=1e-12)

    def test_a_chaotic_transient_has_its_rate_of_escape(self):
        scene = "--sides 6 --alpha 0.398 --beta 0.893 --mu 0.3 --restitution 0.9 --runs 24"
        short = document(f"classify {scene} --transient 4000 --collisions 4000")
        escape = short["escape"]
        self.assertGreater(escape["left"], 3)
        self.assertGreater(escape["remaining"], 0)
        self.assertAlmostEqual(escape["rate"] * escape["impacts"], escape["left"], delta=1e-9)
        self.assertAlmostEqual(escape["half_life"] * escape["rate"], numpy.log(2), delta=1e-12)
        self.assertLess(escape["least_rate"], escape["rate"])
        self.assertTrue(escape["others_will_leave"])
        self.assertNotIn("chaotic", short["kinds"])  # the rest are transient, and named so
        self.assertGreater(short["kinds"]["transient"], 0)
        # A longer look: they did leave, at a rate within both intervals.
        longer = document(f"classify {scene} --transient 60000 --collisions 4000")
        self.assertNotIn("chaotic", longer["kinds"])
        self.assertNotIn("transient", longer["kinds"])
        self.assertIsNone(longer["escape"])

    def test_chaos_that_none_leaves_stays_chaos_and_says_what_it_cannot_exclude(self):
        found = document("classify --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 0.95 --runs 4")
        self.assertEqual((found["kinds"], found["escape"]), ({"chaotic": 1}, None))
        stay, = (e for e in found["evidence"] if e["name"] == "steps without leaving chaos")
        self.assertAlmostEqual(stay["threshold"], numpy.log(2) * stay["value"] / 3, delta=1e-9)
        self.assertGreaterEqual(stay["value"], 20000)

    def test_members_of_a_family_are_one_attractor_with_a_spread_of_means(self):
        found = document(f"classify {FAMILY} --runs 6 --seed 3")
        self.assertEqual([a["kind"] for a in found["attractors"]], ["family"])
        self.assertGreater(found["attractors"][0]["mean_S_error"], 1e-3)

    def test_threads_do_not_change_a_bit_and_xarray_opens_the_runs(self):
        for threads in (1, 2):
            done = run(f"classify {MIXED} --runs 8 --collisions 500 --threads {threads} -o {self.folder}/{threads}.h5")
            self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "1.h5").read_bytes(), (self.folder / "2.h5").read_bytes())
        with xarray.open_dataset(self.folder / "1.h5", group="runs", engine="h5netcdf") as runs:
            self.assertEqual(list(runs["seed"].values), [str(s) for s in range(1, 9)])
            self.assertEqual(runs["mean_S"].dims, ("run",))
        with xarray.open_dataset(self.folder / "1.h5", group="attractors", engine="h5netcdf") as attractors:
            self.assertAlmostEqual(float(attractors["share"].sum()), 1, delta=1e-15)
        with xarray.open_dataset(self.folder / "1.h5", group="mode", engine="h5netcdf") as mode:
            self.assertIn("changes_if", mode)

    def test_no_kind_and_no_period_are_null_in_every_document_and_none_in_every_record(self):
        record = self.folder / "o.h5"
        flags = f"--sides 6 --beta 0.1 --mu 0.5 --restitution 0.9 --speed 0 --collisions 100 --quiet -o {record}"
        for command, groups in ((f"classify --alpha 0.4 {flags}", ["mode"]),
                                (f"classify --alpha 0.4 --runs 2 {flags}", ["mode", "attractors", "runs"]),
                                (f"sweep --grid alpha=0.4:0.4:1 {flags}", ["settings"]),
                                (f"bifurcate --along alpha=0.4:0.5:2 {flags}", ["attractors"])):
            found = document(command)
            named = [found, *found.get("attractors", []), *found.get("runs", []),
                     *(run for cell in found.get("cells", []) for run in cell["runs"]),
                     *(orbit for column in found.get("columns", []) for orbit in column["attractors"])]
            named = [verdict for verdict in named if "mode" in verdict]
            self.assertTrue(named, command)
            for verdict in named:
                answer = [verdict[key] for key in ("mode", "kind", "period")]
                self.assertEqual(answer, ["undecided", None, None], command)
            for group in groups:
                with xarray.open_dataset(record, group=group, engine="h5netcdf") as data:
                    found = data if "kind" in data else data.attrs
                    kinds = found["kind"] if "kind" in found else found["kinds"][0]
                    self.assertEqual(set(numpy.atleast_1d(kinds)), {"none"}, (command, group))
            record.unlink()

    def test_a_table_for_people_lists_the_attractors(self):
        shares = document(f"classify {COEXISTING} --runs 16")["modes"]
        text = run(f"classify {COEXISTING} --runs 16").stdout
        for mode, kind, period in (("quasi-steady", "cycle", 8), ("steady", "fixed-point", 1)):
            self.assertRegex(text, rf"\n +\d +{100 * shares[mode]:.2f} %\s+{mode}\s+{kind}\s+{period} ")

    def test_bad_input(self):
        record = self.folder / "o.h5"
        self.assertEqual(run(f"simulate {COEXISTING} --collisions 5 --quiet -o {record}").returncode, 0)
        for flags, mention in ((f"{COEXISTING} --runs 0", "runs"), (f"{COEXISTING} --runs -1", "runs"),
                               (f"{COEXISTING} --runs x", "runs"), (f"{COEXISTING} --runs 3 --x 0.4", "runs = 3"),
                               (f"{COEXISTING} --runs 3 --point 0,0,-1,0,0", "runs = 3"),
                               (f"{record} --runs 3", "runs = 3"), ("--series - --runs 3", "runs = 3"),
                               (f"{COEXISTING} --runs 2 --seed 18446744073709551615", "18446744073709551614")):
            result = run(f"classify {flags} -o {self.folder}/out.h5", input="1\n2\n")
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), flags)
            self.assertIn(mention, result.stderr)
            self.assertFalse((self.folder / "out.h5").exists())

    def test_interrupted_it_exits_with_130_and_keeps_the_finished_runs(self):
        file = self.folder / "cut.h5"
        self.assertEqual(interrupted(f"classify {MIXED} --runs 100000 --quiet -o {file}", 2), 130)
        with xarray.open_dataset(file, group="runs", engine="h5netcdf") as runs:
            self.assertGreater(runs.sizes["run"], 0)
            self.assertLess(runs.sizes["run"], 100000)
            self.assertEqual(runs.attrs["wanted"], 100000)

    def test_one_verdict_is_interrupted_at_once(self):
        self.assertEqual(interrupted(f"classify {MIXED} --collisions 100000000", 1, 10), 130)


class Evidence(InFolder):
    SCENES = (COEXISTING, FAMILY, MIXED, "--sides 4 --alpha 0.52 --beta 0.46 --mu 0.6 --restitution 0.75",
              "--sides disk --alpha 0.4 --beta 0.3 --mu 0.4 --restitution 0.9",
              "--sides 4 --alpha 0.6662 --beta 0.9237 --mu 1.0046 --restitution 0.0252")

    def test_every_piece_says_what_would_change_the_verdict(self):
        for scene in self.SCENES:
            found = document(f"classify {scene}")
            self.assertGreaterEqual(len(found["evidence"]), 3, scene)
            for piece in found["evidence"]:
                self.assertEqual(set(piece), {"name", "value", "threshold", "says", "changes_if"})
                self.assertTrue(piece["says"] and piece["changes_if"], piece)

    def test_what_is_printed_would_change_it(self):
        for scene in self.SCENES:
            self.assertNotIn("changes if: nothing", run(f"classify {scene}").stdout, scene)

    def test_what_speaks_against_is_the_reason(self):
        """Halves of one variance about two means: the mean that shifts is named, not the variance that stays."""
        file = self.series("steps.csv", [float(numpy.sin(0.7 * i)) + 3 * (i >= 500) for i in range(1000)])
        found = document(f"classify --series {file}")
        self.assertEqual((found["mode"], found["kind"]), ("undecided", "transient"))
        self.assertEqual(found["evidence"][-1]["name"], "shift of the mean between the halves")
        text = run(f"classify --series {file}").stdout
        self.assertRegex(text, "\n  undecided: the series still settles\n  changes if: at most [0-9.]+: ")

    def test_the_sentence_keeps_its_word(self):
        """The threshold that the exponent's sentence names is the one that changes the verdict."""
        found = document(f"classify {MIXED}")
        exponent = next(p for p in found["evidence"] if p["name"] == "largest exponent")
        self.assertEqual(found["mode"], "chaotic")
        self.assertAlmostEqual(exponent["threshold"], 5 * found["largest_exponent_error"], delta=1e-15)
        self.assertGreater(exponent["value"], exponent["threshold"])
        cycle = document(f"classify {COEXISTING} --max-period 7")
        self.assertIn("8", str(document(f"classify {COEXISTING}")["period"]))
        self.assertIsNone(cycle["period"])  # "none up to 7: the largest exponent and the rotation number would decide"
        self.assertEqual(cycle["mode"], "undecided")


if __name__ == "__main__":
    unittest.main()
