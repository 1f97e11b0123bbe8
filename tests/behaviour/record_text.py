"""A record as text, in which equal lines mean equal content: one line per group, attribute, dataset and value.

Floating-point values stand with all their bits, so that -0.0 and 0.0, or two NaNs, are told apart. What HDF5 stores
around the content (chunks, compression, order of creation) is left out.
"""

import h5py
import numpy


def _float_text(value):
    bits = value.tobytes()[::-1] if value.dtype.byteorder != ">" else value.tobytes()
    return f"{bits.hex()} ({float(value)!r})"


def value_text(value, file):
    """One value of an attribute or a dataset. References are written as the names of what they refer to."""
    if isinstance(value, h5py.Reference):
        return f"-> {file[value].name}" if value else "-> nothing"
    if isinstance(value, numpy.void) and value.dtype.names:
        return "(" + ", ".join(f"{name}: {value_text(value[name], file)}" for name in value.dtype.names) + ")"
    if isinstance(value, (numpy.ndarray, list, tuple)):
        return "[" + ", ".join(value_text(item, file) for item in value) + "]"
    if isinstance(value, numpy.floating):
        return _float_text(value)
    if isinstance(value, numpy.generic):
        return repr(value.item())
    return repr(value)


def _type_text(dtype):
    string = h5py.check_string_dtype(dtype)
    if string:
        return f"string of {string.length or 'any'} bytes, {string.encoding}"
    if h5py.check_ref_dtype(dtype):
        return "reference"
    inner = h5py.check_vlen_dtype(dtype)
    if inner is not None:
        return f"list of {_type_text(numpy.dtype(inner))}"
    if dtype.names:
        return "(" + ", ".join(f"{name}: {_type_text(dtype[name])}" for name in dtype.names) + ")"
    return dtype.str


def _attribute_lines(item, path, file):
    for name in sorted(item.attrs):
        kind = item.attrs.get_id(name)
        yield f"{path} @{name} : {_type_text(kind.dtype)} {kind.shape} = {value_text(item.attrs[name], file)}"


def _dataset_lines(dataset, path, file):
    yield f"{path} : {_type_text(dataset.dtype)} {dataset.shape}"
    if dataset.shape is None:  # H5S_NULL: no value at all
        return
    values = numpy.asarray(dataset[()])
    for index in numpy.ndindex(values.shape):
        place = ",".join(map(str, index))
        yield f"{path}[{place}] = {value_text(values[index], file)}"


def _lines(item, path, file):
    if isinstance(item, h5py.Dataset):
        yield from _dataset_lines(item, path, file)
    else:
        yield f"{path} : group"
    yield from _attribute_lines(item, path, file)
    if isinstance(item, h5py.Group):
        for name in sorted(item):
            yield from _lines(item[name], f"{path.rstrip('/')}/{name}", file)


def record_text(path):
    """The content of the HDF5 file at `path`; of another file, that it is none."""
    try:
        with h5py.File(path, "r") as file:
            return "\n".join(_lines(file, "/", file)) + "\n"
    except OSError:
        return "not an HDF5 file\n"
