"""A sweep over points of a box (sweep --sample) or over a table of scenes (--scenes): each point coloured by its mode, and by its mean spin, in every two of the
parameters."""

import itertools

import numpy
from matplotlib.lines import Line2D

from .legends import LegendBelow
from .look import side_by_side, width_of
from .mode_map import mode_style, spin_style
from .riding import riding_runs, share_apart
from .style import MODE_COLOURS
from .sweep_grid import logarithmic_axes, mark_values, starts_in_words
from .symbols import MEAN_SPIN, axis_label, is_parameter, scene_title

_LEAST_PANEL = 3.0

#: More points are small dots, which an edge would darken.
_MOST_EDGED = 2_000


def is_sampled(record):
    """Its cells are points, not a grid."""
    return record.has("sweep", "mean_S") and record.dimensions("sweep", "mean_S") == ("cell",)


#: Of a table of scenes more parameters would take too many panels.
_MOST_PARAMETERS = 5


def _columns(record):
    return [name for name in record.columns("sweep")
            if is_parameter(name) and record.dimensions("sweep", name) == ("cell",)]


def _parameters(record):
    """Those that vary, as many as can be drawn; the first where none does."""
    columns = _columns(record)
    vary = [name for name in columns if len(set(record.column("sweep", name).tolist())) > 1]
    return vary[:_MOST_PARAMETERS] or columns[:1]


def _scene(record):
    """With the value of each column that has but one."""
    scene = record.scene()
    for name in _columns(record):
        values = set(record.column("sweep", name).tolist())
        if len(values) == 1:
            value = values.pop()
            scene[name] = value if isinstance(value, float) else str(value)
    return scene


def _panels(record):
    """[(abscissa, ordinate, whether coloured by mode)]; of one parameter its mean spin is the ordinate."""
    names = _parameters(record)
    if len(names) == 1:
        return [(names[0], None, True)]
    colourings = (True, False) if len(names) <= 3 else (True,)  # twenty panels would be too small to read
    return [(x, y, by_mode) for x, y in itertools.combinations(names, 2) for by_mode in colourings]


def _values(record, name):
    """(numbers, the words that they stand for: of a law, in the order of their names)"""
    values = record.column("sweep", name)
    if values.dtype.kind not in "OSU":
        return values, None
    words = sorted({str(word) for word in values})
    return numpy.array([words.index(str(word)) for word in values], dtype=float), words


def size(record, look):
    count = len(_panels(record))
    width = look.width or (6.5 if count == 1 else 9.0)
    columns = max(1, min(2, count, int(width / _LEAST_PANEL)))
    rows = -(-count // columns)
    return width, 0.9 + rows * min(3.2, 10 / rows)  # no higher than a page


def _dots(count):
    return float(numpy.clip(4000 / max(count, 1), 2, 30))


def _draw_panel(axes, record, panel, modes, place):
    """What a colour bar is made for, of a panel coloured by spin."""
    x, y, by_mode = panel
    spin = record.column("sweep", "mean_S")
    abscissa, x_words = _values(record, x)
    ordinate, y_words = (spin, None) if y is None else _values(record, y)
    colours, extend = (mode_style(modes), None) if by_mode else spin_style(spin)
    edge = 0.3 if len(spin) < _MOST_EDGED else 0
    dots = axes.scatter(abscissa, ordinate, c=place if by_mode else spin, s=_dots(len(spin)), lw=edge, ec="0.4",
                        plotnonfinite=True, **colours)
    axes.set(xlabel=axis_label(x), ylabel=f"mean spin {MEAN_SPIN}" if y is None else axis_label(y),
             title="Mode with the largest share" if by_mode else f"Mean spin {MEAN_SPIN}")
    logarithmic = logarithmic_axes(record)
    mark_values(axes.xaxis, x, x_words, x in logarithmic)
    mark_values(axes.yaxis, y, y_words, y in logarithmic)
    return None if by_mode else (dots, extend)


def draw_into(figure, record, look):
    modes, share = share_apart(list(record.names("sweep", "mode")), record.column("sweep", "share", ["cell", "mode"]),
                               riding_runs(record, ["cell", "run"]))
    place = share.argmax(axis=1)
    names = _parameters(record)
    look.title(figure, f"{scene_title(_scene(record), leave_out=names)}\n{len(place):,} points, "
                       f"{starts_in_words(record)} at each")
    parts = LegendBelow(figure)
    panels = _panels(record)
    least = max(_LEAST_PANEL, 0.4 * width_of(figure))  # a pair of parameters in a row
    drawn = side_by_side(parts.above, len(panels), least)
    for axes, panel in zip(drawn, panels):
        bar = _draw_panel(axes, record, panel, modes, place)
        if bar:
            parts.above.colorbar(bar[0], ax=axes, extend=bar[1])
    parts.fill([Line2D([], [], ls="", marker="o", ms=5, color=MODE_COLOURS[mode], mec="0.4", mew=0.3, label=mode)
                for index, mode in enumerate(modes) if (place == index).any()], look)
    return drawn
