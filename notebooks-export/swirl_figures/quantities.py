"""What a sweep found in each cell, besides modes: over one parameter, a line for each value of another; and over two, as a
map."""

from dataclasses import dataclass

import numpy
from matplotlib.colors import BoundaryNorm, ListedColormap, LogNorm, Normalize
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .legends import LegendBelow
from .mode_map import NO_VALUE, draw_cells, spin_style, sweep_title
from .record import RecordError
from .style import CYCLE
from .sweep_grid import SweepGrid, mark_values
from .sweep_points import is_sampled
from .symbols import MEAN_SPIN, axis_label, number

#: More lines than these are not told apart: so many values are shown, evenly chosen.
MOST_LINES = 8

#: Longer periods have one colour.
_MOST_PERIODS = 8


@dataclass(frozen=True)
class Quantity:
    column: str  #: of the record's group `sweep`, over its cells, or with run_ before it over their starts
    label: str
    error: str = None  #: the column of its standard error


QUANTITIES = {
    "S": Quantity("mean_S", f"mean spin {MEAN_SPIN}", "mean_S_error"),
    "exponent": Quantity("largest_exponent", r"largest Lyapunov exponent $\lambda$, per impact"),
    "period": Quantity("run_period", "period of the cycle, in impacts"),
    "RC": Quantity("recurrence_rate", "recurrence rate RC"),
}


def has_quantities(record):
    return "sweep" in record and record.has("sweep", "mean_S") and not is_sampled(record)


def has_plane(record):
    return has_quantities(record) and len(record.derived(SweepGrid).axes) >= 2


def _quantity(look):
    return QUANTITIES[look.of or "S"]


def _usual(periods):
    """The period of most of the starts of each cell; NaN where most have none."""
    return numpy.apply_along_axis(lambda own: max(sorted(set(own)), key=list(own).count), -1, periods)


def _values(record, grid, quantity):
    """(values, their standard errors or None) over the axes of the grid."""
    if quantity.column == "run_period":
        periods = _usual(grid.sorted(record, "run_period", "run"))
        return numpy.where(periods > 0, periods, numpy.nan), None
    return (grid.sorted(record, quantity.column),
            grid.sorted(record, quantity.error) if quantity.error and grid.runs > 1 else None)


def _at_middle(grid, values, kept):
    """The grid and arrays over it where parameters other than those kept stand at their middle value."""
    for name in [name for name in grid.axes if name not in kept]:
        at, middle = grid.axes.index(name), len(grid.points[name]) // 2
        values = [None if array is None else array.take(middle, axis=at) for array in values]
        grid = grid.at_middle(name)
    return grid, values


def _by_size(grid):
    """The parameters by their number of values, most first."""
    return sorted(grid.axes, key=lambda name: -len(grid.points[name]))


def _lines_over(grid, look):
    """(parameter along the abscissa, the one with a line for each value or None)"""
    over = (look.over or "").replace("-", "_") or _by_size(grid)[0]
    names = {name.replace("-", "_"): name for name in grid.axes}
    if over not in names and look.over:
        raise RecordError(f"over = {look.over}: the sweep's parameters are {', '.join(grid.axes)}")
    over = names.get(over, over)
    return over, next((name for name in _by_size(grid) if name != over), None)


#: In grey, too, lines are told apart.
_MARKERS = "os^Dv<>P"


def means_size(record, look):
    return look.width or 7, 4.6


def draw_means(figure, record, look):
    grid, quantity = record.derived(SweepGrid), _quantity(look)
    over, across = _lines_over(grid, look)
    grid, (values, errors) = _at_middle(grid, _values(record, grid, quantity), (over, across))
    chosen = numpy.arange(1)
    if across:
        at = grid.axes.index(across)
        values, errors = (None if array is None else numpy.moveaxis(array, at, 0) for array in (values, errors))
        count = len(grid.points[across])
        chosen = numpy.unique(numpy.linspace(0, count - 1, min(count, MOST_LINES)).round().astype(int))
        some = f"; {len(chosen)} of {count} values are drawn" if len(chosen) < count else ""
    else:
        values, errors, some = values[None], None if errors is None else errors[None], ""
    look.title(figure, sweep_title(grid) + some)
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    handles = []
    for line, index in enumerate(chosen):
        style = {"color": CYCLE[line], "marker": _MARKERS[line], "ms": 4 if len(grid.points[over]) < 60 else 2, "lw": 1.1}
        error = None if errors is None else numpy.where(numpy.isfinite(errors[index]), errors[index], 0)
        axes.errorbar(grid.points[over], values[index], yerr=error, elinewidth=0.8, capsize=1.5, **style)
        handles.append(Line2D([], [], label=grid.text(across, index) if across else quantity.label, **style))
    if quantity.column == "mean_S":
        axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    if errors is not None:
        axes.set_title("bars: standard error over the starts", fontsize="small", color="0.25", loc="right", pad=2)
    axes.set(xlabel=axis_label(over), ylabel=quantity.label)
    mark_values(axes.xaxis, over, grid.words.get(over), over in grid.logarithmic)
    parts.fill(handles, look)
    return [axes]


def map_size(record, look):
    width = look.width or 6.4
    return width, 0.75 * width + 0.5


def _colours(quantity, values):
    """(style of the mesh, whether the bar's ends are pointed, handles of a legend in place of a bar)"""
    finite = values[numpy.isfinite(values)]
    if quantity.column == "run_period":
        known = sorted({int(value) for value in finite if value <= _MOST_PERIODS})
        longer = bool((finite > _MOST_PERIODS).any())
        names = [f"period {value}" for value in known] + ["a longer period"] * longer
        colours = ["#0B1F4B", *CYCLE][:len(names)]
        handles = [Patch(fc=colour, ec="0.3", lw=0.5, label=name) for colour, name in zip(colours, names)]
        places = numpy.full(values.shape, numpy.nan)
        for place, value in enumerate(known):
            places[values == value] = place
        places[values > _MOST_PERIODS] = len(known)
        style = {"cmap": ListedColormap(colours or ["white"]), "norm": BoundaryNorm(numpy.arange(len(colours) + 2) - 0.5, max(len(colours), 1) + 1)}
        return places, style, "neither", handles
    if quantity.column == "recurrence_rate":
        positive = finite[finite > 0]
        least = max(positive.min(initial=1), 1e-6)
        return numpy.where(values > 0, values, numpy.nan), {"cmap": "cividis", "norm": LogNorm(min(least, 0.5), 1)}, "neither", []
    style, extend = spin_style(values)
    if quantity.column == "largest_exponent":
        style["cmap"] = "PuOr_r"
    return values, style, extend, []


def draw_map(figure, record, look):
    grid, quantity = record.derived(SweepGrid), _quantity(look)
    kept = [name for name in grid.axes if name in _by_size(grid)[:2]]
    grid, (values, _) = _at_middle(grid, _values(record, grid, quantity), kept)
    places, style, extend, handles = _colours(quantity, values)
    look.title(figure, sweep_title(grid))
    parts = LegendBelow(figure) if handles or numpy.isnan(places).any() else None
    above = parts.above if parts else figure
    axes = above.subplots()
    mesh = draw_cells(axes, grid, places, **style)
    axes.set_title(quantity.label[0].upper() + quantity.label[1:])
    if not handles:
        above.colorbar(mesh, ax=axes, extend=extend)
    if numpy.isnan(places).any():
        none = "no cycle" if quantity.column == "run_period" else f"no {'mean spin' if quantity.column == 'mean_S' else 'value'}"
        handles = [*handles, Patch(fc=NO_VALUE, ec="0.3", lw=0.5, label=none)]
    if parts:
        parts.fill(handles, look)
    return [axes]
