"""A sweep over three parameters: a mode map and a map of the mean of S for each value of one of them."""

import numpy

from .mode_map import draw_cells, mode_figure, mode_style, spin_style
from .style import styled
from .sweep_grid import SweepGrid
from .symbols import MEAN_SPIN, number, symbol

#: More panels than these are too small to read: so many values are shown, evenly chosen.
MOST_PANELS = 6


@styled
def draw_mode_panels(record):
    """The parameter with the fewest values goes from panel to panel."""
    grid = SweepGrid(record)
    across = min(grid.axes, key=lambda name: len(grid.points[name]))
    values = grid.points[across]
    chosen = numpy.unique(numpy.linspace(0, len(values) - 1, min(len(values), MOST_PANELS)).round().astype(int))
    some = f"; {len(chosen)} of {len(values)} values of {symbol(across)}" if len(chosen) < len(values) else ""
    remark = f"{some}\nabove: the mode with the largest share; below: the mean spin"
    figure, middle = mode_figure(1.2 + 2.6 * len(chosen), 6.2, grid, remark)
    panels = middle.subplots(2, len(chosen), sharex=True, sharey=True)
    colours, extend = spin_style(grid.mean_spin)
    for (above, below), index in zip(panels.T, chosen):
        part = grid.slice(across, index)
        draw_cells(above, part, part.largest_mode, **mode_style(grid.modes))
        mesh = draw_cells(below, part, part.mean_spin, **colours)
        above.set(title=f"{symbol(across)} = {number(values[index])}", xlabel="")
    for axes in panels[:, 1:].ravel():
        axes.set_ylabel("")
    middle.colorbar(mesh, ax=panels[1], label=f"mean spin {MEAN_SPIN}, in $\\omega_s$", extend=extend, pad=0.01)
    return figure
