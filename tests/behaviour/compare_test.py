"""compare.py on made-up programs and folders: it must pass what is equal and find each thing that is not."""

import contextlib
import io
import tempfile
import unittest
from pathlib import Path

import h5py
import numpy

import compare
from record_text import record_text
from run_commands import HERE, BadSet, read_commands, run_commands

# Stands in for swirl: says what it was asked, takes some seconds by its own account, leaves a file and a code.
PROGRAM = """#!/bin/sh
echo "asked $*"
cat input.txt
echo "swirl: {seconds} s" >&2
echo "{warning}" >&2
echo "{left}" > left.txt
exit {code}
"""
SAME = {"seconds": "0.12", "warning": "careful", "left": "a figure", "code": 3}


class InFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def compared(self, expected=None):
        """(as expected, the report) of the folders `old` and `new`."""
        lines = []
        good = compare.compare(self.folder / "old", self.folder / "new", expected or {}, lines.append)
        return good, "\n".join(lines)


class Comparing(InFolder):
    def answers(self, where, commands=None, **changes):
        program = self.folder / f"{where}-program"
        program.write_text(PROGRAM.format(**{**SAME, **changes}))
        program.chmod(0o755)
        inputs = self.folder / "inputs"
        inputs.mkdir(exist_ok=True)
        (inputs / "input.txt").write_text("an input\n")
        commands = commands or {"first": "swirl --one 1", "second": "swirl two && echo not reached"}
        return run_commands(program, self.folder / where, commands, inputs, lambda _: None)

    def differing(self, mention, **changes):
        self.answers("old")
        self.answers("new", **changes)
        good, report = self.compared()
        self.assertFalse(good)
        self.assertIn(mention, report)
        self.assertIn("0 same, 0 differ as expected, 2 differ unexpectedly", report)

    def test_equal_answers_are_the_same_whatever_time_they_took(self):
        self.answers("old")
        self.assertEqual(set(self.answers("new", seconds="34.5")), {"first", "second"})
        good, report = self.compared()
        self.assertTrue(good, report)
        self.assertIn("first: same\nsecond: same\n2 commands: 2 same", report)

    def test_what_is_kept(self):
        self.answers("old")
        kept = {path.name: path.read_text() for path in (self.folder / "old/first").iterdir()}
        self.assertEqual(kept["stdout"], "asked --one 1\nan input\n")
        self.assertEqual(kept["stderr"], "swirl: # s\ncareful\n")
        self.assertEqual((kept["exit"], kept["command"]), ("3\n", "swirl --one 1\n"))
        self.assertRegex(kept["files"], r"^left\.txt 9 [0-9a-f]{64}\n$")  # the copied input is not the command's

    def test_standard_error_differs(self):
        self.differing("stderr, line 2, character 5", warning="care less")

    def test_exit_code_differs(self):
        self.differing("first: DIFFERS: exit\n", code=2)

    def test_a_file_differs(self):
        self.differing("left.txt bytes", left="a fugure")

    def test_standard_output_differs(self):
        self.answers("old")
        self.answers("new", {"first": "swirl --one 1", "second": "swirl two; echo more"})
        self.assertIn("stdout, line 3", self.compared()[1])
        self.assertIn("second: DIFFERS: command, exit, stdout\n", self.compared()[1])

    def test_a_file_is_missing(self):
        self.answers("old")
        self.answers("new", {"first": "swirl --one 1; rm left.txt; exit 3", "second": "swirl two && echo not reached"})
        self.assertIn("left.txt, only the old one left it", self.compared()[1])

    def test_a_changed_input_is_a_file_that_was_left(self):
        self.answers("old", {"first": "echo more >> input.txt"})
        self.assertIn("input.txt 14 ", (self.folder / "old/first/files").read_text())

    def test_a_command_of_one_folder_only(self):
        self.answers("old", {"first": "swirl"})
        self.answers("new", {"first": "swirl", "second": "swirl"})
        good, report = self.compared()
        self.assertFalse(good)
        self.assertIn("second: DIFFERS: only in the new folder", report)
        self.assertTrue(self.compared({"second": "a new command"})[0])

    def test_what_is_expected_must_differ(self):
        self.answers("old")
        self.answers("new", code=2)
        self.assertTrue(self.compared({"first": "a new code", "second": "a new code"})[0])
        self.assertFalse(self.compared({"first": "a new code"})[0])
        self.answers("new-again")
        (self.folder / "new").rename(self.folder / "changed")
        (self.folder / "new-again").rename(self.folder / "new")
        good, report = self.compared({"second": "a new code"})
        self.assertFalse(good)
        self.assertIn("second: expected to differ, and does not (a new code)", report)

    def test_nothing_to_compare_is_an_error(self):
        self.answers("old")
        (self.folder / "new").mkdir()
        with contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(compare.main([str(self.folder / "old"), str(self.folder / "new")]), 2)
        self.assertIn("holds no answers", said.getvalue())

    def test_answers_of_two_runs_do_not_mix(self):
        self.answers("old")
        with self.assertRaisesRegex(BadSet, "not empty"):
            self.answers("old")


class Records(InFolder):
    """Two records that differ in one thing."""

    def record(self, name, change=lambda file: None):
        path = self.folder / name
        with h5py.File(path, "w") as file:
            data = file.create_dataset("group/t", data=numpy.array([1.5, -0.0, numpy.nan, 2.0]))
            data.attrs["units"] = "1"
            file["group/impact"] = numpy.arange(4)
            file["group/impact"].make_scale("impact")
            data.dims[0].attach_scale(file["group/impact"])
            file["group/names"] = numpy.array(["a", "b"], dtype=h5py.string_dtype())
            change(file)
        return record_text(path)

    def test_equal_content_is_equal_text(self):
        text = self.record("a.h5")
        self.assertEqual(text, self.record("b.h5"))
        for line in ("/group : group", "/group/t : <f8 (4,)", "/group/t[0] = 3ff8000000000000 (1.5)",
                     "/group/names[1] = b'b'", "/group/t @units : string of any bytes, utf-8 () = '1'",
                     "/group/t @DIMENSION_LIST : list of reference (1,) = [[-> /group/impact]]"):
            self.assertIn(line, text.splitlines())

    def test_each_difference_is_found(self):
        def other_type(file):
            del file["group/names"]
            file["group/names"] = numpy.array([b"a", b"b"])

        changes = {
            "one unit in the last place": lambda file: file["group/t"].__setitem__(0, numpy.nextafter(1.5, 2)),
            "the sign of zero": lambda file: file["group/t"].__setitem__(1, 0.0),
            "the sign of a NaN": lambda file: file["group/t"].__setitem__(2, -numpy.nan),
            "an attribute": lambda file: file["group/t"].attrs.__setitem__("units", "m"),
            "an attribute's type": lambda file: file["group/t"].attrs.__setitem__("units", numpy.bytes_("1")),
            "a type": other_type,
            "a group": lambda file: file.create_group("more"),
        }
        text = self.record("a.h5")
        for what, change in changes.items():
            with self.subTest(what):
                self.assertNotEqual(text, self.record("b.h5", change))

    def test_the_place_is_named(self):
        old, new = self.record("a.h5"), self.record("b.h5", lambda file: file["group/t"].__setitem__(3, 2.5))
        place, before, after = compare.first_difference(old.encode(), new.encode())
        self.assertIn("/group/t[3] = 4000000000000000 (2.0)", before)
        self.assertIn("/group/t[3] = 4004000000000000 (2.5)", after)

    def test_what_is_no_record_is_said_to_be_none(self):
        (self.folder / "text.h5").write_text("hello")
        self.assertEqual(record_text(self.folder / "text.h5"), "not an HDF5 file\n")


class TheSet(InFolder):
    def commands(self, text):
        path = self.folder / "commands.txt"
        path.write_text(text)
        return read_commands(path)

    def test_it_is_well_formed_and_large_enough(self):
        self.assertGreaterEqual(len(read_commands(HERE / "commands.txt")), 75)
        compare.read_expected(HERE / "expected_changes.txt")

    def test_a_bad_line_is_named(self):
        self.assertEqual(self.commands("# text\n\nname: swirl --version\n"), {"name": "swirl --version"})
        for text, mention in (("name:swirl\n", "line 1: NAME: LINE"), ("a: swirl\na: swirl\n", "line 2: the name a"),
                              ("../up: swirl\n", "line 1")):
            with self.assertRaisesRegex(BadSet, mention):
                self.commands(text)

    def test_a_change_without_a_reason_is_refused(self):
        path = self.folder / "expected.txt"
        path.write_text("name: \n")
        with self.assertRaisesRegex(BadSet, "REASON"):
            compare.read_expected(path)


if __name__ == "__main__":
    unittest.main()
