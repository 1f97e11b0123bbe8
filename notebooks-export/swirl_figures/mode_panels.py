"""A sweep over three parameters: a mode map and a map of the mean of S for each value of one of them."""

import numpy

from .look import NARROW, is_narrow
from .mode_map import draw_cells, mode_frame, mode_style, spin_style
from .symbols import MEAN_SPIN, symbol

#: More panels than these are too small to read: so many values are shown, evenly chosen.
MOST_PANELS = 6


def _chosen(grid):
    """(the parameter that goes from panel to panel, the law or that with the fewest values; the places of the values that
    are drawn)"""
    across = min(grid.axes, key=lambda name: (name not in grid.words, len(grid.points[name])))
    count = len(grid.points[across])
    return across, numpy.unique(numpy.linspace(0, count - 1, min(count, MOST_PANELS)).round().astype(int))


def size(grid, look):
    """A panel a row in a column of a page, else a panel a column."""
    count = len(_chosen(grid)[1])
    width = look.width or 1.2 + 2.6 * count
    return width, 1.2 + 1.9 * count if width < NARROW else 6.2


def draw_mode_panels(figure, grid, look):
    across, chosen = _chosen(grid)
    values = grid.points[across]
    upright = is_narrow(figure)
    some = f"; {len(chosen)} of {len(values)} values of {symbol(across)}" if len(chosen) < len(values) else ""
    sides = ("left", "right") if upright else ("above", "below")
    middle = mode_frame(figure, grid, look,
                        f"{some}\n{sides[0]}: the mode with the largest share; {sides[1]}: the mean spin")
    shape = (len(chosen), 2) if upright else (2, len(chosen))
    panels = middle.subplots(*shape, sharex=True, sharey=True, squeeze=False)
    colours, extend = spin_style(grid.mean_spin)
    for (first, second), index in zip(panels if upright else panels.T, chosen):
        part = grid.slice(across, index)
        draw_cells(first, part, part.largest_mode, **mode_style(grid.modes))
        mesh = draw_cells(second, part, part.mean_spin, **colours)
        first.set_title(grid.text(across, index))
    for axes in panels[:, 1:].ravel():
        axes.set_ylabel("")
    for axes in panels[:-1].ravel():
        axes.set_xlabel("")
    if upright:  # half a column is too narrow for the words
        for axes in panels[-1]:
            axes.set_xlabel(symbol(grid.slice(across, 0).axes[0]))
    bar = {"ax": panels, "location": "bottom", "aspect": 40} if upright else {"ax": panels[1]}
    middle.colorbar(mesh, label=f"mean spin {MEAN_SPIN}", extend=extend, pad=0.01, **bar)
    return list(panels.ravel())
