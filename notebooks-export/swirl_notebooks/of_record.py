"""The notebook of one record: what it holds, its figure drawn by a few lines of matplotlib, its numbers checked."""

import os
from pathlib import Path

from swirl_figures import RecordError, kinds_of, open_record
from swirl_figures.kinds import nothing_in
from swirl_figures.sweep_points import is_sampled

from .cells import cells_of, executed, notebook_of
from .files_inside import record_cell

FOLDER = Path(__file__).parent / "records"

#: The cells that every notebook begins with.
OPENING = '''\
# %%
# Needed: h5py, xarray with h5netcdf, matplotlib.
import h5py, matplotlib.pyplot as plt, numpy as np, xarray as xr

def group(name):
    """A group of the record, as an xarray.Dataset."""
    return xr.open_dataset(path, group=name, engine="h5netcdf")

with h5py.File(path) as file:
    made = dict(file.attrs)
    settings = {name: dict(file[name].attrs) for name in ("scene", "settings", "result") if name in file}
for name in ("title", "command", "swirl_version", "instruction_set"):
    print(f"{name}: {made.get(name, '')}")
for name, values in settings.items():
    print(name + ":", ", ".join(f"{key} = {value}" for key, value in values.items()))
# %% [markdown]
# ## What it holds
# %%
with h5py.File(path) as file:
    for name in file:
        print(name + ":")
        for column, data in file[name].items():
            if isinstance(data, h5py.Dataset) and "not a netCDF variable" not in str(data.attrs.get("NAME", "")):
                print(f"    {column:32s}{str(data.shape):14s}{data.attrs.get('units', ''):20s}"
                      f"{data.attrs.get('long_name', '')}")
'''


def _templates(record):
    """What could be shown of the record, the best first."""
    names = [kind.replace("-", "_") for kind in kinds_of(record)]
    if is_sampled(record):
        names.insert(0, "scenes" if "scenes" in record.attributes("settings") else "samples")
    if "shard" in record:
        names.append("shard")
    return [file for file in (FOLDER / f"{name}.py" for name in names) if file.is_file()]


def template_of(record):
    """The file of the cells for this record."""
    file = next(iter(_templates(record)), None)
    if file is None:
        raise RecordError(nothing_in(record, "a notebook"))
    if file.stem == "multipliers" and record.size("orbits", "period") == 0:
        raise RecordError(f"record '{record.path}' holds no orbits: there is nothing that a notebook could show")
    return file


def notebook_of_record(path, output):
    """(executed notebook, kind)."""
    record = open_record(path)
    template = template_of(record)
    path, output = Path(path), Path(output)
    relative = os.path.relpath(path.resolve(), output.resolve().parent)
    title = str(record.title) or "A record"
    cells = [("markdown", f"# {title}\n\nThe record `{path.name}` of `swirl {record.command}`."),
             record_cell(path, path.read_bytes(), relative), *cells_of(OPENING),
             *cells_of(template.read_text(encoding="utf-8"))]
    book = notebook_of(cells, title)
    return executed(book, output.resolve().parent), template.stem.replace("_", "-")
