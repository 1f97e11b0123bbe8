"""swirl sweep --track: which attractor of a cell continues which of its neighbour's. tracks_test.py SWIRL"""

import json
import unittest

import h5py

from driving import Refusing, document, run

HEXAGON = "--sides 6 --alpha 0.5 --mu 0.5 --restitution 0.95"
#: Chaos gives way to a 4-cycle, and that to chaos; beside them a fixed point, which few starts or none come to.
LINE = f"sweep {HEXAGON} --grid beta=0.47:0.55:9 --runs 6 --track"
#: A cell whose steady mode attracts in one part of the plane.
PLANE = "sweep --sides 6 --mu 0.5 --restitution 0.95 --grid alpha=0.49:0.51:3 --grid beta=0.53:0.55:3 --runs 3 --track"


def attractors(found):
    """(cell, attractor) of all."""
    return [(cell, attractor) for cell in found["cells"] for attractor in cell["attractors"]]


class Tracks(Refusing):
    @classmethod
    def setUpClass(cls):
        cls.line = document(LINE)

    def test_each_attracting_steady_mode_is_an_attractor_with_its_share(self):
        """Steady modes follow from the scene's equations alone; tracks come from orbits and Newton's method."""
        unseen = 0
        for cell in self.line["cells"]:
            fixed = {round(a["mean_S"], 8): a for a in cell["attractors"] if a["kind"] == "fixed-point"}
            steady = {round(mode["S"], 8): mode for mode in cell["steady_modes"]}
            self.assertEqual(set(fixed), set(steady), cell["parameters"])
            for spin, attractor in fixed.items():
                self.assertAlmostEqual(attractor["share"], steady[spin]["share"], delta=1e-15)
                unseen += attractor["share"] == 0
        self.assertGreater(unseen, 0)  # or nothing was tested of what no start came to

    def test_the_fixed_point_is_one_attractor_through_cells_that_no_start_shows(self):
        of = {a["track"]: [] for cell, a in attractors(self.line) if a["kind"] == "fixed-point"}
        for cell, attractor in attractors(self.line):
            if attractor["kind"] == "fixed-point":
                of[attractor["track"]].append((cell["parameters"]["beta"], attractor["mean_S"]))
        longest = max(of.values(), key=len)
        self.assertGreaterEqual(len(longest), 8)
        spins = [spin for beta, spin in sorted(longest)]
        self.assertEqual(spins, sorted(spins))  # its S grows with beta, without a jump
        self.assertLess(max(b - a for a, b in zip(spins, spins[1:])), 0.002)

    def test_tracks_do_not_mix_kinds_and_are_counted_from_the_first_cell(self):
        seen = {}
        for cell, attractor in attractors(self.line):
            if attractor["track"] is None:
                self.assertIn(attractor["kind"], (None, "transient"))
                continue
            self.assertEqual(seen.setdefault(attractor["track"], (attractor["kind"], attractor["period"])),
                             (attractor["kind"], attractor["period"]))
        self.assertEqual(list(seen), list(range(len(seen))))
        for cell in self.line["cells"]:
            tracks = [a["track"] for a in cell["attractors"] if a["track"] is not None and a["period"] is None]
            self.assertEqual(len(tracks), len(set(tracks)))
            self.assertAlmostEqual(sum(a["share"] for a in cell["attractors"]), 1, delta=1e-12)

    def test_the_four_cycle_is_one_where_it_attracts_and_its_points_are_carried(self):
        cycles = [(cell["parameters"]["beta"], a["track"], a["mean_S"]) for cell, a in attractors(self.line) if a["period"] == 4]
        self.assertEqual([beta for beta, _, _ in cycles], [0.49, 0.5, 0.51])
        self.assertEqual(len({track for _, track, _ in cycles}), 1)
        for _, _, spin in cycles:
            self.assertAlmostEqual(spin, 1, delta=1e-12)

    def test_over_two_parameters_and_any_number_of_threads(self):
        one = document(f"{PLANE} --threads 1")
        two = document(f"{PLANE} --threads 2")
        self.assertEqual(one["cells"], two["cells"])
        fixed = {a["track"] for cell, a in attractors(one) if a["kind"] == "fixed-point"}
        self.assertEqual(len(fixed), 1)
        self.assertEqual(sum(a["kind"] == "fixed-point" for cell, a in attractors(one)), 9)

    def test_record_figure_and_table(self):
        path = self.folder / "t.h5"
        shown = run(f"{LINE} -o {path}")
        self.assertEqual(shown.returncode, 0, shown.stderr)
        self.assertIn("track  mode", shown.stdout)
        rows = [(place, a) for place, cell in enumerate(self.line["cells"]) for a in cell["attractors"]]
        with h5py.File(path) as record:
            group = record["attractors"]
            self.assertEqual([place for place, _ in rows], list(group["cell"][:]))
            self.assertEqual([-1 if a["track"] is None else a["track"] for _, a in rows], list(group["track"][:]))
            self.assertEqual([a["share"] for _, a in rows], list(group["share"][:]))
            self.assertEqual(group["mean_S"].attrs["units"], "1")
        again = run(f"{LINE} -o {path} --json")
        self.assertEqual(json.loads(again.stdout)["cells"], self.line["cells"])
        self.assertEqual(again.stderr.count("holds this sweep already"), 1, again.stderr)
        drawn = run(f"plot {path} -o {self.folder}/t.svg --json")
        self.assertEqual(json.loads(drawn.stdout)["kind"], "attractors", drawn.stderr)
        other = run(f"{LINE.replace(' --track', '')} -o {path}")
        self.assertEqual((other.returncode, other.stdout), (2, ""))
        self.assertIn("was made with track = true, here is no track", other.stderr)

    def test_families_and_landing_cycles_are_one_where_each_cell_has_one(self):
        """At e = 0 impacts leave with u_n = 0: Newton's method does not carry such a cycle, which is told."""
        families = document("sweep --sides disk --alpha 0.4 --restitution 1 --beta 0.5 --grid mu=0.3:0.5:3 --runs 2 --track")
        self.assertEqual([(a["kind"], a["track"]) for cell, a in attractors(families)], [("family", 0)] * 3)
        landing = document("sweep --sides 3 --beta 0.4983 --mu 0.6153 --restitution 0 --grid alpha=0.7293:0.7327:3 --runs 2 "
                           "--transient 500 --collisions 200 --track")
        self.assertEqual([(a["kind"], a["period"], a["track"]) for cell, a in attractors(landing)], [("landing", 3, 0)] * 3)
        counts = landing["tracking"]
        self.assertEqual(counts["carried"], sum(counts[key] for key in ("arrived", "unseen", "not_attracting", "not_found")))
        self.assertGreater(counts["not_found"], 0)

    def test_a_cycle_that_no_start_came_to_attracts_from_its_point(self):
        unseen = [(cell, a) for cell, a in attractors(self.line) if a["share"] == 0]
        cell, attractor = unseen[0]
        point = ",".join(map(repr, attractor["point"]))
        beta = cell["parameters"]["beta"]
        alone = document(f"classify {HEXAGON} --beta {beta} --point={point} --transient 500 --collisions 200")
        self.assertEqual((alone["kind"], alone["period"]), (attractor["kind"], attractor["period"]))
        self.assertAlmostEqual(alone["mean_S"], attractor["mean_S"], delta=1e-9)
        self.assertEqual(self.line["tracking"]["unseen"], len(unseen))

    def test_cells_that_have_no_neighbours_are_refused(self):
        for flags, mention in (("--grid beta=0.4:0.5:2 --refine 1", "refine and track"),
                               ("--grid beta=0.4:0.5 --sample sobol:4", "sample and track"),
                               ("--grid beta=0.4:0.5:2 --shard 1/2", "shard and track"),
                               ("--beta 0.5 --grid vx=0:0.1:2", "grid over the start and track")):
            with self.subTest(flags):
                self.refused(f"sweep {HEXAGON} {flags} --track", mention)


if __name__ == "__main__":
    unittest.main()
