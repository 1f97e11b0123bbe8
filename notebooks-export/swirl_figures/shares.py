"""Modes that coexist: the share of the random starts of each attractor, and the mean spin of every run."""

import numpy
from matplotlib.patches import Patch
from matplotlib.ticker import MaxNLocator

from .legends import LegendBelow
from .look import is_narrow, widen
from .record import RecordError
from .riding import shown_modes
from .style import MODE_COLOURS
from .symbols import MEAN_SPIN, number, scene_title

#: More attractors than these are drawn as "others": their names could not be read.
MOST_ATTRACTORS = 12


def _attractors(record):
    """The most shared first: as many rows as are drawn."""
    return min(len(record.column("attractors", "share")), MOST_ATTRACTORS)


def size(record, look):
    width = look.width or 8
    bars = 0.9 + 0.33 * _attractors(record)
    return (width, max(3.2, bars + 0.9)) if width >= 5 else (width, bars + 3.6)


def _names(record):
    kind, mode = record.names("attractors", "kind"), record.names("attractors", "mode")
    period, mean = record.column("attractors", "period"), record.column("attractors", "mean_S")
    names = []
    for k, m, p, s in zip(kind, mode, period, mean):
        name = k if k and k != "none" else m
        name += f", period {int(p)}" if p > 1 else ""
        names.append(name + (f"\n{MEAN_SPIN} = {number(s)}" if numpy.isfinite(s) else ""))
    return names


def _interval(share, runs):
    """Wilson's interval at 95 %: what so few runs say of a share."""
    z = 1.96
    middle = (share + z * z / (2 * runs)) / (1 + z * z / runs)
    half = z * numpy.sqrt(share * (1 - share) / runs + z * z / (4 * runs * runs)) / (1 + z * z / runs)
    # As lists: a row of one in an array matplotlib's bars take for a number, which NumPy 2 warns of.
    return numpy.maximum([share - (middle - half), (middle + half) - share], 0).tolist()


def _draw_bars(axes, record, count, runs):
    share, mode = record.column("attractors", "share"), shown_modes(record, "attractors")
    colours = [MODE_COLOURS.get(name, "0.5") for name in mode[:count]]
    axes.barh(range(count), share[:count], color=colours, ec="0.3", lw=0.5, height=0.7,
              xerr=_interval(share[:count], runs), error_kw={"elinewidth": 0.9, "capsize": 2})
    axes.set(yticks=range(count), yticklabels=_names(record)[:count], xlim=(0, 1), xlabel="share of the starts",
             title="Attractors (bars: 95 %)" + (f", {count} of {len(share)}" if len(share) > count else ""))
    axes.invert_yaxis()


def _draw_runs(axes, record):
    mean, mode = record.column("runs", "mean_S"), shown_modes(record, "runs")
    for name, colour in MODE_COLOURS.items():
        of = mode == name
        axes.plot(numpy.flatnonzero(of) + 1, mean[of], "o", ms=4, color=colour, mec="0.3", mew=0.4)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.margins(y=0.15)
    widen(axes, abscissa=False)
    axes.set(xlabel="run", ylabel=f"mean spin {MEAN_SPIN}", title="Every run")


def draw_into(figure, record, look):
    runs = len(record.column("runs", "mode"))
    if runs == 0:
        raise RecordError(f"record '{record.path}' holds no runs: there is nothing to draw")
    parts = LegendBelow(figure)
    narrow = is_narrow(figure)
    bars, dots = parts.above.subplots(*((2, 1) if narrow else (1, 2)))
    _draw_bars(bars, record, _attractors(record), runs)
    _draw_runs(dots, record)
    present = [name for name in MODE_COLOURS if name in shown_modes(record, "runs")]
    parts.fill([Patch(fc=MODE_COLOURS[name], ec="0.3", lw=0.5, label=name) for name in present], look)
    look.title(figure, f"{scene_title(record.scene())}\n{runs:,} random starts")
    return [dots]
