"""What a verdict was made from, in three panels: the points it rests on, S one after another, the spectrum of that. Of an
orbit the tail on the section, of a measured series its values, each against the one before."""

from dataclasses import dataclass

import numpy
from matplotlib.colors import Normalize
from matplotlib.ticker import MaxNLocator

from .look import widen
from .section import dot_size
from .style import BLUE, TIMES
from .symbols import SPIN, observable_label

PANELS = 3

#: So many are drawn one after another.
SHOWN = 120

#: So many of a series are drawn, as of an orbit the tail has (docs/command-line.md).
_MOST = 2000

#: Fewer of a series show nothing.
_FEWEST = 16

#: Letters of a column's name.
_LONGEST_NAME = 20


@dataclass
class Seen:
    """Points of a portrait and values one after another, with their words."""
    x: numpy.ndarray
    y: numpy.ndarray
    x_label: str
    y_label: str
    portrait: str  # title
    values: numpy.ndarray
    places: numpy.ndarray  # abscissa of the values
    place_label: str
    value_label: str
    counted: str  # what one value is: "impact", "sample"
    symbol: str   # of the value, in titles
    period: int = 0  # in values, of a cycle; 0: none is known

    def scale(self):
        """What a change is small against: of S at least omega_s, of a column its own size."""
        return max(1.0 if self.symbol == "S" else 0.0, abs(self.values).max())


def _has_tail(record):
    return "tail" in record and len(record.column("tail", "points")) > 1


def _period(record):
    """Of a cycle that the orbit has come to; one that librates on the wall has its period in time, not in impacts."""
    attributes = record.attributes("mode")
    period = attributes.get("period", 0)
    return int(period) if str(attributes.get("kind")) == "cycle" and numpy.isfinite(period) else 0


def _seen_of_tail(record):
    names, points = [str(name) for name in record.names("tail", "coordinate")], record.column("tail", "points")
    spin = points[:, names.index("S")]
    first = int(record.attributes("tail").get("first", 1))
    return Seen(points[:, names.index("psi")], spin, observable_label("psi"), SPIN, "On the section", spin,
                first + numpy.arange(len(spin)), "impact", SPIN, "impact", "S", _period(record))


def _longest_run(there):
    """(begin, end) of the most neighbours that are there."""
    edges = numpy.flatnonzero(numpy.diff(numpy.concatenate(([False], there, [False])).astype(int))).reshape(-1, 2)
    return max(edges.tolist(), key=lambda run: run[1] - run[0], default=(0, 0))


def _used(record):
    """(first row, times, values) of a measured series, of what was judged: the longest run without a gap, for an angle's
    verdict bridges short ones."""
    settings = record.attributes("mode/settings")
    if not record.has("series", "value") or "first_time_used" not in settings:
        return 0, numpy.empty(0), numpy.empty(0)
    time, value = record.column("series", "time"), record.column("series", "value")
    judged = int(numpy.searchsorted(time, settings["first_time_used"]))
    count = int(settings["samples_used"])
    if record.attributes("series").get("quantity") == "S of an angle" and settings.get("rows") == "samples":
        count -= 1  # rows of the angle, and S lies between them
    begin, end = _longest_run(~numpy.isnan(value[judged:judged + count]))
    rows = slice(judged + begin, judged + min(end, begin + _MOST))
    return rows.start, time[rows], value[rows]


def _name_of_values(record):
    """(label, symbol) of what was measured."""
    series = record.attributes("series")
    quantity, column = (str(series.get(name, "")) for name in ("quantity", "column"))
    if quantity == "S of an angle" or column == "S":
        return SPIN, "S"
    if quantity == "distance of a position":
        return "distance", "distance"
    name = (column if len(column) <= _LONGEST_NAME else column[:_LONGEST_NAME - 1] + "…").replace("$", r"\$")
    return name, name


def name_of_mean(record):
    """What the mean of a verdict is of: the spin, or a measured column."""
    symbol = _name_of_values(record)[1] if "series" in record else "S"
    return "spin" if symbol == "S" else symbol


def _seen_of_series(record):
    first, times, values = _used(record)
    if len(values) < _FEWEST:
        return None
    label, symbol = _name_of_values(record)
    by_time = record.attributes("mode/settings").get("rows") == "samples"
    counted = "sample" if by_time else "impact"
    places = times if by_time else first + 1 + numpy.arange(len(values))
    return Seen(values[:-1], values[1:], label, f"{label}, next {counted}", f"From {counted} to {counted}", values, places,
                "time" if by_time else "impact (row of the record)", label, counted, symbol)


def _draw_portrait(axes, seen):
    """Coloured by their order."""
    axes.scatter(seen.x, seen.y, c=numpy.arange(len(seen.x)), cmap=TIMES, norm=Normalize(0, len(seen.x)),
                 s=max(dot_size(seen.x, seen.y), 1.5), lw=0)
    axes.set(xlabel=seen.x_label, ylabel=seen.y_label, title=seen.portrait)
    axes.margins(0.08)
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.ticklabel_format(useOffset=False)
    widen(axes)


def _draw_values(axes, seen):
    shown = seen.values[:SHOWN]
    axes.plot(seen.places[:SHOWN], shown, "o-", ms=2, lw=0.6, color=BLUE, mec="none")
    axes.set(xlabel=seen.place_label, ylabel=seen.value_label, title=f"{seen.symbol}, {len(shown)} {seen.counted}s")
    axes.xaxis.set_major_locator(MaxNLocator(4, integer=seen.counted == "impact"))
    axes.ticklabel_format(useOffset=False)
    if numpy.ptp(seen.values) <= 1e-9 * seen.scale():
        axes.set_ylim(seen.values[0] - 1, seen.values[0] + 1)


def power_of(values, period):
    """(frequency, power), |DFT|² of the values less their mean. Of a cycle over whole periods, the last ones that there are:
    its lines lie on bins, and between them is what the orbit has yet to come to the cycle. Else windowed (Hann), and a line
    is some bins wide."""
    whole = len(values) - len(values) % period if period else 0
    values = values[len(values) - whole:] if whole else values
    window = numpy.ones(whole) if whole else numpy.hanning(len(values))
    return (numpy.fft.rfftfreq(len(values)), abs(numpy.fft.rfft((values - values.mean()) * window)) ** 2 / len(values))


def _draw_spectrum(axes, seen):
    """Lines of a cycle or torus, a continuum of chaos."""
    frequency, power = power_of(seen.values, seen.period)
    periods = f"{len(seen.values) // seen.period:,} periods" if seen.period else f"{len(seen.values):,} {seen.counted}s"
    axes.set(xlabel=f"frequency, in cycles per {seen.counted}", ylabel=f"power of {seen.symbol}", title=f"Spectrum, {periods}")
    if power.max() <= 1e-24 * len(seen.values) * seen.scale() ** 2:
        axes.text(0.5, 0.5, f"{seen.symbol} is constant", ha="center", transform=axes.transAxes)
        axes.set(xticks=[], yticks=[])
        return
    axes.semilogy(frequency, numpy.maximum(power, power.max() * 1e-14), color=BLUE, lw=0.8)


def seen_of(record):
    """Nothing of an orbit that ended, or of too short a series."""
    return _seen_of_tail(record) if _has_tail(record) else _seen_of_series(record)


def draw(panels, seen):
    _draw_portrait(panels[0], seen)
    _draw_values(panels[1], seen)
    _draw_spectrum(panels[2], seen)
