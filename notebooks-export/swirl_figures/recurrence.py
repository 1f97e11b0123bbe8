"""Recurrence quantification: the recurrence plot, the measures beside it, and the lines that they are made of."""

import numpy
from matplotlib import rcParams
from matplotlib.ticker import LogLocator, MaxNLocator, NullFormatter, StrMethodFormatter

from .look import NARROW, is_narrow, width_of
from .style import BLUE, CYCLE, VERMILION
from .symbols import number, scene_title

_MEASURES = ("RR", "RC", "DET", "L", "Lmax", "DIV", "ENTR", "LAM", "TT", "Vmax", "VENTR", "MRT", "RTE", "TREND")

_NAMES = {"RR": "recurrence rate", "RC": "the same, diagonal counted", "DET": "determinism", "L": "mean diagonal line",
          "Lmax": "longest diagonal line", "DIV": "divergence, 1/Lmax", "ENTR": "entropy of diagonal lines",
          "LAM": "laminarity", "TT": "trapping time", "Vmax": "longest vertical line",
          "VENTR": "entropy of vertical lines", "MRT": "mean recurrence time", "RTE": "entropy of recurrence times",
          "TREND": "trend per 1,000 points"}

#: Densities are drawn on a square root: a thin line of recurrences in a large cell still shows.
_GAMMA = 0.5
#: The darkest shade is half as much again as that of this share of the cells: the main diagonal alone would set it far
#: above all others.
_DARKEST = 0.99


def _has_image(record):
    return record.has("recurrence", "image")


def _several(record):
    return len(record.column("recurrence", "RR")) > 1


#: Small letters that the table of measures is wide: their names, what they mean, their values.
_NAME, _TABLE = 4, 27

#: Inches of width in which the table stands beside the other panels; in less, below them.
_BESIDE = 6.2


def size(record, look):
    width = look.width or (8.6 if _has_image(record) else 7.5)
    if not _has_image(record):
        return width, 3.6 if width >= (NARROW if _several(record) else _BESIDE) else 5.6
    return (width, 0.62 * width + 0.3) if width >= _BESIDE else (width, 1.02 * width + 4.2)


def _small():
    return 8 / 9 * rcParams["font.size"]


def _draw_image(axes, record):
    image = record.column("recurrence", "image")
    points = int(record.attributes("settings").get("points", len(image)))
    shade = image ** _GAMMA
    cross = bool(record.attributes("settings").get("cross", 0))
    darkest = max(min(1.5 * numpy.quantile(shade, _DARKEST), shade.max()), 1e-9)
    axes.imshow(shade, origin="lower", cmap="Greys", vmin=0, vmax=darkest, interpolation="nearest",
                extent=(0, points, 0, 1 if cross else points), aspect="auto" if cross else "equal")
    for axis in (axes.xaxis, axes.yaxis):
        axis.set_major_locator(MaxNLocator(4, steps=(1, 2, 5, 10)))
    for spine in axes.spines.values():
        spine.set_visible(True)
    counted = "impact" if "orbit" in record else "sample"
    axes.set(xlabel=f"{counted} $i$", ylabel="place in the other series" if cross else f"{counted} $j$",
             title="Recurrences (darker: more in a cell)")


def _value(record, name):
    value = float(record.column("recurrence", name)[0])
    return "none" if not numpy.isfinite(value) else number(value)


def _write_measures(axes, record):
    """A table: in place of axes, since the measures have no common scale."""
    axes.axis("off")
    threshold = float(record.column("recurrence", "threshold")[0])
    rows = [("δ", "threshold", number(threshold))]
    rows += [(name, _NAMES[name], _value(record, name)) for name in _MEASURES if record.has("recurrence", name)]
    for index, (name, meaning, value) in enumerate(rows):
        height = 1 - (index + 0.5) / len(rows)
        axes.text(0, height, name, va="center", fontsize="small", weight="bold", transform=axes.transAxes)
        axes.annotate(meaning, (0, height), xycoords="axes fraction", xytext=(_NAME * _small(), 0), textcoords="offset points",
                      va="center", fontsize="small", color="0.3")
        axes.text(1, height, value, va="center", ha="right", fontsize="small", transform=axes.transAxes)


def _draw_lengths(axes, record):
    """How many lines of each length there are: straight on these axes where they are those of chance."""
    longest = 1
    for name, dimension, colour, label, size in (("diagonal_lines", "diagonal_length", BLUE, "diagonal", 3.6),
                                                 ("vertical_lines", "vertical_length", VERMILION, "vertical", 1.8)):
        if not record.has("recurrence", name):
            continue
        count = record.column("recurrence", name)[0]
        length = 1 + numpy.arange(len(count))
        if record.has("recurrence", dimension):
            length = record.column("recurrence", dimension)
        shown = count > 0
        longest = max(longest, length[shown].max(initial=1))
        axes.loglog(length[shown], count[shown], "o-", ms=size, mec="none", lw=0.8, color=colour, label=f"{label} lines")
    axes.set_xlim(0.9, 1.1 * longest)
    axes.xaxis.set_major_formatter(StrMethodFormatter("{x:,.0f}"))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_locator(LogLocator(10, subs=(1, 2, 5) if longest < 100 else (1,)))
    axes.set(xlabel="length of a line", ylabel="number of lines", title="Lines by their length")
    axes.legend(loc="upper right")


def _draw_over_thresholds(shares, lengths, record):
    threshold = record.column("recurrence", "threshold")
    for axes, names in ((shares, ("RR", "DET", "LAM")), (lengths, ("L", "TT", "ENTR"))):
        for name, colour, marker in zip(names, CYCLE, "os^"):
            axes.plot(threshold, record.column("recurrence", name), marker=marker, ms=3.5, lw=1, color=colour,
                      label=f"{name}: {_NAMES[name]}")
        axes.xaxis.set_major_locator(MaxNLocator(5))
        axes.set_xlabel("threshold $\\delta$")
        axes.legend(loc="best")
    shares.set(ylim=(0, 1.03), title="Shares of the pairs and of the points")
    lengths.set(title="Mean lengths, and entropy")


def _settings(record):
    settings = record.attributes("settings")
    quantity = settings.get("observable", "the series")
    parts = [f"{int(settings['points']):,} points of {quantity}"] if "points" in settings else []
    if int(settings.get("dimension", 1)) > 1:
        parts.append(f"embedded in {int(settings['dimension'])} dimensions, delay {int(settings['delay'])}")
    parts += [f"{settings[name]} {word}" for name, word in (("norm", "norm"), ("convention", "conventions"))
              if name in settings]
    return ", ".join(parts)


def draw_into(figure, record, look):
    look.title(figure, "\n".join(filter(None, (scene_title(record.scene()), _settings(record)))))
    if _several(record):
        panels = figure.subplots(*((2, 1) if is_narrow(figure) else (1, 2)))
        _draw_over_thresholds(*panels, record)
        return list(panels)
    if not record.has("recurrence", "diagonal_lines"):  # an estimate from random pairs
        _write_measures(figure.subplots(), record)
        return []
    width, table = width_of(figure), _TABLE * _small() / 72
    below = width < _BESIDE
    shape, ratios = (2, 1) if below else (1, 2), {} if below else {"width_ratios": (width - table, table)}
    if not _has_image(record):
        lengths, table = figure.subplots(*shape, **ratios)
        _draw_lengths(lengths, record)
        _write_measures(table, record)
        return [lengths]
    left, right = figure.subfigures(*shape, **({"height_ratios": (5, 6)} if below else ratios))
    _draw_image(left.subplots(), record)
    table, lengths = right.subplots(2, 1, height_ratios=(3, 2))
    _write_measures(table, record)
    _draw_lengths(lengths, record)
    return []
