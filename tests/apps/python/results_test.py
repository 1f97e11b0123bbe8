"""Results: attributes, arrays, figures, files, and that nothing is left of them. [CALLS: of the test of leaks]"""

import gc
import os
import pickle
import sys
import tempfile
import unittest

import numpy as np

from imported import CHAOS, HEXAGON, PERIOD_8, ROOT, swirl

CALLS = int(sys.argv.pop(1)) if sys.argv[1:2] and sys.argv[1].isdigit() else 1000


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mode = swirl.classify(PERIOD_8)
        cls.orbit = swirl.simulate(CHAOS, collisions=50)

    def test_a_file_that_is_no_record_is_kept(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "notes.txt")
            with open(path, "w") as file:
                file.write("mine")
            with self.assertRaisesRegex(FileExistsError, "notes.txt' exists and is no record"):
                self.orbit.save(path)
            with open(path) as file:
                self.assertEqual(file.read(), "mine")
            self.orbit.save(path, force=True)
            self.orbit.save(path)
            self.assertEqual(len(swirl.show(path).to_dict()["scene"]), 7)

    def test_keys_are_attributes(self):
        self.assertEqual((self.mode.mode, self.mode.period, self.mode.scene.alpha), ("quasi-steady", 8, 0.635))
        self.assertEqual(self.orbit.collisions[3].psi, self.orbit.to_dict()["collisions"][3]["psi"])
        self.assertIn("period", dir(self.mode))
        with self.assertRaisesRegex(AttributeError, "it has .*mode"):
            self.mode.colour
        self.assertIn("quasi-steady", repr(self.mode))
        self.assertIn("period 8", repr(self.mode))
        self.assertIn("quasi-steady", self.mode._repr_html_())
        self.assertIn("and 40 more", self.orbit._repr_html_())

    def test_arrays_are_the_documents(self):
        arrays = self.orbit.to_xarray("collisions")
        self.assertEqual(arrays["psi"].values.tolist(), [row["psi"] for row in self.orbit.to_dict()["collisions"]])
        self.assertIn("units", arrays["vn"].attrs)
        self.assertEqual(self.orbit.to_xarray(self.orbit.groups[0]).sizes, self.orbit.to_xarray().sizes)
        with self.assertRaisesRegex(ValueError, "none of"):
            self.orbit.to_xarray("colour")

    def test_figures_are_those_of_records(self):
        figure = self.orbit.plot("section", width=4, titles=False)
        self.assertEqual(figure.get_size_inches()[0], 4)
        self.assertGreater(len(figure.axes), 0)
        with self.assertRaisesRegex(ValueError, "no figure of record"):
            self.orbit.plot("lyapunov")

    def test_proven_cells_are_a_record_and_a_certificate_is_none(self):
        cells = swirl.certify(sides=6, mu=0.5, restitution=0.95, plane={"alpha": (0.3, 0.31), "beta": (0.5, 0.51)}, max_time=2,
                              resolution=0.5)
        self.assertEqual(cells.groups, ("cells", "depths"))
        self.assertEqual(cells.to_xarray("cells").sizes["cell"], len(cells.to_dict()["cells"]))
        cells.plot()
        self.assertIsNone(swirl.certify(HEXAGON, all=True, max_time=1).record)

    def test_pickles_hold_the_record(self):
        again = pickle.loads(pickle.dumps(self.orbit))
        self.assertEqual(again.to_dict(), self.orbit.to_dict())
        self.assertNotEqual(again.record, self.orbit.record)
        self.assertTrue(again.to_xarray("collisions").equals(self.orbit.to_xarray("collisions")))

    def test_a_temporary_record_goes_with_its_result(self):
        found = swirl.describe(HEXAGON)
        path = found.record
        self.assertTrue(os.path.exists(path))
        del found
        gc.collect()
        self.assertFalse(os.path.exists(path))

    def test_messages_are_kept(self):
        self.assertEqual(self.mode.messages, ())
        heavy = swirl.classify(HEXAGON, inertia_factor=1.5)
        self.assertEqual(len(heavy.messages), 1)
        self.assertIn("inertia-factor = 1.5 is above 1", heavy.messages[0])

    def test_progress_is_told(self):
        told = []
        swirl.simulate(CHAOS, collisions=150_000, every=150_000, progress=lambda *task: told.append(task))
        self.assertTrue(told)
        self.assertEqual({task[0] for task in told}, {"simulate"})
        self.assertTrue(all(0 <= done <= total for _, total, done in told), told)

    def test_an_error_of_whoever_is_told_ends_the_command(self):
        def refuse(*_):
            raise ZeroDivisionError
        with self.assertRaises(ZeroDivisionError):
            swirl.simulate(CHAOS, collisions=10**12, every=10**12, progress=refuse)


class Series(unittest.TestCase):
    def test_arrays_frames_and_files_are_one(self):
        import tempfile

        import pandas
        import xarray
        t = np.arange(400) * 0.05
        values = np.sin(t) + 0.3 * np.sin(2.7 * t)
        with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
            file.write("time,S\n" + "".join(f"{a!r},{b!r}\n" for a, b in zip(t.tolist(), values.tolist())))
            file.flush()
            by_file = swirl.recurrence(series=file.name, column="S", time="time", threshold=0.2).to_dict()
        frame = pandas.DataFrame({"time": t, "S": values})
        array = xarray.DataArray(values, coords={"time": t}, dims="time", name="S")
        for series in (frame, frame.set_index("time"), frame.set_index("time")["S"], array, array.to_dataset()):
            found = swirl.recurrence(series=series, column="S", time="time", threshold=0.2).to_dict()
            self.assertEqual({k: v for k, v in found.items() if k != "series"}, {k: v for k, v in by_file.items() if k != "series"})
        plain = swirl.recurrence(series=values, threshold=0.2).to_dict()
        self.assertEqual(plain["RR"], by_file["RR"])
        self.assertEqual(swirl.recurrence(series=values.tolist(), threshold=0.2).to_dict(), plain)
        self.assertEqual(swirl.inspect(frame).rows, 400)

    def test_a_missing_value_is_a_gap(self):
        values = np.sin(np.arange(300) * 0.1)
        values[100:110] = np.nan
        self.assertEqual(swirl.inspect(values).to_dict()["gaps"], 1)


class Documents(unittest.TestCase):
    def test_what_the_document_shows_runs(self):
        import contextlib
        import io
        import re
        import tempfile
        names, printed, before = {}, io.StringIO(), os.getcwd()
        blocks = re.findall(r"```python\n(.*?)```", (ROOT / "docs/python.md").read_text(encoding="utf-8"), re.S)
        self.assertGreater(len(blocks), 5)
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(printed):
            os.chdir(folder)
            try:
                for block in blocks:
                    exec(compile(block, "docs/python.md", "exec"), names)
            finally:
                os.chdir(before)
        told = printed.getvalue()
        self.assertIn("mode 'quasi-steady', kind 'cycle', period 8", told)
        self.assertIn("alpha = 1.4 is outside its range", told)
        self.assertIn("('flip', 0.3675)", told)  # of Henon's fixed point: a = 3 (1 - b)^2 / 4


def resident():
    """Bytes of memory of this process."""
    with open("/proc/self/statm") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")


class Leaks(unittest.TestCase):
    def test_many_calls_leave_nothing(self):
        z = np.array((-0.0839, 0.028, -0.5542, 0.8898, -0.9793))
        calls = [lambda: swirl.simulate(HEXAGON, collisions=3, seed=2), lambda: HEXAGON.map(z), lambda: HEXAGON.derivative(z),
                 lambda: swirl.Scene(6, 0.4, 0.5, 0.5, 0.95), self.refused]
        for _ in range(40):  # pools and caches fill
            for call in calls:
                call()
        gc.collect()
        before, descriptors = resident(), len(os.listdir("/proc/self/fd"))
        for _ in range(CALLS // len(calls)):
            for call in calls:
                call()
        gc.collect()
        # A leak of one block of 100 bytes a call is 1 MB of ten thousand; the heap itself breathes by some hundred kB.
        self.assertLess(resident() - before, 800_000)
        self.assertLessEqual(len(os.listdir("/proc/self/fd")), descriptors)

    @staticmethod
    def refused():
        try:
            swirl.simulate(HEXAGON, collisions=-3)
        except ValueError:
            pass


if __name__ == "__main__":
    unittest.main()
