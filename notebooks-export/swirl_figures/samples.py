"""The samples of attractors across a parameter: dots, or where columns are close to one another cells that leave no gap."""

import numpy
from matplotlib.colors import to_rgb
from matplotlib.lines import Line2D

from .legends import panel_size
from .ranges import inside
from .style import ORANGE, SKY

#: By the record's `origin`: name, colour, size. Light, for branches lie over them; of falling size, for attractors that are
#: found in several ways lie on one another.
_ORIGINS = {0: ("random starts", "#8A8A8A", 7), 1: ("followed up", SKY, 4), 2: ("followed down", ORANGE, 2)}

#: Points between columns, up to which they are drawn as cells. Dots are rounded to pixels: where two columns get one pixel
#: more between them a white line stands, which looks like a window of a short period. Columns farther apart are seen as such.
_CLOSE = 6.0

#: Points that a cell is wide and high at least: a pixel, or all cells would not be seen.
_CELL = 0.5


class Samples:
    """Those in the range. The limits of the axes follow from what else is drawn, too: `draw` comes when they are known."""

    def __init__(self, axes, record, look, variable):
        seen = inside(record.column("samples", "parameter"), look.xlim)
        self._x, self._y, origin = (record.column("samples", name)[seen] for name in ("parameter", variable, "origin"))
        scale = 0.5 if len(origin) > 5_000 else 1
        present = [value for value in _ORIGINS if (origin == value).any()]
        self._sets = [(origin == value, label, colour, scale * (2 if len(present) == 1 else size))
                      for value, (label, colour, size) in _ORIGINS.items() if value in present]
        self._axes = axes
        axes.update_datalim(numpy.column_stack([self._x, self._y]))

    def handles(self):
        return [Line2D([], [], ls="", marker="o", ms=3, mec="none", color=colour, label=label)
                for _, label, colour, _ in self._sets]

    def draw(self):
        limits = self._axes.axis()
        columns = numpy.unique(self._x)
        if self._are_close(columns):
            self._draw_cells(columns)
        else:
            for of, _, colour, size in self._sets:
                self._axes.scatter(self._x[of], self._y[of], s=size, color=colour, lw=0, zorder=1)
        self._axes.axis(limits)

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

    def _draw_cells(self, columns):
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
            for row in range(-(high // 2), high - high // 2):
                inside_axes = of & (y + row >= 0) & (y + row < upright)
                picture[(y[inside_axes] + row).astype(int), x[inside_axes]] = [*(round(255 * part) for part in to_rgb(colour)), 255]
        self._axes.imshow(picture, extent=(left, right, bottom, top), origin="lower", aspect="auto",
                          interpolation="nearest", zorder=1)
