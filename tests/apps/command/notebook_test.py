"""swirl notebook, and the worked notebooks: notebook_test.py SWIRL ROOT [--all]

The worked notebooks are made again from records that the built swirl makes; what they print is what those in the repository
show, to the letter, but for lines that begin with ~, which are of chaos. --all: every kind of record, and all worked ones; those that
compute where the module is built, which PYTHONPATH leads to."""

import importlib.util
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from driving import InFolder, examples_of, run, start

ALL = "--all" in sys.argv and not sys.argv.remove("--all")
ROOT = Path(sys.argv.pop(1)).resolve()
NOTEBOOKS = ROOT / "notebooks-export"
sys.path.insert(0, str(NOTEBOOKS))

import nbformat

import figure_records
from driving import SWIRL
from records_of_commands import STEADY, records_in
from swirl_notebooks import cells, files_inside
from swirl_notebooks.worked import NAMES, worked_notebook

MOST_BYTES = 300_000
COMPUTING = {"swirl_from_python", "my_own_map"}  # with `import swirl`, in place of records
TOLERANCE = 0.5  # of numbers in lines that begin with ~


def printed(book):
    return [line for text in cells.printed(book) for line in text.splitlines()]


class OfARecord(InFolder):
    def test_the_helps_example_runs_again_elsewhere_without_its_record(self):
        for example in examples_of("notebook"):
            result = run(example, cwd=self.folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""), example)
        record, book = self.folder / "orbit.h5", nbformat.read(self.folder / "orbit.ipynb", as_version=4)
        nbformat.validate(book)
        self.assertIn("200 impacts", "\n".join(printed(book)))
        self.assertTrue(any("image/png" in output.get("data", {}) for cell in book.cells for output in cell.get("outputs", [])))
        code = "\n".join(cell.source for cell in book.cells if cell.cell_type == "code")
        allowed = {"base64", "tempfile", "zlib", "h5py", "matplotlib.pyplot", "numpy", "xarray", "pathlib"}
        imported = {name.split(" as ")[0].strip() for line in re.findall(r"^import (.*)$", code, re.M) for name in line.split(",")}
        self.assertLessEqual(imported | set(re.findall(r"^from (\S+) import", code, re.M)), allowed)
        record.unlink()
        with tempfile.TemporaryDirectory() as elsewhere:
            copy = nbformat.from_dict(json.loads(json.dumps(book)))
            self.assertEqual(printed(cells.executed(copy, elsewhere)), printed(book))
            self.assertEqual(list(Path(elsewhere).iterdir()), [])

    def test_a_large_record_stays_beside_and_is_checked(self):
        path = self.folder / "large.h5"
        kind, source = files_inside.record_cell(path, b"x" * (files_inside.MOST_INSIDE + 1), "large.h5")
        self.assertEqual(kind, "code")
        path.write_bytes(b"x" * (files_inside.MOST_INSIDE + 1))
        here = os.getcwd()
        self.addCleanup(os.chdir, here)
        os.chdir(self.folder)
        exec(source, {})
        exec(files_inside.record_cell(path, path.read_bytes(), "../gone/large.h5")[1], {})  # both moved into one folder
        path.write_bytes(b"y")
        with self.assertRaisesRegex(AssertionError, "another file"):
            exec(source, {})

    @unittest.skipUnless(ALL, "nightly")
    def test_each_kind_of_notebook_is_executed(self):
        first = {kind: record for record, kind in reversed(list(records_in(self.folder)))}
        for kind, record in first.items():
            file = record.with_suffix(".ipynb")
            result = run(f"notebook '{record}' -o '{file}' --json")
            self.assertEqual((result.returncode, result.stderr), (0, ""), record.name)
            self.assertEqual(json.loads(result.stdout), {"notebook": str(file), "kind": kind, "record": str(record)})
            self.assertLess(file.stat().st_size, MOST_BYTES, record.name)
            self.assertGreater(len(printed(nbformat.read(file, as_version=4))), 5, record.name)

    def test_bad_input_is_one_line(self):
        empty = self.folder / "empty.h5"
        figure_records.write_without_results(empty)
        text = self.file("text.h5", "no record")
        self.file("mine.ipynb", "{}")
        run(f"simulate {STEADY} --collisions 3 --quiet -o {self.folder}/orbit.h5")
        bare = self.file("python", '#!/bin/sh\nexec /usr/bin/python3 -I -S "$@"\n')
        bare.chmod(0o755)
        before = sorted(self.folder.iterdir())
        for arguments, mention, environment in (
                ("empty.h5 -o a.ipynb --quiet", "nothing that there is a notebook of", {}), ("text.h5 -o a.ipynb", "text.h5", {}),
                ("orbit.h5 -o a.html", "its suffix is none of .ipynb", {}), ("orbit.h5 -o mine.ipynb", "--force", {}),
                ("orbit.h5 -o a.ipynb", "Debian packages", {"SWIRL_PYTHON": str(bare)})):
            result = run(f"notebook {arguments}", cwd=self.folder, env={**os.environ, **environment})
            self.assertEqual((result.returncode, result.stdout, len(result.stderr.splitlines())), (2, "", 1), result.stderr)
            self.assertIn(mention, result.stderr)
        self.assertEqual(sorted(self.folder.iterdir()), before)

    def test_an_interruption_leaves_nothing(self):
        run(f"simulate {STEADY} --collisions 50 --quiet -o {self.folder}/orbit.h5")
        process = start(f"notebook {self.folder}/orbit.h5 -o {self.folder}/cut.ipynb", stdout=subprocess.PIPE,
                        stderr=subprocess.PIPE, text=True)
        time.sleep(2)
        process.send_signal(signal.SIGINT)
        output, errors = process.communicate(timeout=60)
        self.assertEqual((output, errors), ("", ""))
        self.assertIn(process.returncode, (130, -signal.SIGINT))  # by the signal itself where Python is still loading; a shell says 130
        self.assertEqual([file.name for file in self.folder.iterdir()], ["orbit.h5"])


class Worked(InFolder):
    def alike(self, line, shown):
        """Equal; a line of chaos: in its words, and its numbers roughly."""
        if not shown.startswith("~"):
            return line == shown
        number = r"[-+]?\d+\.\d+"
        return re.sub(number, "#", line) == re.sub(number, "#", shown) and all(
            abs(float(a) - float(b)) <= TOLERANCE * max(abs(float(b)), 0.2)
            for a, b in zip(re.findall(number, line), re.findall(number, shown)))

    def check(self, name):
        file = NOTEBOOKS / f"{name}.ipynb"
        self.assertLess(file.stat().st_size, MOST_BYTES, name)
        shown = nbformat.read(file, as_version=4)
        nbformat.validate(shown)
        with tempfile.TemporaryDirectory() as folder:
            made = worked_notebook(name, SWIRL, folder)
        self.assertEqual([cell.source for cell in made.cells if cell.metadata.get("jupyter") is None],
                         [cell.source for cell in shown.cells if cell.metadata.get("jupyter") is None], name)
        pictures = [sum("image/png" in output.get("data", {}) for cell in book.cells for output in cell.get("outputs", []))
                    for book in (made, shown)]
        self.assertGreater(pictures[0], 0, name)
        self.assertEqual(*pictures, name)
        lines, expected = printed(made), printed(shown)
        self.assertGreater(len(expected), 3, name)
        self.assertEqual(len(lines), len(expected), name)
        for line, was in zip(lines, expected):
            self.assertTrue(self.alike(line, was), f"{name}: now '{line}', shown '{was}'")
        if not ALL or name in COMPUTING:
            return
        again = nbformat.from_dict(json.loads(json.dumps(shown)))  # as a colleague runs it: from the files inside
        self.assertEqual(printed(cells.executed(again, self.folder)), expected, name)

    def test_there_are_five_of_records_and_two_that_compute(self):
        self.assertEqual(set(NAMES) - COMPUTING, {"first_orbit", "three_modes", "bifurcation_study", "measured_data", "paper_checked"})
        self.assertLess(COMPUTING, set(NAMES))

    def test_first_orbit_shows_what_swirl_finds(self):
        self.check("first_orbit")

    @unittest.skipUnless(ALL, "nightly")
    def test_all_show_what_swirl_finds(self):
        for name in sorted(set(NAMES) - COMPUTING):
            self.check(name)

    @unittest.skipUnless(ALL and importlib.util.find_spec("swirl"), "nightly, with the module")
    def test_those_that_compute_show_what_they_find(self):
        for name in sorted(COMPUTING):
            with self.subTest(name):
                self.check(name)


if __name__ == "__main__":
    unittest.main()
