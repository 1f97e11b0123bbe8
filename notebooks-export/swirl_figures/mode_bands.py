"""A sweep over one parameter: the shares of the modes stacked, and the mean of S with its standard error."""

import numpy

from .mode_map import mode_frame
from .style import BLACK, MODE_COLOURS
from .symbols import MEAN_SPIN, axis_label


def _draw_shares(axes, grid, edges):
    """No white is to show between cells: each mode is one area, from where it begins to the top, and the next lies over it."""
    base = numpy.zeros(len(edges) - 1)
    for index, mode in enumerate(grid.modes):
        if grid.share[:, index].any():
            axes.fill_between(edges, numpy.append(base, base[-1]), 1, step="post", color=MODE_COLOURS[mode], lw=0,
                              where=numpy.append(base < 1 - 1e-9, False) | numpy.append(False, base < 1 - 1e-9))
        base += grid.share[:, index]
    axes.set(ylabel="share of the starts", ylim=(0, 1), xlim=(edges[0], edges[-1]))


def _draw_spin(axes, grid, points):
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    error = grid.mean_spin_error if grid.runs > 1 else None
    size = 4 if len(points) < 60 else 2
    # Over starts of all modes: in the colour of none.
    axes.errorbar(points, grid.mean_spin, yerr=error, fmt="o", ms=size, color=BLACK, elinewidth=0.9, capsize=1.5)
    axes.set_ylabel(f"mean spin {MEAN_SPIN}")
    if error is not None:
        axes.set_title("bars: standard error over the starts", fontsize="small", color="0.25", loc="right", pad=2)


def size(grid, look):
    return look.width or 7, 5.2


def draw_mode_bands(figure, grid, look):
    name = grid.axes[0]
    points = grid.points[name]
    above, below = mode_frame(figure, grid, look).subplots(2, 1, sharex=True, height_ratios=(3, 2))
    _draw_shares(above, grid, grid.edges(name))
    _draw_spin(below, grid, points)
    below.set_xlabel(axis_label(name))
    grid.name_ticks(below)
    return [above]
