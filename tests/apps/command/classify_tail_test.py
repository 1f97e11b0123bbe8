"""The impacts that a verdict rests on, in the record of swirl classify, against those of swirl simulate:
classify_tail_test.py SWIRL"""

import unittest

import h5py
import numpy

from driving import InFolder, made_records, sized

FIXED_POINT = "--sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9"
CYCLE = "--sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95"
CHAOS = "--sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
FAMILY = "--sides disk --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1"
SHORT = "--transient 300 --collisions 200"
IMPACTS = sized(10_500, 2_000)


class Tail(InFolder):
    def check(self, record, orbit):
        """Row i of `tail` is impact first + i of the orbit, bit for bit."""
        with h5py.File(record) as verdict, h5py.File(orbit) as simulated:
            tail, impacts = verdict["tail"], simulated["collisions"]
            first = int(tail.attrs["first"])
            names = [name.decode() if isinstance(name, bytes) else name for name in tail["coordinate"][:]]
            self.assertGreaterEqual(len(tail["points"]), 64)
            for column, name in enumerate(names):
                values = impacts["spin" if name == "S" else name][first - 1:first - 1 + len(tail["points"])]
                numpy.testing.assert_array_equal(tail["points"][:, column], values, name)
            return first, int(verdict["mode"].attrs["impacts"])

    def test_is_numbered_as_the_orbits_impacts_are(self):
        for name, scene, options in (("fixed", FIXED_POINT, ""), ("cycle", CYCLE, ""), ("family", FAMILY, ""), ("chaos", CHAOS, ""),
                                     ("short", CHAOS, SHORT), ("exhaustive", FIXED_POINT, f"{SHORT} --exhaustive")):
            if name == "chaos" and IMPACTS < 10_000:
                continue
            records = made_records({f"{name}-verdict": f"classify {scene} {options}",
                                    f"{name}-orbit": f"simulate {scene} --collisions {max(IMPACTS, 12_100 if name == 'chaos' else 0)}"},
                                   self.folder)
            first, impacts = self.check(*records.values())
            self.assertLess(first, impacts)
            if options:
                self.assertEqual(first, 301 + (0 if "exhaustive" in name or name == "short" else 1))

    def test_of_a_records_orbit_is_there_too(self):
        orbit = made_records({"orbit": f"simulate {CHAOS} --collisions 500"}, self.folder)["orbit"]
        of_record = made_records({"of-record": f"classify {orbit} --transient 200"}, self.folder)["of-record"]
        self.assertEqual(self.check(of_record, orbit)[0], 201)
        exhaustive = made_records({"of-all": f"classify {orbit} --transient 200 --exhaustive"}, self.folder)["of-all"]
        self.assertEqual(self.check(exhaustive, orbit)[0], 201)

    def test_of_a_record_that_is_not_followed_again_goes_on_from_what_it_holds(self):
        """In more digits: the orbit from the start parts from the record, chaos being what it is."""
        orbit = made_records({"digits": f"simulate {CHAOS} --collisions 500 --accuracy extended"}, self.folder)["digits"]
        record = made_records({"parted": f"classify {orbit} --transient 200"}, self.folder)["parted"]
        with h5py.File(record) as verdict, h5py.File(orbit) as simulated:
            first = int(verdict["tail"].attrs["first"])
            names = [name.decode() if isinstance(name, bytes) else name for name in verdict["tail/coordinate"][:]]
            spin = verdict["tail/points"][0, names.index("S")]
            self.assertAlmostEqual(spin, simulated["collisions/spin"][first - 1], delta=1e-9)


if __name__ == "__main__":
    unittest.main()
