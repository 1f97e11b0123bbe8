"""A record as its groups: attributes and xarray datasets by the group's name."""

from pathlib import Path

import h5py
import numpy
import xarray


class RecordError(Exception):
    """What is wrong with a record, in one line."""


class Scene(dict):
    """A scene's parameters by name; one that is not there is a fault of the record."""

    def __missing__(self, name):
        raise RecordError(f"the record's scene has no {name}")


class Record:
    """A record that is open for as long as the object lives; datasets are read when they are used."""

    def __init__(self, path):
        self.path = Path(path)
        try:
            with h5py.File(self.path, "r") as file:
                if "schema_version" not in file.attrs:
                    raise RecordError(f"'{self.path}' is not a record of swirl")
                self.command, self.title = (str(file.attrs.get(name, "")) for name in ("command", "title"))
                self.groups = {name for name, item in file.items() if isinstance(item, h5py.Group)}
        except OSError as error:
            raise RecordError(f"cannot open record '{self.path}': {str(error).splitlines()[0]}") from error
        self._datasets, self._derived = {}, {}

    def __contains__(self, group):
        return group in self.groups

    def __getitem__(self, group):
        """The group as an xarray.Dataset."""
        if group not in self._datasets:
            if group not in self.groups:
                raise RecordError(f"record '{self.path}' has no group {group}")
            self._datasets[group] = xarray.open_dataset(self.path, group=group, engine="h5netcdf")
        return self._datasets[group]

    def attributes(self, group):
        """A group's attributes; of a group that is not there, none."""
        return dict(self[group].attrs) if group in self.groups else {}

    def column(self, group, name):
        """One variable as a numpy array."""
        dataset = self[group]
        if name not in dataset.variables:
            raise RecordError(f"record '{self.path}' has no {group}/{name}")
        return dataset[name].values

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
        values, attributes = self.column(group, name), self[group][name].attrs
        if "flag_meanings" not in attributes:
            return numpy.array([str(value) for value in values], dtype=object)
        meanings = dict(zip(numpy.atleast_1d(attributes["flag_values"]), attributes["flag_meanings"].split()))
        return numpy.array([meanings[value] for value in values], dtype=object)

    def scene(self):
        """The scene's parameters. A sweep keeps those that it does not vary among its settings."""
        attributes = {**self.attributes("settings"), **self.attributes("scene")}
        names = ("sides", "alpha", "beta", "mu", "restitution", "law", "inertia_factor")
        given = Scene((name, attributes[name]) for name in names if name in attributes)
        if "inertia-factor" in attributes:
            given.setdefault("inertia_factor", attributes["inertia-factor"])
        return given


def open_record(record):
    """A Record of a path; a Record is given back."""
    return record if isinstance(record, Record) else Record(record)
