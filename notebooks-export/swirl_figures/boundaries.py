"""Curves on which cycles bifurcate, in the plane of two parameters: alone, or over the mode map of a sweep."""

import numpy
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from .caption import listed
from .legends import LegendBelow
from .mode_map import draw_cells, mode_handles, mode_style, sweep_title
from .ranges import inside, overlapping
from .record import RecordError
from .style import BLACK, GREEN, GREY, PURPLE
from .sweep_grid import SweepGrid
from .symbols import axis_label, kind_label, scene_title
from .thinning import apart

#: Colours of the kinds of curves, none of them a mode's; a white edge tells them from the map beneath.
_COLOURS = {"fold": BLACK, "flip": "#882255", "neimark-sacker": GREEN, "grazing": "#332288", "two-vertices": "#7A5C00",
            "stick-slip": PURPLE}

#: What points of codimension 2 are called beside their marks; the legend says what that is.
_SHORT = {"cusp": "CP", "generalised-flip": "GPD", "chenciner": "CH", "1:1": "R1", "1:2": "R2", "1:3": "R3", "1:4": "R4",
          "fold-flip": "LPPD", "fold-neimark-sacker": "LPNS", "flip-neimark-sacker": "PDNS",
          "double-neimark-sacker": "NSNS", "fold-grazing": "LPG", "flip-grazing": "PDG", "neimark-sacker-grazing": "NSG",
          "fold-vanishing-impact": "LPV", "flip-vanishing-impact": "PDV",
          "fold-two-vertices": "LP2", "flip-two-vertices": "PD2", "neimark-sacker-two-vertices": "NS2",
          "fold-stick-slip": "LPS", "flip-stick-slip": "PDS", "neimark-sacker-stick-slip": "NSS"}

#: A multiplier this far beyond the unit circle makes the cycle unstable on both sides of the curve.
_OUTSIDE = 1e-6


class Curves:
    """The curves of a record, each with the parameters of its points, its kind and its period."""

    def __init__(self, record):
        settings = record.attributes("settings")
        self.axes = [str(settings[name]).replace("-", "_") for name in ("first", "second")]
        self.limits = {axis: (float(settings[f"{name}_low"]), float(settings[f"{name}_high"]))
                       for axis, name in zip(self.axes, ("first", "second"))}
        self.scene = record.scene()
        self.number = record.column("curves", "curve")
        self.places = self._places(record, "curves")
        self.unstable = record.column("curves", "largest_multiplier") > 1 + _OUTSIDE
        self.kinds = record.names("curve_ends", "kind")
        self.periods = record.column("curve_ends", "period")
        self.special, self.special_kinds = {axis: [] for axis in self.axes}, []
        if "special" in record:
            self.special, self.special_kinds = self._places(record, "special"), record.names("special", "kind")

    def _places(self, record, group):
        return {axis: record.column(group, name) for axis, name in zip(self.axes, ("first", "second"))}


def is_of_curves(record):
    return "curve_ends" in record


def _colour(kind):
    return _COLOURS.get(kind, GREY)


#: Lines of periods 1, 2, …; longer ones are dotted.
_STYLES = ("-", "--", "-.")


def _draw_curves(axes, curves, x, y):
    """Where the cycle is unstable on both sides the line is thin."""
    for number, (kind, period) in enumerate(zip(curves.kinds, curves.periods)):
        of_curve = curves.number == number
        style = _STYLES[period - 1] if period <= len(_STYLES) else ":"
        for thin in (False, True):
            shown = of_curve & (curves.unstable == thin)
            places = [numpy.where(shown, curves.places[axis], numpy.nan)[of_curve] for axis in (x, y)]
            width = 0.7 if thin else 1.6
            edge = [Stroke(linewidth=width + 1.2, foreground="white"), Normal()]
            axes.plot(*places, color=_colour(kind), ls=style, lw=width, zorder=2 if thin else 3, path_effects=edge)


def _special_points(curves, x, y, xlim):
    """(kind, x, y) of each special point in the range, one on two curves once; in the order of `_SHORT`, rarer kinds of a
    smooth map first."""
    seen = inside(numpy.asarray(curves.special[x]), xlim)
    points = dict.fromkeys((kind, round(float(a), 6), round(float(b), 6))
                           for kind, a, b, shown in zip(curves.special_kinds, curves.special[x], curves.special[y], seen)
                           if shown)
    order = list(_SHORT)
    return sorted(points, key=lambda point: order.index(point[0]) if point[0] in order else len(order))


#: Width and height of a name beside its mark, in the axes' widths: a name that would lie on another is left out, and
#: the legend says how many of a kind are named.
_NAME = 0.045, 0.022


def _named(curves, x, y, xlim=None):
    """The special points, and which of them are named."""
    points = _special_points(curves, x, y, xlim)
    low, high = numpy.array([xlim or curves.limits[x], curves.limits[y]]).T
    places = (numpy.array([point[1:] for point in points]).reshape(-1, 2) - low) / (high - low)
    return points, apart(places[:, 0], places[:, 1], *_NAME)


def _draw_special(axes, curves, x, y, look):
    """All have a mark, small ones where they are not named; a caption lists them."""
    points, are_named = _named(curves, x, y, look.xlim)
    look.notes.append(listed(f"Special points, {len(points)}:", ("kind", x, y, ""),
                             [(kind_label(kind), f"{a:.10g}", f"{b:.10g}", "" if named else "marked, not named")
                              for (kind, a, b), named in sorted(zip(points, are_named), key=lambda point: point[0][:2])]))
    for (kind, a, b), named in zip(points, are_named):
        axes.plot(a, b, "o", ms=3.5 if named else 2, mfc="white", mec=BLACK, mew=0.8 if named else 0.5, zorder=4)
        if named:
            axes.annotate(_SHORT.get(kind, kind), (a, b), xytext=(3, 2), textcoords="offset points", size="xx-small",
                          zorder=5, path_effects=[Stroke(linewidth=1.5, foreground="white"), Normal()], clip_on=True)


def _seen(curves, x, xlim):
    """Which points of curves are in the range, or lead into it."""
    place, same = curves.places[x], curves.number[1:] == curves.number[:-1]
    joined = same & overlapping(numpy.minimum(place[1:], place[:-1]), numpy.maximum(place[1:], place[:-1]), xlim)
    return inside(place, xlim) | numpy.append(joined, False) | numpy.append(False, joined)


#: Of a figure's height, that the legend may take.
_MOST_OF_HEIGHT = 1 / 3


def _fill(parts, handles, look):
    """A handle for each kind of special points where a third of the figure has room for it; else a paragraph of their names,
    and where that is too long, too, of their letters: the caption names them all."""
    lines = [handle for handle in handles if not handle.get_label().startswith(tuple(f"{name}: " for name in _SHORT.values()))]
    special = [handle.get_label() for handle in handles if handle not in lines]
    words = ", ".join(label.replace(": ", "\u00a0", 1) for label in special)
    letters = ", ".join(label.split(":", 1)[0] for label in special) + ": special points, named in the caption"
    for shown, text in ((handles, ""), (lines, words), (lines, letters)):
        if not special or parts.share(shown, look, text) <= _MOST_OF_HEIGHT:
            break
    parts.fill(shown, look, text)
    if text == letters:
        look.notes.append(f"Letters beside special points: {words.replace(chr(0xa0), ' ')}.")


def _handles(curves, x, y, look):
    seen = _seen(curves, x, look.xlim)
    own, periods = (set(values[numpy.unique(curves.number[seen])]) for values in (curves.kinds, curves.periods))
    kinds = [kind for kind in _COLOURS if kind in own] + sorted(own - set(_COLOURS))
    handles = [Line2D([], [], color=_colour(kind), lw=1.6, label=kind_label(kind)) for kind in kinds]
    for period in sorted(periods):
        style = _STYLES[period - 1] if period <= len(_STYLES) else ":"
        handles.append(Line2D([], [], color="0.3", lw=1.2, ls=style, label=f"period {period}"))
    if curves.unstable[seen].any():
        handles.append(Line2D([], [], color="0.3", lw=0.6, label="thin: unstable on both sides"))
    points, named = _named(curves, x, y, look.xlim)
    for kind in [kind for kind in _SHORT if kind in {point[0] for point in points}]:
        of_kind = [is_named for point, is_named in zip(points, named) if point[0] == kind]
        count = "" if all(of_kind) else f" ({sum(of_kind)} of {len(of_kind)} named)"
        handles.append(Line2D([], [], ls="", marker="o", ms=3.5, mfc="white", mec=BLACK, mew=0.8,
                              label=f"{_SHORT[kind]}: {kind_label(kind)}{count}"))
    return handles


def size(_record, look):
    width = look.width or 7.0
    return width, 0.85 * width


def draw_into(figure, record, look):
    curves = record.derived(Curves)
    x, y = curves.axes
    look.title(figure, scene_title(curves.scene, leave_out=curves.axes))
    parts = LegendBelow(figure)
    _fill(parts, _handles(curves, x, y, look), look)
    axes = parts.above.subplots()
    _draw_curves(axes, curves, x, y)
    _draw_special(axes, curves, x, y, look)
    axes.set(xlim=curves.limits[x], ylim=curves.limits[y], xlabel=axis_label(x), ylabel=axis_label(y))
    return [axes]


def _require_same_plane(grid, record, curves):
    """Curves of another plane or scene over a map would be a lie."""
    names = [axis.replace("-", "_") for axis in grid.axes]
    if sorted(names) != sorted(curves.axes):
        raise RecordError(f"the curves of '{record.path}' are in ({', '.join(curves.axes)}), the map in "
                          f"({', '.join(names)})")
    for name, value in curves.scene.items():
        if name in grid.scene and name not in curves.axes and str(grid.scene[name]) not in (str(value), "uniform"):
            raise RecordError(f"the curves of '{record.path}' have {name} = {value}, the map {grid.scene[name]}")


def draw_over_map(figure, records, look):
    """The mode map of the first record with the curves of the others over it."""
    grid = records[0].derived(SweepGrid)
    if len(grid.axes) != 2:
        raise RecordError(f"curves are drawn over a map of two parameters; '{records[0].path}' has {len(grid.axes)}")
    all_curves = [record.derived(Curves) for record in records[1:]]
    look.title(figure, sweep_title(grid))
    x, y = (axis.replace("-", "_") for axis in grid.axes)
    handles = {}
    for record, curves in zip(records[1:], all_curves):
        _require_same_plane(grid, record, curves)
        handles.update((handle.get_label(), handle) for handle in _handles(curves, x, y, look))
    parts = LegendBelow(figure)
    _fill(parts, mode_handles(grid) + list(handles.values()), look)
    axes = parts.above.subplots()
    draw_cells(axes, grid, grid.largest_mode, **mode_style(grid.modes))
    limits = axes.get_xlim(), axes.get_ylim()
    for curves in all_curves:
        _draw_curves(axes, curves, x, y)
        _draw_special(axes, curves, x, y, look)
    axes.set(xlim=limits[0], ylim=limits[1])
    return [axes]
