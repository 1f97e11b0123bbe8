"""swirl sweep --saddles: where the boundaries of basins lead. saddles_test.py SWIRL [--all]

--all: the torus from more places."""

import cmath
import math
import sys
import unittest

import h5py

from driving import Refusing, document, run

PLACES = (10, 14, 40) if "--all" in sys.argv and not sys.argv.remove("--all") else (14,)
#: A fixed point and a 4-cycle, both stable; a fixed point that nearly every start comes to; starts.
TWO = "--sides 6 --alpha 0.5 --beta 0.5 --mu 0.5 --restitution 0.95 --transient 2000 --collisions 500"
ONE = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --transient 2000 --collisions 500"
PLANE = "--grid vx=-0.4:0.4:5 --grid spin=-1:1:3"


class Saddles(Refusing):
    def test_a_boundary_leads_to_the_torus_around_the_steady_mode(self):
        """Around a stable fixed point whose pair of multipliers nears the unit circle: the torus turns about as the pair
        does, and every place lies between starts that come to different attractors."""
        scene = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
        steady, = (m for m in document(f"describe {scene}")["steady_modes"] if m["stability"] == "stable")
        turns = abs(cmath.phase(complex(*steady["multipliers"][0]))) / (2 * math.pi)
        grid = "--grid vx=-1:1:9 --grid vy=-1:1:9"
        path = self.folder / "b.h5"
        found = document(f"sweep {scene} {grid} --saddles 8 -o {path}")
        torus, = found["saddles"]
        self.assertEqual((torus["kind"], torus["period"], torus["index"], torus["multiplier"]),
                         ("quasi-periodic", None, None, None))
        self.assertAlmostEqual(torus["rotation_number"], turns, delta=0.005)
        self.assertAlmostEqual(torus["mean_S"], steady["S"], delta=0.01)
        self.assertEqual(len(found["boundary"]), 8)
        self.assertEqual(torus["places"], sum(place["saddle"] == 0 for place in found["boundary"]))
        self.assertGreaterEqual(torus["places"], 2)  # 23 of 40 lead there: fewer than 2 of 8 with a chance of 1 %
        for place in found["boundary"]:
            self.assertEqual(place["leads_to"] == "saddle", place["saddle"] == 0)
            here = {name: abs(value / 0.25 - round(value / 0.25)) > 1e-9 for name, value in place["parameters"].items()}
            self.assertEqual(sum(here.values()), 1, place)  # between two neighbours, along one axis
            along = next(name for name in here if here[name])
            at = place["parameters"][along]
            beside = 0.25 * 2.0**-40  # the other end after 40 halvings of the grid's step
            kinds = [document(f"classify {scene} " + " ".join(f"--{k}={v!r}" for k, v in {**place["parameters"], along: x}.items()))
                     ["kind"] for x in (at, at - beside, at + beside)]
            self.assertEqual(kinds[0], found["basins"][place["from"]]["kind"], place)
            self.assertIn(found["basins"][place["to"]]["kind"], kinds[1:], place)
        with h5py.File(path) as record:
            self.assertEqual(list(record["boundary/saddle"][:] == 0), [place["saddle"] == 0 for place in found["boundary"]])
            self.assertAlmostEqual(record["saddles/rotation_number"][0], torus["rotation_number"], delta=1e-15)
        self.assertEqual(run(f"plot {path} -o {self.folder}/b.svg").returncode, 0)
        again = run(f"sweep {scene} {grid} --saddles 8 -o {path}")
        self.assertIn("holds this sweep already", again.stderr)
        self.assertIn("boundaries of basins at 8 points", again.stdout)
        for places in PLACES:  # whatever place it is found from, it is one
            again, = document(f"sweep {scene} {grid} --saddles {places}")["saddles"]
            self.assertAlmostEqual(again["mean_S"], torus["mean_S"], delta=1e-5)

    def test_boundaries_are_those_of_one_scene(self):
        self.refused(f"sweep {TWO} --grid beta=.4:.5:3 --saddles 4", "saddles = 4")
        self.refused(f"sweep {TWO} --grid beta=.4:.5:3 --grid vx=0:1:3 --saddles 4", "saddles = 4")
        self.refused(f"sweep {TWO} --grid vx=-.4:.4 --grid spin=-1:1 --sample sobol:9 --saddles 4", "saddles = 4")
        self.refused(f"sweep {TWO} {PLANE} --saddles 0", "saddles")

    def test_a_boundary_leads_to_an_unstable_cycle(self):
        """It is found alike from all places, and as `orbits` finds it from its point."""
        scene = "--sides 4 --alpha .586 --beta .202 --mu .3 --restitution .9"
        found = document(f"sweep {scene} --grid vx=-.8:.9:6 --grid spin=-1.9:1.8:6 --x .202 --saddles 6 --transient 3000 "
                         "--collisions 1000")
        saddle, = found["saddles"]
        self.assertEqual((saddle["kind"], saddle["period"], saddle["index"], saddle["rotation_number"]), ("cycle", 18, 1, None))
        self.assertEqual(saddle["places"], sum(place["leads_to"] == "saddle" for place in found["boundary"]))
        near = document(f"orbits {scene} --period 18 --near=" + ",".join(map(repr, saddle["point"])))
        orbit, = near["orbits"]
        self.assertAlmostEqual(abs(complex(*orbit["multipliers"][0])), saddle["multiplier"], delta=1e-6)
        self.assertLess(abs(complex(*orbit["multipliers"][1])), 1)
        self.assertAlmostEqual(orbit["mean_S"], saddle["mean_S"], delta=1e-9)

    def test_places_without_a_verdict_and_maps_without_boundaries(self):
        """Tori of a frictionless disk are told by nobody in between; one attractor has no boundary."""
        path = self.folder / "none.h5"
        none = document(f"sweep {ONE} {PLANE} --saddles 4 -o {path}")
        self.assertEqual((none["saddles"], none["boundary"]), ([], []))
        with h5py.File(path) as record:
            self.assertNotIn("boundary", record)
        self.assertEqual(run(f"plot {path} -o {self.folder}/none.svg").returncode, 0)
        scene = "--sides disk --alpha .3 --beta .2 --mu 0 --restitution 1 --transient 500 --collisions 500"
        found = document(f"sweep {scene} --grid vx=-1:1:5 --grid vy=-1:1:5 --saddles 2")
        undecided = [place for place in found["boundary"] if place["leads_to"] == "undecided"]
        self.assertGreaterEqual(len(undecided), 1, found["boundary"])
        for place in undecided:
            start = " ".join(f"--{name}={value!r}" for name, value in place["parameters"].items())
            kind = document(f"classify {scene} {start}")["kind"]
            self.assertIn(kind, (None, "transient"), place)


if __name__ == "__main__":
    unittest.main()
