"""A sweep's record as arrays over its grid. Parameters with a single value are the scene's, not axes."""

import numpy

from .record import open_record


def cell_edges(points):
    """The borders of cells about rising points: half-way between, and as far beyond the ends."""
    if len(points) == 1:
        return numpy.array([points[0] - 0.5, points[0] + 0.5])
    middles = (points[1:] + points[:-1]) / 2
    return numpy.concatenate([[2 * points[0] - middles[0]], middles, [2 * points[-1] - middles[-1]]])


class SweepGrid:
    def __init__(self, record):
        record = open_record(record)
        data = record["sweep"]
        varied = [name for name in data["mean_S"].dims if data.sizes[name] > 1] or [data["mean_S"].dims[0]]
        fixed = {name: 0 for name in data["mean_S"].dims if name not in varied}
        data = data.sortby(varied)
        self.scene = record.scene()
        self.scene.update({name: float(data[name][0]) for name in fixed})
        data = data.isel(fixed)
        self.points = {name: data[name].values for name in varied}
        self.axes = list(varied)
        self.modes = [str(mode) for mode in data["mode"].values]
        self.runs = data.sizes["run"]
        self.share = data["share"].transpose(*varied, "mode").values
        self.mean_spin = data["mean_S"].transpose(*varied).values
        self.mean_spin_error = data["mean_S_error"].transpose(*varied).values

    @property
    def largest_mode(self):
        """The index of the mode with the largest share."""
        return self.share.argmax(axis=-1).astype(float)

    @property
    def largest_share(self):
        return self.share.max(axis=-1)

    def slice(self, axis, index):
        """The grid at one value of one axis."""
        part = object.__new__(SweepGrid)
        at = self.axes.index(axis)
        part.axes = [name for name in self.axes if name != axis]
        part.points = {name: self.points[name] for name in part.axes}
        part.scene, part.modes, part.runs = self.scene, self.modes, self.runs
        part.share = self.share.take(index, axis=at)
        part.mean_spin = self.mean_spin.take(index, axis=at)
        part.mean_spin_error = self.mean_spin_error.take(index, axis=at)
        return part
