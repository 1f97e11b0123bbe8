"""The samples of attractors across a parameter, darker where a column has more of them: dots, or where columns are close to
one another cells that leave no gap."""

import numpy
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

from .legends import panel_size
from .ranges import inside
from .style import ORANGE, SKY

#: By the record's `origin`: name, colour where samples are densest, size. Of falling size, for attractors that are found in
#: several ways lie on one another.
_ORIGINS = {0: ("random starts", "#3C3C3C", 7), 1: ("followed up", SKY, 4), 2: ("followed down", ORANGE, 2)}

#: How much of its colour the sparsest sample has; the rest is white. Seen on white, and light beneath branches.
_PALEST = 0.2

#: The density of a sample is that of its neighbours within this height, in points: less would show the chance of single
#: samples, more would smear edges out.
_WINDOW = 5.0

#: The share of a column's samples within a window that has the full colour: of a cycle of period up to eight, or of a peak
#: in chaos ten times as dense as samples spread evenly over a panel.
_FULL = 0.12

#: Points between columns, up to which they are drawn as cells. Dots are rounded to pixels: where two columns get one pixel
#: more between them a white line stands, which looks like a window of a short period. Columns farther apart are seen as such.
_CLOSE = 6.0

#: Points that a cell is wide and high at least: a pixel, or all cells would not be seen.
_CELL = 0.5


def _weights(x, origin, start):
    """(weight, column) of each sample: every start of a column has the same, whatever number of samples it lists (of a cycle
    one period); those of a column, of one origin, add up to 1."""
    _, column = numpy.unique(numpy.column_stack([x, origin]), axis=0, return_inverse=True)
    _, orbit = numpy.unique(numpy.column_stack([column, start]), axis=0, return_inverse=True)
    column, orbit = column.ravel(), orbit.ravel()
    of_orbit = 1 / numpy.bincount(orbit)[orbit]
    return of_orbit / numpy.bincount(column, weights=of_orbit)[column], column


def shares_nearby(y, weight, column, window):
    """The weight of the samples within a window about each, of those of its column."""
    order = numpy.lexsort((y, column))
    y, sums, first = y[order], numpy.append(0, numpy.cumsum(weight[order])), numpy.flatnonzero(numpy.diff(column[order], prepend=-1))
    near = numpy.empty(len(y))
    for begin, end in zip(first, [*first[1:], len(y)]):
        own = y[begin:end]
        low, high = (begin + numpy.searchsorted(own, own + side * window / 2, side=to) for side, to in ((-1, "left"), (1, "right")))
        near[order[begin:end]] = sums[high] - sums[low]
    return near


def _tinted(colour, shades):
    """A row of (red, green, blue) for each shade."""
    part = (_PALEST + (1 - _PALEST) * shades)[:, None]
    return 1 - part * (1 - numpy.array(to_rgb(colour)))


class Samples:
    """Those in the range. The limits of the axes follow from what else is drawn, too: `draw` comes when they are known."""

    def __init__(self, axes, record, look, variable):
        seen = inside(record.column("samples", "parameter"), look.xlim)
        self._x, self._y, origin, start = (record.column("samples", name)[seen] for name in ("parameter", variable, "origin", "start"))
        scale = 0.5 if len(origin) > 5_000 else 1
        present = [value for value in _ORIGINS if (origin == value).any()]
        self._sets = [(origin == value, label, colour, scale * (2 if len(present) == 1 else size))
                      for value, (label, colour, size) in _ORIGINS.items() if value in present]
        self._weight, self._column = _weights(self._x, origin, start)
        self._axes = axes
        axes.update_datalim(numpy.column_stack([self._x, self._y]))

    def handles(self):
        return [Line2D([], [], ls="", marker="o", ms=3, mec="none", color=colour, label=f"{label} (darker: more)")
                for _, label, colour, _ in self._sets]

    def draw(self):
        limits = self._axes.axis()
        columns = numpy.unique(self._x)
        shades = self._shades(limits)
        if self._are_close(columns):
            self._draw_cells(columns, shades)
        else:
            for of, _, colour, size in self._sets:
                self._axes.scatter(self._x[of], self._y[of], s=size, color=_tinted(colour, shades[of]), lw=0, zorder=1)
        self._axes.axis(limits)

    def _shades(self, limits):
        """0 to 1, by the share of a column's samples that lie about each."""
        window = _WINDOW / (72 * panel_size(self._axes)[1]) * (limits[3] - limits[2])
        return numpy.minimum(shares_nearby(self._y, self._weight, self._column, window) / _FULL, 1) ** 0.7

    def _points_across(self, length):
        begin, end = self._axes.get_xlim()
        return 72 * panel_size(self._axes)[0] * length / (end - begin)

    def _are_close(self, columns):
        """And evenly spaced, but for columns that have no samples."""
        if len(columns) < 2:
            return False
        between = numpy.diff(columns).min()
        number = (columns - columns[0]) / between
        return self._points_across(between) <= _CLOSE and bool((abs(number - number.round()) < 0.1).all())

    def _draw_cells(self, columns, shades):
        """A column's samples are as wide as it is, to where the next begins, and as high as their dots would be."""
        between = numpy.diff(columns).min()
        left, right = columns[0] - between / 2, columns[-1] + between / 2
        bottom, top = self._axes.get_ylim()
        across = min(round((right - left) / between), max(int(self._points_across(right - left) / _CELL), 1))
        upright = int(72 * panel_size(self._axes)[1] / _CELL) + 1
        x = numpy.clip((self._x - left) / (right - left) * across, 0, across - 1).astype(int)
        y = numpy.floor((self._y - bottom) / (top - bottom) * upright)
        picture = numpy.zeros((upright, across, 4), dtype=numpy.uint8)
        for of, _, colour, size in self._sets:
            high = max(round(size**0.5 / _CELL), 1)
            shown = numpy.flatnonzero(of)[numpy.argsort(shades[of], kind="stable")]  # the densest last, above the others
            tints = numpy.column_stack([_tinted(colour, shades[shown]) * 255, numpy.full(len(shown), 255)]).round()
            for row in range(-(high // 2), high - high // 2):
                inside_axes = (y[shown] + row >= 0) & (y[shown] + row < upright)
                cells = shown[inside_axes]
                picture[(y[cells] + row).astype(int), x[cells]] = tints[inside_axes]
        self._axes.imshow(picture, extent=(left, right, bottom, top), origin="lower", aspect="auto",
                          interpolation="nearest", zorder=1)


def draw_in_one_colour(axes, record, colour, look):
    """S of all samples in the range as dots beneath something else; their handle."""
    x, y = record.column("samples", "parameter"), record.column("samples", "S")
    seen = inside(x, look.xlim)
    style = {"ls": "", "marker": ".", "ms": 1.5, "mew": 0, "color": colour}
    axes.plot(x[seen], y[seen], zorder=0, **style)
    return [Line2D([], [], label="samples of the diagram", **{**style, "ms": 5})] if seen.any() else []
