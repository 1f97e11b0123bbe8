"""A sweep over two parameters: in each cell the mode with the largest share, that share, and the mean of S."""

import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap, Normalize
from matplotlib.patches import Patch

from .legends import LegendBelow
from .look import rows_of, side_by_side, width_of
from .style import MODE_COLOURS
from .symbols import MEAN_SPIN, axis_label, scene_title

NO_VALUE = "#E6E6E6"


def draw_cells(axes, grid, values, **style):
    """A grid of cells; `values` has the axes of the grid's first and second parameter. Within a vector file they are an image:
    what shows a PDF smooths the borders of cells side by side, and the white beneath would shine through."""
    x, y = grid.axes
    mesh = axes.pcolormesh(grid.edges(x), grid.edges(y), numpy.ma.masked_invalid(values).T, rasterized=True, **style)
    axes.set(xlabel=axis_label(x), ylabel=axis_label(y), facecolor=NO_VALUE)
    grid.name_ticks(axes)
    for spine in axes.spines.values():
        spine.set_visible(True)
    return mesh


def mode_style(modes):
    """Colours of the index of a mode."""
    return {"cmap": ListedColormap([MODE_COLOURS[mode] for mode in modes]),
            "norm": BoundaryNorm(numpy.arange(len(modes) + 1) - 0.5, len(modes))}


def spin_style(values):
    """Colours about S = 0; 1 in 50 outliers at either end do not stretch the scale."""
    finite = abs(values[numpy.isfinite(values)])
    most = numpy.quantile(finite, 0.98) if len(finite) else 1.0
    extend = "both" if len(finite) and finite.max() > most * 1.001 else "neither"
    return {"cmap": "PuOr", "norm": Normalize(-(most or 1.0), most or 1.0)}, extend


def mode_handles(grid):
    """The legend: modes that are there."""
    present = [mode for index, mode in enumerate(grid.modes) if (grid.share[..., index] > 0).any()]
    handles = [Patch(fc=MODE_COLOURS[mode], ec="0.3", lw=0.5, label=mode) for mode in present]
    if not numpy.isfinite(grid.mean_spin).all():
        handles.append(Patch(fc=NO_VALUE, ec="0.3", lw=0.5, label="no mean spin"))
    return handles


def mode_frame(figure, grid, look, remark=""):
    """The part of the figure between the scene above and the modes' legend below."""
    look.title(figure, sweep_title(grid) + remark)
    parts = LegendBelow(figure)
    parts.fill(mode_handles(grid), look)
    return parts.above


def sweep_title(grid):
    title = scene_title(grid.scene, leave_out=grid.points)
    return f"{title}\n{grid.starts} in each cell{grid.remarks}"


#: Inches that a map with its colour bar needs.
_LEAST_MAP = 3.0


def _maps(grid):
    return 2 + bool((grid.largest_share < 1).any())


def size(grid, look):
    width = look.width or 0.6 + 3.9 * _maps(grid)
    rows = rows_of(width, _maps(grid), _LEAST_MAP)
    return width, 4.3 if rows == 1 else 1.0 + 2.9 * rows


def draw_mode_map(figure, grid, look):
    """The figure of a sweep over two parameters."""
    count = _maps(grid)
    middle = mode_frame(figure, grid, look)
    panels = side_by_side(middle, count, _LEAST_MAP, sharey=True)
    draw_cells(panels[0], grid, grid.largest_mode, **mode_style(grid.modes))
    panels[0].set_title("Mode" + (" with the largest share" if count == 3 else ""))
    if count == 3:
        mesh = draw_cells(panels[1], grid, grid.largest_share, cmap="Greys_r", norm=Normalize(0, 1))
        panels[1].set_title("Its share of the starts")
        middle.colorbar(mesh, ax=panels[1])
    colours, extend = spin_style(grid.mean_spin)
    mesh = draw_cells(panels[-1], grid, grid.mean_spin, **colours)
    panels[-1].set_title(f"Mean spin {MEAN_SPIN}")
    middle.colorbar(mesh, ax=panels[-1], extend=extend)
    if rows_of(width_of(figure), count, _LEAST_MAP) == 1:
        for axes in panels[1:]:
            axes.set_ylabel("")
    return panels
