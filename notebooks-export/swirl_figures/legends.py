"""Legends as wide as there is room: below the panels of a figure, or above the curves within a panel."""

import math

from matplotlib import rcParams

from .look import width_of
from .words import broken, letters_across, letters_in

#: Of a legend, in its letters' size: the width of a letter in the mean, of what stands beside a label, and a line's height.
_LETTER, _BESIDE, _LINE = 0.55, 4.2, 1.65

#: A legend's letters in those of the figure.
_SMALL = 8 / 9


def legend_lines(labels, width, letters):
    """(number of columns, of lines) of a legend of that width: as many columns as fit, each as wide as its longest label
    (matplotlib fills one after the other)."""
    lengths = [max(map(letters_in, label.split("\n"))) for label in labels]
    heights = [1 + label.count("\n") for label in labels]
    room = 72 * width / (_SMALL * letters)
    for columns in range(len(labels), 0, -1):
        rows = math.ceil(len(labels) / columns)
        parts = [slice(first, first + rows) for first in range(0, len(labels), rows)]
        if columns == 1 or sum(_LETTER * max(lengths[part]) + _BESIDE for part in parts) <= room:
            return len(parts), max(sum(heights[part]) for part in parts)
    return 1, 0


def _height(lines, letters):
    return (_LINE * _SMALL * letters * lines + 8) / 72


def _broken(labels, width, letters):
    """Those in lines that are wider than the legend may be."""
    longest = max(8, int((72 * width / (_SMALL * letters) - _BESIDE) / _LETTER))
    return [broken(label, longest) for label in labels]


#: Of a figure's height, that a legend may take.
_SHARE = 0.2


class LegendBelow:
    """A figure in two parts: `above`, for the panels, and a legend as high as it needs below; beside the panels it would
    take much of a column's width. Panels may be drawn before what the legend lists is known."""

    def __init__(self, figure):
        self._figure, self._grid = figure, figure.add_gridspec(2, 1, height_ratios=(12, 1))
        self.above = figure.add_subfigure(self._grid[0])
        self._below = figure.add_subfigure(self._grid[1])

    def _sizes(self, handles, look, words):
        """(labels, columns, lines of words, height of the strip, height of the figure with it)"""
        width = width_of(self._figure)
        labels = _broken([handle.get_label() for handle in handles], width, look.letters)
        columns, lines = legend_lines(labels, width, look.letters)
        below = broken(words, letters_across(width, _SMALL * look.letters)).split("\n") if words else []
        strip = _height(lines + len(below), look.letters)
        height = self._figure.bbox.height / self._figure.figure.dpi
        if strip > _SHARE * height and self._figure is self._figure.figure:
            height += strip - _SHARE * height
        return labels, columns, below, strip, height

    def share(self, handles, look, words=""):
        """Of the figure's height, that this legend would take."""
        *_, strip, height = self._sizes(handles, look, words)
        return strip / height

    def fill(self, handles, look, words=""):
        """Of a whole figure the legend's height is added to that of the panels if it takes more than a fifth of it. Words
        stand below the handles, and need less room than a handle each."""
        labels, columns, below, strip, height = self._sizes(handles, look, words)
        if self._figure is self._figure.figure:
            self._figure.set_size_inches(width_of(self._figure), height)
        self._grid.set_height_ratios((max(height - strip, 0.5), strip))
        of_words = _height(len(below), look.letters) / strip if below else 0
        self._below.legend(handles, labels, loc="center", bbox_to_anchor=(0, of_words, 1, 1 - of_words), ncols=columns,
                           columnspacing=1.2, handlelength=1.6, borderaxespad=0)
        if below:
            self._below.text(0.5, 0.02, "\n".join(below), ha="center", va="bottom", fontsize="small", linespacing=1.35)


def _share(places, ratios):
    return sum(ratios[places.start:places.stop]) / sum(ratios)


def fits_across(axes, words, letters):
    """Whether words of that size are no wider than a panel, about."""
    return letters_in(words) <= letters_across(panel_size(axes)[0], letters)


def panel_size(axes):
    """(width, height) in inches of a panel without its labels, about: before the figure's layout is known."""
    figure, place, letters = axes.figure, axes.get_subplotspec(), rcParams["font.size"] / 72
    grid = place.get_gridspec()
    across = _share(place.colspan, grid.get_width_ratios()) * width_of(figure)
    upright = _share(place.rowspan, grid.get_height_ratios()) * figure.bbox.height / figure.figure.dpi
    return max(across - 5.5 * letters, 4 * letters), max(upright - 5.5 * letters, 4 * letters)


def legend_inside(axes, side="left", **options):
    """Above the curves: the ordinate goes on as far as the legend needs. It never makes its panel narrower."""
    handles, labels = axes.get_legend_handles_labels()
    if not handles:
        return
    letters = rcParams["font.size"]
    width, height = panel_size(axes)
    labels = _broken(labels, width, letters)
    columns, lines = legend_lines(labels, width, letters)
    bottom, top = axes.get_ylim()
    axes.set_ylim(bottom, bottom + (top - bottom) / (1 - min(_height(lines, letters) / height, 0.6)))
    axes.legend(handles, labels, loc=f"upper {side}", ncols=columns, borderaxespad=0.1, columnspacing=1.2, handlelength=1.6,
                **options).set_in_layout(False)
