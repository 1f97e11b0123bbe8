"""Basins of attraction: a sweep over two numbers of the start, in each cell the attractor that its start came to."""

import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .legends import LegendBelow
from .mode_map import NO_VALUE, draw_cells
from .record import RecordError
from .style import BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, YELLOW
from .sweep_grid import SweepGrid
from .sweep_points import is_sampled
from .symbols import MEAN_SPIN, number, scene_title

#: By kind where all of a kind are one; the others in the order of their share, blue as in other figures if steady.
_OF_A_KIND = {"chaotic": VERMILION, "quasi-periodic": YELLOW}
_STEADY = (BLUE, SKY, "#332288", "#88CCEE")
_OTHERS = (GREEN, PURPLE, ORANGE, "#44AA99", "#882255", "#7A5C00")
_NOT_NAMED = "#C8C8C8"


def has_basins(record):
    """On a grid over two numbers of the start."""
    return "basins" in record and record.has("sweep", "basin") and not is_sampled(record) and len(
        record.derived(SweepGrid).axes) == 2


def size(record, look):
    width = look.width or 5.6
    return width, 0.95 * width


def _words(kind, period, spin, share):
    name = f"{period}-cycle" if kind == "cycle" else kind
    mean = f", {MEAN_SPIN} = {number(spin)}" if numpy.isfinite(spin) else ""
    return f"{name}{mean} ({100 * share:.3g} %)"


def _legend(record):
    """(colour of each basin, handles of the legend)"""
    steady, others, colours, handles, not_named = iter(_STEADY), iter(_OTHERS), [], [], 0.0
    for mode, kind, period, spin, share in zip(*(record.names("basins", name) for name in ("mode", "kind")), *(
            record.column("basins", name) for name in ("period", "mean_S", "share"))):
        colour = _OF_A_KIND.get(kind) or next(steady if mode == "steady" else others, None)
        colours.append(colour or _NOT_NAMED)
        if colour:
            handles.append(Patch(fc=colour, ec="0.3", lw=0.5, label=_words(kind, period, spin, share)))
        else:
            not_named += share
    if not_named:
        count = colours.count(_NOT_NAMED)
        handles.append(Patch(fc=_NOT_NAMED, ec="0.3", lw=0.5, label=f"{count} more ({100 * not_named:.3g} %)"))
    return colours, handles


def _saddle_words(record, saddle):
    kind, period = record.names("saddles", "kind")[saddle], record.column("saddles", "period")[saddle]
    if kind == "quasi-periodic":
        return "stable set of an unstable torus"
    return f"stable set of an unstable {period}-cycle" if period > 1 else "stable set of an unstable fixed point"


def _places(record, grid):
    """The places on boundaries that were followed, by saddle, and those that lead to none: where, in words, its look."""
    if "boundary" not in record:
        return
    saddle, leads_to = record.column("boundary", "saddle"), record.names("boundary", "leads_to")
    at = [record.column("boundary", axis) for axis in grid.axes]
    groups = [(saddle == number, mark, "w", _saddle_words(record, number))
              for number, mark in zip(range(4), "os^D") if (saddle == number).any()]
    groups.append((saddle >= 4, "P", "w", "other saddles"))
    groups.append((leads_to == "border", "x", "k", "boundary on a border"))
    groups.append((leads_to == "rounding", "+", "k", "mixed down to rounding"))
    groups.append(((saddle < 0) & (leads_to != "border") & (leads_to != "rounding"), "1", "k", "no saddle found"))
    for chosen, mark, fill, words in groups:
        if chosen.any():
            yield [values[chosen] for values in at], words, {"ls": "", "ms": 5, "mec": "k", "mew": 0.8, "marker": mark, "mfc": fill}


def draw_into(figure, record, look):
    grid = record.derived(SweepGrid)
    colours, handles = _legend(record)
    basins = grid.sorted(record, "basin").astype(float)
    if not (numpy.isin(basins, numpy.arange(-1, len(colours)))).all():
        raise RecordError(f"record '{record.path}': sweep/basin is no place in its {len(colours)} basins")
    if (basins < 0).any():
        handles.append(Patch(fc=NO_VALUE, ec="0.3", lw=0.5, label=f"no verdict ({100 * (basins < 0).mean():.3g} %)"))
    look.title(figure, f"{scene_title(grid.scene)}\nbasins of attraction, {grid.starts} in each cell")
    places = list(_places(record, grid))
    handles += [Line2D([], [], label=label, **style) for _, label, style in places]
    parts = LegendBelow(figure)
    parts.fill(handles, look)
    axes = parts.above.subplots()
    draw_cells(axes, grid, numpy.where(basins < 0, numpy.nan, basins), cmap=ListedColormap(colours or [NO_VALUE]),
               norm=BoundaryNorm(numpy.arange(max(len(colours), 1) + 1) - 0.5, max(len(colours), 1)))
    for at, _, style in places:
        axes.plot(*at, zorder=5, clip_on=False, **style)
    return [axes]
