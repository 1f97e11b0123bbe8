"""A sweep's record as arrays over its grid. Parameters with a single value are the scene's, not axes."""

import numpy
from matplotlib.ticker import MaxNLocator

from .record import Scene, open_record
from .riding import riding_runs, share_apart
from .symbols import number, symbol

#: Of a start in the laboratory; a sweep over one of them places every start.
START_NUMBERS = ("x", "y", "vx", "vy", "angle", "spin")


def starts_in_words(record):
    """Of each cell: "2 random starts", or "one start, with x = 0.5 …" as the settings say of what is not swept."""
    runs, settings = record.size("sweep", "run"), record.attributes("settings")
    if not any(record.has("sweep", name) for name in START_NUMBERS):
        return f"{runs:,} random start{'s' * (runs > 1)}"
    # With spaces at which no line is broken.
    fixed = ", ".join(f"{name}\u00a0=\u00a0{number(settings[name])}" for name in START_NUMBERS if name in settings)
    return "one start" + (f", with {fixed}," if fixed else "")


def logarithmic_axes(record):
    """The parameters whose grid is one of logarithms, NAME=A:B:COUNT:log."""
    texts = [str(text) for text in numpy.atleast_1d(record.attributes("settings").get("grid", []))]
    return {text.split("=")[0].replace("-", "_") for text in texts if text.endswith(":log")}


def mark_values(along, name, words=None, logarithmic=False):
    """Along an axis words in place of numbers, of laws and of sides with a disk; numbers of sides whole; decades."""
    if logarithmic:
        getattr(along.axes, f"set_{along.axis_name}scale")("log")
    if words:
        along.set_ticks(range(len(words)), words)
    elif name == "sides":
        along.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))


def cell_edges(points, logarithmic=False):
    """The borders of cells about rising points: half-way between, and as far beyond the ends; of logarithms in these."""
    if logarithmic:
        return numpy.exp(cell_edges(numpy.log(points)))
    if len(points) == 1:
        return numpy.array([points[0] - 0.5, points[0] + 0.5])
    middles = (points[1:] + points[:-1]) / 2
    return numpy.concatenate([[2 * points[0] - middles[0]], middles, [2 * points[-1] - middles[-1]]])


class SweepGrid:
    def __init__(self, record):
        record = open_record(record)
        axes = record.dimensions("sweep", "mean_S")
        points = {name: record.column("sweep", name) for name in axes}
        self.words = {name: [str(word) for word in values] for name, values in points.items() if values.dtype.kind in "OSU"}
        points.update({name: numpy.arange(float(len(words))) for name, words in self.words.items()})
        self.logarithmic = logarithmic_axes(record)
        self.axes = [name for name in axes if len(points[name]) > 1] or [axes[0]]
        self.scene = record.scene()
        self.scene.update({name: self._scenes_value(name, points[name][0]) for name in axes if name not in self.axes})
        self.remarks = ""
        self.points = {name: numpy.sort(points[name]) for name in self.axes}
        self.modes = list(record.names("sweep", "mode"))
        self.runs, self.starts = record.size("sweep", "run"), starts_in_words(record)
        # Along rising parameters; of a parameter that is the scene's, its one value.
        self._names = axes
        self._place = numpy.ix_(*(numpy.argsort(points[name]) for name in axes))
        self._rest = tuple(i for i, name in enumerate(axes) if name not in self.axes)
        share, rides = self.sorted(record, "share", "mode"), riding_runs(record, [*axes, "run"])
        self.modes, self.share = share_apart(self.modes, share, None if rides is None else self._along(rides))
        self.mean_spin, self.mean_spin_error = self.sorted(record, "mean_S"), self.sorted(record, "mean_S_error")

    def sorted(self, record, name, *more):
        """A column along the axes, and then along further dimensions."""
        return self._along(record.column("sweep", name, [*self._names, *more]))

    def _along(self, values):
        return values[self._place].squeeze(axis=self._rest)

    @property
    def largest_mode(self):
        """The index of the mode with the largest share."""
        return self.share.argmax(axis=-1).astype(float)

    @property
    def largest_share(self):
        return self.share.max(axis=-1)

    def _scenes_value(self, name, point):
        return self.words[name][int(point)] if name in self.words else float(point)

    def text(self, axis, index):
        """A value of an axis for a title."""
        if axis == "law":
            return f"{self.words[axis][index].capitalize()}'s law"
        if axis in self.words:
            word = self.words[axis][index]
            return word if word == "disk" else f"{symbol(axis)} = {word}"
        return f"{symbol(axis)} = {number(self.points[axis][index])}"

    def name_ticks(self, axes):
        """Along both axes of a map of this grid, or along the abscissa."""
        for name, along in zip(self.axes, (axes.xaxis, axes.yaxis)):
            mark_values(along, name, self.words.get(name), name in self.logarithmic)

    def edges(self, name):
        """The borders of the cells along an axis."""
        return cell_edges(self.points[name], name in self.logarithmic)

    def at_middle(self, axis):
        """The grid at the middle value of one axis, which its title names."""
        points = self.points[axis]
        part = self.slice(axis, len(points) // 2)
        part.scene = Scene(self.scene)
        part.scene[axis] = self._scenes_value(axis, points[len(points) // 2])
        part.remarks = f"{self.remarks}; {self.text(axis, len(points) // 2)} is one of {len(points)} values"
        return part

    def slice(self, axis, index):
        """The grid at one value of one axis."""
        part = object.__new__(SweepGrid)
        at = self.axes.index(axis)
        part.axes = [name for name in self.axes if name != axis]
        part.points = {name: self.points[name] for name in part.axes}
        part.scene, part.modes, part.words, part.remarks = self.scene, self.modes, self.words, self.remarks
        part.runs, part.starts, part.logarithmic = self.runs, self.starts, self.logarithmic
        part.share = self.share.take(index, axis=at)
        part.mean_spin = self.mean_spin.take(index, axis=at)
        part.mean_spin_error = self.mean_spin_error.take(index, axis=at)
        return part
