"""What a fit to measured impacts found: profiles of restitution and friction, and what single impacts ask for."""

import numpy

from .look import rows_of, side_by_side
from .ranges import inside
from .style import BLUE, GREY, VERMILION
from .symbols import axis_label, number, symbol

#: 95 % of χ² with one degree of freedom.
_SURE = 3.841

#: Impacts of less information than this share of the most would only widen the ordinate.
_LEAST_SHARE = 0.02

_SPEEDS = {"restitution": ("approach_speed", "speed of approach"), "friction": ("slip_speed", "speed of slip")}
_PARAMETERS = {"restitution": "restitution", "friction": "mu"}


def size(record, look):
    width = look.width or 7.5
    return width, 2.6 * rows_of(width, 4, 2.6) + 0.4


def _draw_profile(axes, record, name):
    value, deviance = (record.column(f"{name}_profile", column) for column in ("value", "deviance"))
    interval = record.attributes(f"fit/{name}")
    low, high, best = (float(interval.get(key, numpy.nan)) for key in ("low", "high", "value"))
    axes.plot(value, deviance, color=BLUE, lw=1.1)
    axes.axhline(_SURE, color="0.5", lw=0.7, ls=(0, (3, 2)))
    axes.axvspan(low, high if numpy.isfinite(high) else value[-1], color=BLUE, alpha=0.12, lw=0)
    if numpy.isfinite(best):
        axes.axvline(best, color=VERMILION, lw=0.9)
    ends = f"{number(low)} … {number(high)}" if numpy.isfinite(high) else f"above {number(low)}"
    axes.set(xlabel=axis_label(_PARAMETERS[name]), ylabel="deviance", title=f"{symbol(_PARAMETERS[name])}: {ends}", xlim=(value[0], value[-1]),
             ylim=(0, min(deviance.max() * 1.05, 12 * _SURE) or 1))


def _draw_impacts(axes, record, look, name):
    column, words = _SPEEDS[name]
    speed, wants = record.column("impacts", column), record.column("impacts", name)
    weight, information = record.column("impacts", "weight"), record.column("impacts", f"{name}_information")
    told = numpy.isfinite(wants) & inside(speed, look.xlim)
    told &= information > _LEAST_SHARE * information.max() if told.any() else False
    for of, colour, label in ((told & (weight > 0), BLUE, "impacts"), (told & (weight == 0), GREY, "outliers")):
        axes.scatter(speed[of], wants[of], s=5, color=colour, lw=0, alpha=0.6, label=label)
    axes.axhline(0, color=VERMILION, lw=0.9)
    kept = wants[told & (weight > 0)]
    if kept.size:
        room = 1.3 * numpy.abs(kept).max() or 1
        axes.set_ylim(-room, room)
    axes.set(xlabel=words, ylabel=f"{symbol(_PARAMETERS[name])} of an impact, less the fit's")


def _title(record):
    attributes = record.attributes("fit")
    decided = "" if attributes.get("law_decided") else ", not decided"
    return (f"{int(attributes['impacts']):,} impacts, {str(attributes['law']).capitalize()}'s law{decided}\n"
            f"{100 * attributes['predicted']:.1f} % of held-out impacts are predicted within the noise")


def draw_into(figure, record, look):
    panels = side_by_side(figure, 4, 2.6)
    for axes, name in zip(panels, _SPEEDS):
        _draw_profile(axes, record, name)
    for axes, name in zip(panels[2:], _SPEEDS):
        _draw_impacts(axes, record, look, name)
    look.title(figure, _title(record))
    return panels[2:]
