"""A sweep over two parameters: in each cell the mode with the largest share, that share, and the mean of S."""

import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap, Normalize
from matplotlib.figure import Figure
from matplotlib.patches import Patch

from .style import MODE_COLOURS, styled
from .symbols import MEAN_SPIN, axis_label, scene_title
from .sweep_grid import SweepGrid, cell_edges

NO_VALUE = "#E6E6E6"


def draw_cells(axes, grid, values, **style):
    """A grid of cells; `values` has the axes of the grid's first and second parameter."""
    x, y = grid.axes
    mesh = axes.pcolormesh(cell_edges(grid.points[x]), cell_edges(grid.points[y]),
                           numpy.ma.masked_invalid(values).T, rasterized=values.size > 5_000, **style)
    axes.set(xlabel=axis_label(x), ylabel=axis_label(y), facecolor=NO_VALUE)
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


def mode_figure(width, height, grid, remark=""):
    """A figure with the scene above, the modes' legend below, and the subfigure in between."""
    figure = Figure(figsize=(width, height), layout="constrained")
    figure.suptitle(sweep_title(grid) + remark)
    middle, strip = figure.subfigures(2, 1, height_ratios=(height - 0.3, 0.3))
    present = [mode for index, mode in enumerate(grid.modes) if (grid.share[..., index] > 0).any()]
    handles = [Patch(fc=MODE_COLOURS[mode], ec="0.3", lw=0.5, label=mode) for mode in present]
    if not numpy.isfinite(grid.mean_spin).all():
        handles.append(Patch(fc=NO_VALUE, ec="0.3", lw=0.5, label="no mean spin"))
    strip.legend(handles=handles, loc="center", ncols=len(handles))
    return figure, middle


def sweep_title(grid):
    title = scene_title(grid.scene, leave_out=grid.points)
    return f"{title}\n{grid.runs:,} random start{'s' * (grid.runs > 1)} in each cell"


@styled
def draw_mode_map(record):
    """The figure of a sweep over two parameters."""
    grid = SweepGrid(record)
    with_share = bool((grid.largest_share < 1).any())
    count = 2 + with_share
    figure, middle = mode_figure(0.6 + 3.9 * count, 4.3, grid)
    panels = list(middle.subplots(1, count, sharey=True))
    draw_cells(panels[0], grid, grid.largest_mode, **mode_style(grid.modes))
    panels[0].set_title("Mode" + (" with the largest share" if with_share else ""))
    if with_share:
        mesh = draw_cells(panels[1], grid, grid.largest_share, cmap="Greys_r", norm=Normalize(0, 1))
        panels[1].set_title("Its share of the starts")
        middle.colorbar(mesh, ax=panels[1])
    colours, extend = spin_style(grid.mean_spin)
    mesh = draw_cells(panels[-1], grid, grid.mean_spin, **colours)
    panels[-1].set_title(f"Mean spin {MEAN_SPIN}, in units of $\\omega_s$")
    middle.colorbar(mesh, ax=panels[-1], extend=extend)
    for axes in panels[1:]:
        axes.set_ylabel("")
    return figure
