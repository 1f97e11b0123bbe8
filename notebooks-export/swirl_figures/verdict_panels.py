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


def _has_tail(record):
    return "tail" in record and len(record.column("tail", "points")) > 1


def has_points(record):
    return _has_tail(record) or len(_used(record)[2]) > 1


def _seen_of_tail(record):
    names, points = [str(name) for name in record.names("tail", "coordinate")], record.column("tail", "points")
    spin = points[:, names.index("S")]
    first = int(record.attributes("tail").get("first", 1))
    return Seen(points[:, names.index("psi")], spin, observable_label("psi"), SPIN, "On the section", spin,
                first + numpy.arange(len(spin)), "impact", SPIN, "impact", "S")


def _used(record):
    """(first row, times, values) of the stretch of a measured series that was judged, up to its first gap."""
    if not record.has("series", "value") or not record.has_group("mode/settings"):
        return 0, numpy.empty(0), numpy.empty(0)
    time, value = record.column("series", "time"), record.column("series", "value")
    first = int(numpy.searchsorted(time, record.attributes("mode/settings")["first_time_used"]))
    missing = numpy.flatnonzero(numpy.isnan(value[first:]))
    end = first + min([_MOST, *missing[:1]])
    return first, time[first:end], value[first:end]


def _name_of_values(record):
    """(label, symbol) of what was measured."""
    series = record.attributes("series")
    quantity = str(series["quantity"])
    if quantity == "S of an angle" or str(series["column"]) == "S":
        return SPIN, "S"
    name = "distance" if quantity == "distance of a position" else str(series["column"])
    return name, name


def _seen_of_series(record):
    first, times, values = _used(record)
    label, symbol = _name_of_values(record)
    by_time = str(record.attributes("mode/settings")["rows"]) == "samples"
    counted = "sample" if by_time else "impact"
    places = times if by_time else first + 1 + numpy.arange(len(values))
    return Seen(values[:-1], values[1:], label, f"{label}, next {counted}", f"From {counted} to {counted}", values, places,
                "time" if by_time else "impact of the series", label, counted, symbol)


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
    if numpy.ptp(seen.values) < 1e-9 * max(1, abs(seen.values).max()):
        axes.set_ylim(seen.values[0] - 1, seen.values[0] + 1)


def _draw_spectrum(axes, seen):
    """|DFT|² of the values, windowed (Hann): lines of a cycle or torus, a continuum of chaos."""
    values = seen.values
    power = abs(numpy.fft.rfft((values - values.mean()) * numpy.hanning(len(values)))) ** 2 / len(values)
    axes.set(xlabel=f"frequency, in cycles per {seen.counted}", ylabel=f"power of {seen.symbol}",
             title=f"Spectrum of {'these S' if seen.symbol == 'S' else 'it'}")
    if power.max() <= 1e-24 * max(1.0, (values ** 2).sum()):
        axes.text(0.5, 0.5, f"{seen.symbol} is constant", ha="center", transform=axes.transAxes)
        axes.set(xticks=[], yticks=[])
        return
    axes.semilogy(numpy.fft.rfftfreq(len(values)), numpy.maximum(power, power.max() * 1e-14), color=BLUE, lw=0.8)


def draw(panels, record):
    seen = _seen_of_tail(record) if _has_tail(record) else _seen_of_series(record)
    _draw_portrait(panels[0], seen)
    _draw_values(panels[1], seen)
    _draw_spectrum(panels[2], seen)
