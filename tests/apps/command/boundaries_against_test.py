"""swirl boundaries --against MAP.h5, from outside: boundaries_against_test.py SWIRL"""

import math
import unittest

from boundary_planes import HEXAGON, SMALL
from driving import InFolder, document, run


class Against(InFolder):
    def test_against_a_map_over_the_inertia_factor(self):
        path, plane = self.folder / "map.h5", "--plane alpha=0.5:0.6 --plane inertia-factor=0.3:0.5"
        scene = f"{HEXAGON} --beta 0.3"
        run(f"sweep {scene} --grid alpha=0.5:0.6:2 --grid inertia-factor=0.3:0.5:2 --runs 1 --collisions 300 --quiet -o {path}")
        against = document(f"boundaries {scene} {plane} --max-period 1 --lines 1 --against {path}")["against"]
        self.assertEqual(against["cells"], 4)

    def test_against_a_map_of_lists_and_logarithms(self):
        path, plane = self.folder / "map.h5", "--plane alpha=0.5:0.6 --plane beta=0.2:0.4"
        run(f"sweep {HEXAGON} --grid alpha=0.5,0.52,0.6 --grid beta=0.25:0.4:3:log --runs 1 --collisions 300 --quiet -o {path}")
        against = document(f"boundaries {HEXAGON} {plane} --max-period 1 --lines 1 --against {path}")["against"]
        self.assertEqual((against["cells"], against["outside_cells"]), (9, 0))
        values = ({0.5, 0.52, 0.6}, {0.25, math.sqrt(0.25 * 0.4), 0.4})
        for entry in against["disagreements"]:
            for value, allowed in zip(entry["parameters"].values(), values):
                self.assertLess(min(abs(value - a) for a in allowed), 1e-12)
        self.assertGreater(against["with_cycle"], 0)

    def test_members_of_families_are_compared_with_nothing(self):
        # A disk that loses nothing: every cycle is a member of a family, with a multiplier 1 but for rounding.
        path, scene = self.folder / "map.h5", "--sides disk --mu 0.3 --restitution 1"
        plane = "--plane alpha=0.3:0.5 --plane beta=0.3:0.5"
        run(f"sweep {scene} --grid alpha=0.3:0.5:3 --grid beta=0.3:0.5:3 --runs 1 --quiet -o {path}")
        against = document(f"boundaries {scene} {plane} --max-period 1 --lines 1 --against {path}")["against"]
        self.assertEqual((against["with_cycle"], against["disagreements"]), (0, []))
        self.assertEqual(against["family_cells"], 9)

    def test_curves_that_lie_between_lines_are_sought_from_the_maps_own_runs(self):
        # A band of cycles of period 2, 0.008 wide in alpha, that every second start or so comes to.
        path, scene = self.folder / "map.h5", HEXAGON
        run(f"sweep {scene} --grid alpha=0.47966101694915253:0.4932:2 --grid beta=0.6940677966101695:0.7110169491525423:2 "
            f"--runs 8 --quiet -o {path}")
        against = document(f"boundaries {scene} --plane alpha=0.4:0.6 --plane beta=0.6:0.8 --max-period 2 --lines 1 "
                           f"--against {path}")["against"]
        self.assertEqual((against["missing_cells"], against["led_by_runs"]), (0, 2))

    def test_against_a_map(self):
        path = self.folder / "map.h5"
        run(f"sweep {HEXAGON} --grid alpha=0.5:0.59:6 --grid beta=0.26:0.35:6 --runs 1 --quiet -o {path}")
        against = document(f"boundaries {SMALL} --against {path}")["against"]
        self.assertEqual(against["cells"], 36)
        self.assertGreater(against["with_cycle"], 10)
        self.assertLess(against["missing_cells"], 5)  # of cycles of period 1
        for entry in against["disagreements"]:
            self.assertIn(entry["why"], ("too-few-starts", "transient", "curve-missing"))

    def test_where_no_curve_is_the_maps_cycles_are_missing(self):
        # One fixed point attracts in all of the plane.
        path, scene = self.folder / "map.h5", "--sides 6 --mu 0.5 --restitution 0.9"
        run(f"sweep {scene} --grid alpha=0.38:0.4:3 --grid beta=0.46:0.48:3 --runs 2 --quiet -o {path}")
        against = document(f"boundaries {scene} --plane alpha=0.38:0.4 --plane beta=0.46:0.48 --lines 1 "
                           f"--against {path}")["against"]
        self.assertEqual((against["cells"], against["with_cycle"], against["missing_cells"]), (9, 0, 9))

    def test_cells_outside_of_the_plane_are_compared_with_nothing(self):
        path = self.folder / "map.h5"
        run(f"sweep {HEXAGON} --grid alpha=0.5:0.7:3 --grid beta=0.3:0.4:2 --runs 1 --quiet -o {path}")
        against = document(f"boundaries {SMALL} --against {path}")["against"]
        self.assertEqual((against["cells"], against["outside_cells"]), (4, 2))
        for entry in against["disagreements"]:
            self.assertLessEqual(entry["parameters"]["alpha"], 0.6)


if __name__ == "__main__":
    unittest.main()
