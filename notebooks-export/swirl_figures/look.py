"""What whoever asks for a figure may choose: its width, the size of its letters, titles, the range of its abscissa."""

import dataclasses
import math

from matplotlib.figure import Figure

from .ranges import range_words
from .record import RecordError
from .words import broken, letters_across

#: A figure of this width, in inches, is as narrow as a column of a page: panels go below one another.
NARROW = 5.0

FONT_SIZE, FONT_SIZE_OF_A_COLUMN = 9.0, 8.0


@dataclasses.dataclass(frozen=True)
class Look:
    width: float = None      #: inches; None: as wide as the kind of figure is drawn on a screen
    font_size: float = None  #: points; None: 9, or 8 in a column
    titles: bool = True      #: False: none above the figure, as a paper's caption says it
    xlim: tuple = None       #: (least, most) of the abscissa
    ylim: tuple = None       #: of the ordinate
    log: str = None          #: axes that are logarithmic: "x", "y" or "xy"
    of: str = None           #: the quantity of kinds means and map; None: S
    over: str = None         #: the parameter along the abscissa of kind means; None: that of most values
    x: str = None            #: coordinates of a section portrait; None: psi
    y: str = None            #: None: S
    scales: dict = dataclasses.field(default_factory=dict, compare=False)  #: {"xlim": what its numbers were divided by}: SI
    limited: list = dataclasses.field(default_factory=list, compare=False)  #: axes that xlim and ylim are for, filled likewise
    notes: list = dataclasses.field(default_factory=list, compare=False)  #: of its caption, filled as it is drawn

    @property
    def letters(self):
        narrow = self.width is not None and self.width < NARROW
        return self.font_size or (FONT_SIZE_OF_A_COLUMN if narrow else FONT_SIZE)

    @property
    def coordinates(self):
        return self.x or "psi", self.y or "S"

    def title(self, figure, text):
        """Above the figure, broken where it is wider than that; of a caption the first lines."""
        self.notes.extend(text.split("\n"))
        if not self.titles:
            return
        figure.suptitle(broken(text, letters_across(width_of(figure), self.letters * 10 / 9)))


def is_narrow(figure):
    return width_of(figure) < NARROW


def width_of(figure):
    """In inches; also of a subfigure."""
    return figure.bbox.width / figure.figure.dpi


def side_by_side(figure, count, least, **options):
    """`count` panels in as many rows as leave each `least` inches of width: a list of axes."""
    columns = columns_of(width_of(figure), count, least)
    rows = math.ceil(count / columns)
    panels = figure.subplots(rows, columns, squeeze=False, **options).ravel()
    for axes in panels[count:]:
        axes.remove()
    return list(panels[:count])


def columns_of(width, count, least):
    return max(1, min(count, int(width / least)))


def rows_of(width, count, least):
    """How many rows side_by_side makes of a figure of that width."""
    return math.ceil(count / columns_of(width, count, least))


def limit(axes, look, kind, record):
    """--xlim, --ylim and --log, on the axes that the kind's drawing named as those with its abscissa."""
    look.limited.extend(axes or ())
    _make_logarithmic(axes, look, kind, record)
    _limit(axes, look, "y", "ordinate", kind, record)
    _limit(axes, look, "x", "abscissa", kind, record)


def _make_logarithmic(axes, look, kind, record):
    for letter, name in (("x", "abscissa"), ("y", "ordinate")) if look.log else ():
        if letter not in look.log:
            continue
        if not axes:
            raise RecordError(f"log = {look.log}: a figure of kind {kind} has no {name} to choose")
        for panel in axes:
            shown = (look.xlim if letter == "x" else look.ylim) or getattr(panel.dataLim, f"interval{letter}")
            if panel.images or not shown[1] > 0:
                raise RecordError(f"log = {look.log}: " + (f"a figure of kind {kind} has a picture of even cells along the {name}"
                                  if panel.images else f"record '{record.path}' has nothing above 0 along the {name}"))
            getattr(panel, f"set_{letter}scale")("log", nonpositive="mask")


def _limit(axes, look, letter, name, kind, record):
    """--xlim or --ylim: `letter` x or y, `name` that of the axis."""
    option = f"{letter}lim"
    limits = getattr(look, option)
    if limits is None:
        return
    given = f"{option} = {range_words(look, option)}"
    if not axes:
        raise RecordError(f"{given}: a figure of kind {kind} has no {name} to limit")
    for panel in axes:
        least, most = getattr(panel.dataLim, f"interval{letter}")  # infinite where nothing but words is drawn
        if math.isfinite(least) and (least > limits[1] or most < limits[0]):
            scale = look.scales.get(option, 1.0)
            raise RecordError(f"{given}: record '{record.path}' has nothing to draw there, only from {scale * least:.6g} to "
                              f"{scale * most:.6g}")
        if getattr(panel, f"get_{letter}scale")() == "log" and limits[0] <= 0:
            raise RecordError(f"{given}: the {name} is logarithmic, both must be above 0")
        getattr(panel, f"set_{letter}lim")(limits)


def require_kinds(look, names):
    """--x and --y, of section portraits alone, and --of and --over, of what a sweep found."""
    for option, value, kinds in (("of", look.of, ("means", "map")), ("over", look.over, ("means",))):
        other = next((name for name in names if name not in kinds), None)
        if value is not None and other:
            raise RecordError(f"{option} = {value}: a figure of kind {other} has nothing to choose there, one of kind "
                              f"{' or '.join(kinds)} has")
    if look.of is not None and look.of not in ("S", "exponent", "period", "RC"):
        raise RecordError(f"of = {look.of}: allowed are S, exponent, period, RC")
    if look.log not in (None, "x", "y", "xy"):
        raise RecordError(f"log = {look.log}: allowed are x, y, xy")
    for option, value in (("x", look.x), ("y", look.y)):
        other = next((name for name in names if name != "section"), None)
        if value is not None and other:
            raise RecordError(f"{option} = {value}: a figure of kind {other} has no coordinates to choose, one of kind "
                              "section has")
    x, y = look.coordinates
    if x == y and "section" in names:
        raise RecordError(f"x = {x} and y = {y}: a portrait shows two different coordinates, of one a diagonal")


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
