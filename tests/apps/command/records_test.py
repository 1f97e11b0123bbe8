"""Every record of every command: its columns say what they are, programs that know nothing of Swirl open it, and the cells of its
notebook run on it: records_test.py SWIRL ROOT"""

import contextlib
import csv
import io
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import warnings
from pathlib import Path

import h5py
import matplotlib
import numpy
import xarray

from driving import SWIRL, document, run
from records_of_commands import RECORDS, records_in

matplotlib.use("Agg")
sys.path.insert(0, str(Path(sys.argv.pop(1)).resolve() / "notebooks-export"))

from matplotlib import pyplot
from swirl_figures import open_record
from swirl_notebooks import of_record
from swirl_notebooks.cells import cells_of

#: A pure number, radians, seconds, or powers of the three units of a scene.
UNIT = re.compile(r"1|rad|s|((1/)?(R_c|omega_s|m)(\^\d)?( |$))+")


def text_of(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def columns_of(file):
    """(name, dataset) of each but netCDF's dimensions without a variable."""
    found = []
    file.visititems(lambda name, item: found.append((name, item)) if isinstance(item, h5py.Dataset) else None)
    return [(name, data) for name, data in found if "not a netCDF variable" not in text_of(data.attrs.get("NAME", ""))]


class Records(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.kinds = dict(records_in(folder.name))
        cls.records = list(cls.kinds)

    def test_hdf5_is_no_library_that_the_program_starts_with(self):
        """It brings some forty others, and takes longer to load than they all: the first record asks for it."""
        libraries = subprocess.run(["ldd", SWIRL], capture_output=True, text=True, check=True).stdout
        self.assertIn("libfftw3", libraries)
        for name in ("libhdf5", "libcurl"):
            self.assertNotIn(name, libraries)

    def columns(self):
        for record in self.records:
            with h5py.File(record) as file:
                for name, data in columns_of(file):
                    yield f"{record.name}: {name}", data

    def test_every_command_that_writes_a_record_is_looked_at(self):
        commands = re.findall(r"^  ([a-z]+) ", run("--help").stdout.split("Subcommands:")[1], re.M)
        writing = {command for command in commands if re.search(r"-o,--output FILE\.h5", run(f"{command} --help").stdout)}
        writing.add("certify")  # a certificate, and of --plane a record
        self.assertEqual({command.split()[0] for command, _ in RECORDS.values()}, writing)

    def test_every_column_has_a_long_name(self):
        missing = [place for place, data in self.columns() if not text_of(data.attrs.get("long_name", ""))]
        self.assertEqual(missing, [])

    def test_every_number_has_a_unit_and_no_name_has_one(self):
        wrong, numbers = [], 0
        for place, data in self.columns():
            unit, is_name = text_of(data.attrs.get("units", "")), h5py.check_string_dtype(data.dtype) or "flag_meanings" in data.attrs
            numbers += not is_name
            if bool(unit) == bool(is_name) or (unit and not UNIT.fullmatch(unit)):
                wrong.append((place, unit))
        self.assertEqual(wrong, [])
        self.assertGreater(numbers, 200)

    def test_flag_values_are_of_the_type_of_their_column(self):
        same = {place: data.attrs["flag_values"].dtype == data.dtype  # looked at while its file is open
                for place, data in self.columns() if "flag_values" in data.attrs}
        self.assertEqual([place for place, is_same in same.items() if not is_same], [])
        self.assertGreater(len(same), 10)

    def test_xarray_opens_every_group_without_a_warning(self):
        for record in self.records:
            groups = ["/"]
            with h5py.File(record) as file:
                file.visititems(lambda name, item: groups.append(name) if isinstance(item, h5py.Group) else None)
            for group in groups:
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    xarray.open_dataset(record, group=group, engine="h5netcdf").load().close()

    def test_xarray_knows_each_by_its_first_bytes(self):
        for record in self.records:
            xarray.open_dataset(record, group="/").close()

    def test_show_gives_all_that_each_holds(self):
        for record in self.records:
            text = run(f"show {record}")
            self.assertEqual((text.returncode, text.stderr), (0, ""), record.name)
            wide = [line for line in text.stdout.splitlines() if len(line) > 100]
            self.assertTrue(all(len(line.split("  ")) < 5 for line in wide), (record.name, wide[:1]))  # one long text
            shown = json.dumps(document(f"show {record}"))
            with h5py.File(record) as file:
                for name, data in columns_of(file):
                    names = data.dtype == object and "CLASS" in data.attrs  # of a list's values, or of rows
                    if names or 0 in data.shape:
                        continue
                    self.assertTrue(f'"{name.rsplit("/", 1)[1]}"' in shown, (record.name, name))

    def test_the_csv_of_each_table_has_every_number(self):
        checked = 0
        for record in self.records:
            listed = run(f"show {record} --group no --csv no").stderr
            tables = listed.split("it holds ")[1].strip().split(", ") if "it holds " in listed else []
            for table in tables:
                path = record.with_suffix(".csv")
                result = run(f"show {record} --group {table} --csv {path} --force --quiet")
                self.assertEqual((result.returncode, result.stderr), (0, ""), (record.name, table))
                checked += self.check_csv(record, table, path)
            self.assertTrue(tables or "holds no table" in listed, listed)
        self.assertGreater(checked, 300)

    def check_csv(self, record, table, path):
        """Columns of doubles that were compared, bit for bit."""
        lines = [line for line in path.read_text().splitlines() if not line.startswith("#")]
        rows = list(csv.DictReader(lines))
        compared = 0
        with h5py.File(record) as file:
            group = table if isinstance(file.get(table), h5py.Group) else table.rsplit("/", 1)[0]
            for name, data in file[group].items():
                if not isinstance(data, h5py.Dataset) or data.dtype != "f8" or not rows or name not in rows[0]:
                    continue
                if data.size != len(rows):  # a coordinate of several dimensions
                    continue
                read = numpy.array([float(row[name]) for row in rows])
                numpy.testing.assert_array_equal(read, data[()].reshape(len(rows)))
                compared += 1
        return compared

    def opened_by(self, program, *options):
        for record in self.records:
            result = subprocess.run([program, *options, record], capture_output=True, text=True, timeout=60)
            self.assertEqual((result.returncode, result.stderr), (0, ""), record.name)
            with h5py.File(record) as file:
                for name, _ in columns_of(file):
                    self.assertIn(name.rsplit("/", 1)[1], result.stdout, record.name)

    @unittest.skipUnless(shutil.which("ncdump"), "no ncdump: Debian's netcdf-bin")
    def test_ncdump_opens_every_record(self):
        self.opened_by("ncdump", "-h")

    @unittest.skipUnless(shutil.which("h5ls"), "no h5ls: Debian's hdf5-tools")
    def test_h5ls_opens_every_record(self):
        self.opened_by("h5ls", "-r")

    def run_cells(self, record, template):
        """What they print; what would be a warning in the notebook is an error."""
        names = {"path": record}
        with contextlib.redirect_stdout(io.StringIO()) as printed, warnings.catch_warnings():
            warnings.simplefilter("error", RuntimeWarning)
            for cell, source in cells_of(of_record.OPENING + template.read_text(encoding="utf-8")):
                if cell == "code":
                    exec(compile(source, f"{template.name} of {record.name}", "exec"), names)
        pyplot.close("all")
        return printed.getvalue()

    def test_the_cells_of_its_notebook_run_on_each_and_none_are_of_no_record(self):
        used = set()
        for record, kind in self.kinds.items():
            template = of_record.template_of(open_record(record))
            self.assertEqual(template.stem.replace("_", "-"), kind, record.name)
            self.assertGreater(len(self.run_cells(record, template).splitlines()), 5, record.name)
            used.add(template.name)
        self.assertEqual(used, {file.name for file in of_record.FOLDER.glob("*.py")})


if __name__ == "__main__":
    unittest.main()
