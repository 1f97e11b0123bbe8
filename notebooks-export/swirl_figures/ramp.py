"""S while a parameter changes slowly, up and down, with the branches of the modes that it passes."""

import dataclasses

import numpy
from matplotlib.lines import Line2D

from .bifurcation import draw_branches_in
from .legends import LegendBelow
from .look import NARROW, widen
from .ranges import inside, require
from .record import RecordError
from .samples import draw_in_one_colour
from .special_points import draw_special
from .style import BLUE, ORANGE
from .symbols import MEAN_SPIN, SPIN, axis_label, scene_title

#: Which way the parameter goes: its colour, of which the second is lighter, and the sign of where a mode was left.
_WAYS = {"up": (BLUE, ">"), "down": (ORANGE, "<")}

_BRANCHES, _SAMPLES = "0.35", "0.82"


def is_ramp(record):
    return record.has("windows", "mean_S")


def size(record, look):
    width = look.width or 8.5
    return width, 4.8 if width >= NARROW else 4.2


def _draw_samples(axes, record, way, colour, look):
    of = record.names("samples", "direction") == way
    x, y = record.column("samples", "parameter")[of], record.column("samples", "S")[of]
    seen = inside(x, look.xlim)
    axes.plot(x[seen], y[seen], ls="", marker=".", ms=3.5, mew=0, color=colour, alpha=0.6, zorder=4)


def _draw_means(axes, record, way, colour, look):
    """A line for each time that the parameter went this way; bars where the mean has an error."""
    directions, numbers = record.names("windows", "direction"), record.column("windows", "way")
    x, y, error = (record.column("windows", name) for name in ("parameter", "mean_S", "mean_S_error"))
    for number in numpy.unique(numbers[directions == way]):
        of = (numbers == number) & inside(x, look.xlim)
        axes.plot(x[of], y[of], color=colour, lw=1.4, zorder=3)
        wide = of & (error > 0)
        axes.errorbar(x[wide], y[wide], yerr=error[wide], fmt="none", ecolor=colour, elinewidth=0.6, zorder=3)


def _draw_left(axes, record, way, colour, marker, look):
    """Where modes were left; their handle, if any was."""
    if "modes" not in record:
        return []
    x = record.column("modes", "left_at")
    of = (record.names("modes", "direction") == way) & numpy.isfinite(x) & inside(x, look.xlim)
    if not of.any():
        return []
    style = {"ls": "", "marker": marker, "ms": 6, "mfc": colour, "mec": "black", "mew": 0.7}
    axes.plot(x[of], record.column("modes", "mean_S")[of], zorder=5, **style)
    return [Line2D([], [], label=f"a mode is left, {way}", **style)]


def _draw_ways(axes, record, look):
    handles = []
    for way, (colour, marker) in _WAYS.items():
        if not (record.names("windows", "direction") == way).any():
            continue
        _draw_samples(axes, record, way, colour, look)
        _draw_means(axes, record, way, colour, look)
        handles.append(Line2D([], [], color=colour, lw=1.4, label=f"{way}: {MEAN_SPIN} of a window, dots: impacts"))
        handles += _draw_left(axes, record, way, colour, marker, look)
    return handles


def _draw(figure, ramps, beneath, look):
    """Ramps over the branches, and samples if there are any, of the records beneath."""
    record = ramps[0]
    along = str(record.attributes("settings").get("along", "parameter"))
    look.title(figure, scene_title(record.scene(), leave_out=[along]))
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    handles = []
    for ramp in ramps:
        handles += [handle for handle in _draw_ways(axes, ramp, look)
                    if handle.get_label() not in {other.get_label() for other in handles}]
    require(handles, look, record, "window", record.column("windows", "parameter"))
    limits = look.xlim or axes.get_xlim()
    there = dataclasses.replace(look, xlim=limits)
    for under in beneath:
        handles += draw_in_one_colour(axes, under, _SAMPLES, there) if "samples" in under and under is not record else []
        handles += draw_branches_in(_BRANCHES, axes, under, there) if "branches" in under else []
    axes.autoscale_view()
    axes.set_xlim(limits)
    widen(axes, abscissa=False)
    for under in beneath:
        handles += draw_special(axes, under, there, "S") if "special" in under else []
    axes.set(xlabel=axis_label(along), ylabel=SPIN)
    parts.fill(handles, look)
    return [axes]


def draw_into(figure, record, look):
    return _draw(figure, [record], [record] if "branches" in record else [], look)


def draw_over_diagram(figure, records, look):
    """The ramps of the later records over the diagram of the first, of the same parameter."""
    names = [str(record.attributes("settings").get("along", "")) for record in records]
    for record, name in zip(records[1:], names[1:]):
        if name != names[0]:
            raise RecordError(f"record '{record.path}' is over {name}, '{records[0].path}' over {names[0]}: a ramp is drawn over a "
                              "diagram of its parameter")
    return _draw(figure, records[1:], records[:1], look)
