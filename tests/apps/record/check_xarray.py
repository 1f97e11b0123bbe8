"""check_xarray.py WRITE_SAMPLE DIRECTORY: every group of the sample record opens in xarray as what it is."""

import subprocess
import sys
from pathlib import Path

import h5py
import numpy as np
import xarray as xr

ROWS = 40000


def open_group(path, group):
    """Without an engine's name: xarray knows the file by its first bytes."""
    return xr.open_dataset(path, group=group).load()


def check_root(root):
    assert dict(root.sizes) == {"mode": 3}, root.sizes
    assert list(root.mode.values) == ["steady", "quasi-steady", "chaotic"]
    assert root.share.sel(mode="chaotic") == 0.5
    assert root.share.attrs == {"units": "1", "long_name": "share of the runs in each mode"}
    assert root.mean_S.dims == () and root.mean_S == 1.5
    attributes = root.attrs
    assert attributes["schema_version"] == 2 and attributes["title"] == "a sample"
    assert attributes["swirl_version"] == "0.1.0" and attributes["instruction_set"] == "x86-64"
    assert attributes["seed"] == 2**64 - 1 and attributes["alpha"] == 0.4 and attributes["sides"] == 6
    assert attributes["quiet"] == 1 and attributes["law"] == "poisson"
    assert list(attributes["start"]) == [0.5, 0.0, 1e-320] and np.signbit(attributes["start"][1])
    assert list(attributes["grid"]) == [41, 41] and list(attributes["names"]) == ["α", "β", ""]
    assert len(attributes["nothing"]) == 0


def check_impacts(impacts):
    i = np.arange(ROWS)
    assert dict(impacts.sizes) == {"impact": ROWS, "axis": 2}, impacts.sizes
    assert list(impacts.coords) == ["t"] and impacts.t.dims == ("impact",), impacts.coords
    assert impacts.t.attrs == {"units": "1", "long_name": "time of the impact"}
    assert impacts.t.dtype == np.float64 and (impacts.t.values == 0.5 * i).all()
    assert impacts.position.dims == ("impact", "axis")
    assert (impacts.position.values == np.stack([np.sqrt(i), -i], axis=1)).all()
    assert impacts.vertex.dtype == np.int32 and (impacts.vertex.values == i % 6).all()
    assert impacts.contact_mode.dtype == np.uint8 and (impacts.contact_mode.values == i % 2).all()
    assert impacts.contact_mode.attrs["flag_meanings"] == "sliding c-sticking"
    assert list(impacts.contact_mode.attrs["flag_values"]) == [0, 1]
    assert impacts.contact_mode.attrs["flag_values"].dtype == np.uint8  # CF: the variable's own type
    assert impacts.simultaneous.dtype == bool and (impacts.simultaneous.values == (i % 3 == 0)).all()
    assert impacts.turns.dtype == np.int64 and (impacts.turns.values == np.int64(1) << (i % 63)).all()


def check_cells(cells):
    assert dict(cells.sizes) == {"alpha": 3, "beta": 4, "run": 5, "coordinate": 2}, cells.sizes
    assert sorted(cells.coords) == ["alpha", "beta"], cells.coords
    assert list(cells.alpha.values) == [0.1, 0.2, 0.3] and list(cells.beta.values) == [0.0, 0.5, 1.0, 5.0]
    assert cells.beta.attrs["units"] == "1" and cells.z.dims == ("alpha", "beta", "run", "coordinate")
    z = np.arange(120.0).reshape(3, 4, 5, 2)
    z.flat[7] = np.nan
    np.testing.assert_array_equal(cells.z.values, z)
    np.testing.assert_array_equal(cells.mean_S.sel(alpha=0.2).values, [4, 5, 6, np.nan])


def check_storage(path):
    """Chunked and compressed, and no object carries a time."""
    with h5py.File(path, "r") as file:
        t = file["impacts/t"]
        assert t.chunks == (16384,) and t.compression == "gzip" and t.compression_opts == 1 and t.shuffle
        assert t.maxshape == (None,)
        objects = [file["/"]]
        file.visititems(lambda name, item: objects.append(item))
        assert len(objects) > 20
        for item in objects:
            assert h5py.h5g.get_objinfo(item.id).mtime == 0, item.name
    assert path.stat().st_size < 0.25 * ROWS * (8 + 16 + 4 + 1 + 1 + 8) + 200_000, path.stat().st_size


def main(write_sample, directory):
    path = Path(directory) / "xarray_sample.h5"
    subprocess.run([write_sample, path], check=True)
    check_root(open_group(path, None))
    check_root(open_group(path, "/"))
    check_impacts(open_group(path, "impacts"))
    check_cells(open_group(path, "/sweep/cells"))
    assert dict(open_group(path, "sweep").sizes) == {}
    empty = open_group(path, "empty")
    assert dict(empty.sizes) == {"impact": 0} and empty.S.attrs["units"] == "1"
    check_storage(path)
    copy = Path(directory) / "xarray_copy.nc"
    for group in (None, "impacts", "sweep/cells"):  # users save what they have worked on
        open_group(path, group).to_netcdf(copy, engine="h5netcdf")
    path.unlink()
    copy.unlink()


if __name__ == "__main__":
    main(*sys.argv[1:])
