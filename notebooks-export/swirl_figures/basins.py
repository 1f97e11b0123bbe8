"""Basins of attraction: a sweep over two numbers of the start, in each cell the attractor that its start came to."""

import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.patches import Patch

from .look import LegendBelow
from .mode_map import draw_cells
from .style import BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION, YELLOW
from .symbols import MEAN_SPIN, number, scene_title
from .sweep_grid import SweepGrid

#: By kind where all of a kind are one; the others in the order of their share.
_OF_A_KIND = {"chaotic": VERMILION, "quasi-periodic": YELLOW, "none": "#6B6B6B", "transient": "#4A4A4A"}
_OTHERS = (BLUE, GREEN, SKY, PURPLE, ORANGE, "#332288", "#44AA99", "#882255")
_NOT_NAMED = "#C8C8C8"


def has_basins(record):
    """On a grid over two numbers of the start."""
    return "basins" in record and len(record.dimensions("sweep", "basin")) == 2 and all(
        record.size("sweep", name) > 1 for name in record.dimensions("sweep", "basin"))


def size(record, width):
    width = width or 5.6
    return width, 0.95 * width


def _words(mode, kind, period, spin, share):
    name = {"none": mode}.get(kind, f"{period}-cycle" if kind == "cycle" else kind)
    mean = f", {MEAN_SPIN} = {number(spin)}" if numpy.isfinite(spin) else ""
    return f"{name}{mean} ({100 * share:.3g} %)"


def _legend(record):
    """(colour of each basin, handles of the legend)"""
    others, colours, handles, not_named = iter(_OTHERS), [], [], 0.0
    columns = zip(record.names("basins", "mode"), record.names("basins", "kind"), record.column("basins", "period"),
                  record.column("basins", "mean_S"), record.column("basins", "share"))
    for mode, kind, period, spin, share in columns:
        colour = _OF_A_KIND.get(kind) or next(others, None)
        colours.append(colour or _NOT_NAMED)
        if colour:
            handles.append(Patch(fc=colour, ec="0.3", lw=0.5, label=_words(mode, kind, period, spin, share)))
        else:
            not_named += share
    if not_named:
        count = colours.count(_NOT_NAMED)
        handles.append(Patch(fc=_NOT_NAMED, ec="0.3", lw=0.5, label=f"{count} more ({100 * not_named:.3g} %)"))
    return colours, handles


def draw_into(figure, record, look):
    grid = record.derived(SweepGrid)
    x, y = grid.axes
    values = record.column("sweep", "basin", grid.axes).astype(float)
    order = [numpy.argsort(record.column("sweep", name)) for name in grid.axes]
    settings = record.attributes("settings")
    start = ", ".join(f"{name} = {number(settings[name])}" for name in ("x", "y", "vx", "vy", "angle", "spin")
                      if name in settings)
    look.title(figure, f"{scene_title(grid.scene)}\nbasins of attraction" + (f"; starts with {start}" if start else ""))
    colours, handles = _legend(record)
    parts = LegendBelow(figure)
    parts.fill(handles, look)
    axes = parts.above.subplots()
    draw_cells(axes, grid, values[numpy.ix_(*order)], cmap=ListedColormap(colours),
               norm=BoundaryNorm(numpy.arange(len(colours) + 1) - 0.5, len(colours)))
    return [axes]
