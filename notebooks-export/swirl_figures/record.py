"""A record as its groups: attributes and columns by name, and whole groups as xarray datasets."""

from pathlib import Path

import h5py
import numpy


class RecordError(Exception):
    """What is wrong with a record, in one line."""


class Scene(dict):
    """A scene's parameters by name; one that is not there is a fault of the record."""

    def __missing__(self, name):
        raise RecordError(f"the record's scene has no {name}")


def _plain(value):
    """An attribute's value, with names as strings."""
    if isinstance(value, bytes):
        return value.decode()
    return value if not isinstance(value, numpy.ndarray) or value.dtype.kind not in "SO" else [_plain(v) for v in value]


def _is_variable(item):
    """Not a dimension without a coordinate, which netCDF keeps as a dataset, too."""
    return isinstance(item, h5py.Dataset) and not _plain(item.attrs.get("NAME", "")).startswith(
        "This is a netCDF dimension but not a netCDF variable")


class Record:
    """A record that is open for as long as the object lives; columns are read when they are used."""

    def __init__(self, path):
        self.path = Path(path)
        try:
            self._file = h5py.File(self.path, "r")
        except OSError as error:
            raise RecordError(f"cannot open record '{self.path}': {str(error).splitlines()[0]}") from error
        if "schema_version" not in self._file.attrs:
            raise RecordError(f"'{self.path}' is not a record of swirl")
        self.command, self.title = (str(_plain(self._file.attrs.get(name, ""))) for name in ("command", "title"))
        self.groups = {name for name, item in self._file.items() if isinstance(item, h5py.Group)}
        self._datasets, self._derived = {}, {}

    def __contains__(self, group):
        return group in self.groups

    def _group(self, name):
        if name not in self.groups:
            raise RecordError(f"record '{self.path}' has no group {name}")
        return self._file[name]

    def __getitem__(self, group):
        """The group as an xarray.Dataset."""
        import xarray  # takes longer to load than most figures to draw, and few need it
        self._group(group)
        if group not in self._datasets:
            self._datasets[group] = xarray.open_dataset(self.path, group=group, engine="h5netcdf")
        return self._datasets[group]

    def attributes(self, group):
        """A group's attributes; of a group that is not there, none."""
        if not self.has_group(group):
            return {}
        return {name: _plain(value) for name, value in self._file[group].attrs.items()}

    def has_group(self, path):
        """Whether there is this group, also one within another, as "mode/settings"."""
        return isinstance(self._file.get(path), h5py.Group)

    def columns(self, group):
        """The names of a group's variables, coordinates with them."""
        return [name for name, item in self._group(group).items() if _is_variable(item)]

    def has(self, group, name):
        """Whether the group is there and has this variable."""
        return group in self.groups and name in self._file[group] and _is_variable(self._file[group][name])

    def _variable(self, group, name):
        self._group(group)
        if not self.has(group, name):
            raise RecordError(f"record '{self.path}' has no {group}/{name}")
        return self._file[group][name]

    def column(self, group, name, order=None):
        """One variable as a numpy array; its axes in this order of the dimensions' names."""
        variable = self._variable(group, name)
        values = variable.asstr()[()] if h5py.check_string_dtype(variable.dtype) else variable[()]
        if _plain(variable.attrs.get("dtype")) == "bool":  # as netCDF keeps what is so or not
            values = values.astype(bool)
        return values if order is None else values.transpose([self.dimensions(group, name).index(d) for d in order])

    def column_attributes(self, group, name):
        """What the record says of one variable: units, long_name …"""
        return {key: _plain(value) for key, value in self._variable(group, name).attrs.items()}

    def dimensions(self, group, name):
        """The names of a variable's dimensions; a coordinate's is itself."""
        variable = self._variable(group, name)
        if _plain(variable.attrs.get("CLASS")) == "DIMENSION_SCALE":
            return (name,)
        try:
            return tuple(axis.values()[0].name.rsplit("/", 1)[1] for axis in variable.dims)
        except (RuntimeError, IndexError) as error:
            raise RecordError(f"record '{self.path}' does not say the dimensions of {group}/{name}") from error

    def size(self, group, name):
        """How many values a coordinate, or a variable along one dimension, has; 0 if it is not there."""
        return len(self._file[group][name]) if self.has(group, name) else 0

    def derived(self, compute):
        """compute(record), computed once for all panels that show it."""
        if compute not in self._derived:
            self._derived[compute] = compute(self)
        return self._derived[compute]

    def attribute(self, group, name):
        """One attribute of a group."""
        attributes = self.attributes(group)
        if name not in attributes:
            raise RecordError(f"record '{self.path}' has no attribute {name} of {group}")
        return attributes[name]

    def names(self, group, name):
        """A variable of names: strings, or small integers whose names are CF's flag_meanings."""
        values, attributes = self.column(group, name), self.column_attributes(group, name)
        if "flag_meanings" not in attributes:
            return numpy.array([str(value) for value in values], dtype=object)
        meanings = dict(zip(numpy.atleast_1d(attributes["flag_values"]), attributes["flag_meanings"].split()))
        return numpy.array([meanings[value] for value in values], dtype=object)

    def scene(self):
        """The scene's parameters. A sweep keeps those that it does not vary among its settings."""
        attributes = {**self.attributes("settings"), **self.attributes("scene")}
        names = ("sides", "alpha", "beta", "mu", "restitution", "law", "inertia_factor", "drag", "spin_drag",
                 "floor_friction", "gravity_ratio", "floor", "tangential_restitution", "corner")
        given = Scene((name, attributes[name]) for name in names if name in attributes)
        if "inertia-factor" in attributes:
            given.setdefault("inertia_factor", attributes["inertia-factor"])
        return given


    def require_straight_flights(self):
        """@raises RecordError: over a floor that drags or has dry friction flights are no straight lines, and S falls on them."""
        attributes = {**self.attributes("settings"), **self.attributes("scene")}
        if attributes.get("drag", 0) or attributes.get("spin_drag", 0):
            raise RecordError(f"record '{self.path}' is of a floor that drags, to which flights in figures are not "
                              "extended")
        if attributes.get("floor_friction", 0):
            raise RecordError(f"record '{self.path}' is of a floor with dry friction, to which flights in figures are "
                              "not extended")


def open_record(record):
    """A Record of a path; a Record is given back."""
    return record if isinstance(record, Record) else Record(record)
