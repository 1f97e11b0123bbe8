"""What whoever asks for a figure may choose: its width, the size of its letters, titles, the range of its abscissa."""

import dataclasses
import math
import textwrap

from matplotlib.figure import Figure

from .record import RecordError

#: A figure of this width, in inches, is as narrow as a column of a page: panels go below one another.
NARROW = 5.0

FONT_SIZE, FONT_SIZE_OF_A_COLUMN = 9.0, 8.0


@dataclasses.dataclass(frozen=True)
class Look:
    width: float = None      #: inches; None: as wide as the kind of figure is drawn on a screen
    font_size: float = None  #: points; None: 9, or 8 in a column
    titles: bool = True      #: False: none above the figure, as a paper's caption says it
    xlim: tuple = None       #: (least, most) of the abscissa
    x: str = "psi"           #: coordinates of a section portrait
    y: str = "S"
    notes: list = dataclasses.field(default_factory=list, compare=False)  #: of its caption, filled as it is drawn

    @property
    def letters(self):
        narrow = self.width is not None and self.width < NARROW
        return self.font_size or (FONT_SIZE_OF_A_COLUMN if narrow else FONT_SIZE)

    def title(self, figure, text):
        """Above the figure, broken where it is wider than that; of a caption the first lines."""
        self.notes.extend(text.split("\n"))
        if not self.titles:
            return
        width = figure.bbox.width / figure.figure.dpi
        longest = max(20, int(72 * width / (0.56 * self.letters * 10 / 9)))
        lines = [line for part in text.split("\n") for line in textwrap.wrap(part, longest)]
        figure.suptitle("\n".join(lines))


def is_narrow(figure):
    return width_of(figure) < NARROW


def width_of(figure):
    """In inches; also of a subfigure."""
    return figure.bbox.width / figure.figure.dpi


def side_by_side(figure, count, least, **options):
    """`count` panels in as many rows as leave each `least` inches of width: a list of axes."""
    columns = max(1, min(count, int(width_of(figure) / least)))
    rows = math.ceil(count / columns)
    panels = figure.subplots(rows, columns, squeeze=False, **options).ravel()
    for axes in panels[count:]:
        axes.remove()
    return list(panels[:count])


def rows_of(width, count, least):
    """How many rows side_by_side makes of a figure of that width."""
    return math.ceil(count / max(1, min(count, int(width / least))))


#: Of a legend, in its letters' size: the width of a letter in the mean, of what stands beside a label, and a line's height.
_LETTER, _BESIDE, _LINE = 0.55, 4.2, 1.65


def legend_lines(handles, width, letters):
    """(number of columns, of lines) of a legend below a figure of that width: as many columns as fit, each as wide as its
    longest label (matplotlib fills one after the other)."""
    lengths = [len(handle.get_label()) for handle in handles]
    room = 72 * width / (0.89 * letters)
    for columns in range(len(handles), 1, -1):
        lines = math.ceil(len(handles) / columns)
        longest = [max(lengths[first:first + lines]) for first in range(0, len(lengths), lines)]
        if sum(_LETTER * length + _BESIDE for length in longest) <= room:
            return len(longest), lines
    return 1, len(handles)


#: Of a figure's height, that a legend may take.
_SHARE = 0.2


class LegendBelow:
    """A figure in two parts: `above`, for the panels, and a legend as high as it needs below; beside the panels it would
    take much of a column's width. Panels may be drawn before what the legend lists is known."""

    def __init__(self, figure):
        self._figure, self._grid = figure, figure.add_gridspec(2, 1, height_ratios=(12, 1))
        self.above = figure.add_subfigure(self._grid[0])
        self._below = figure.add_subfigure(self._grid[1])

    def fill(self, handles, look):
        """Of a whole figure the legend's height is added to that of the panels if it takes more than a fifth of it."""
        columns, lines = legend_lines(handles, width_of(self._figure), look.letters)
        strip = (_LINE * 0.89 * look.letters * lines + 8) / 72
        height = self._figure.bbox.height / self._figure.figure.dpi
        if strip > _SHARE * height and self._figure is self._figure.figure:
            height += strip - _SHARE * height
            self._figure.set_size_inches(width_of(self._figure), height)
        self._grid.set_height_ratios((max(height - strip, 0.5), strip))
        self._below.legend(handles=handles, loc="center", ncols=columns, columnspacing=1.2, handlelength=1.6,
                           borderaxespad=0)


def limit_abscissa(axes, look, kind):
    """--xlim, on the axes that the kind's drawing named as those with its abscissa."""
    if look.xlim is None:
        return
    if not axes:
        raise RecordError(f"xlim = {look.xlim[0]:g}:{look.xlim[1]:g}: a figure of kind {kind} has no abscissa to limit")
    for panel in axes:
        panel.set_xlim(look.xlim)


def blank_figure(width, height):
    return Figure(figsize=(width, height), layout="constrained")


#: Values that differ by less are one value and its rounding: an axis of them spans LEAST_SPAN in place of that.
ROUNDING, LEAST_SPAN = 1e-6, 0.02


def widen(axes, abscissa=True):
    """Axes of one value, or one point."""
    pairs = ((axes.get_ylim, axes.set_ylim), (axes.get_xlim, axes.set_xlim))
    for limits, limit in pairs if abscissa else pairs[:1]:
        begin, end = limits()
        if end - begin < ROUNDING:
            middle = (begin + end) / 2
            limit(middle - LEAST_SPAN / 2, middle + LEAST_SPAN / 2)
