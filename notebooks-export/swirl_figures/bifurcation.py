"""Samples of attractors and branches of cycles across a parameter, with the points where branches change."""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D
from matplotlib.patheffects import Normal, Stroke

from .legends import LegendBelow
from .look import NARROW, is_narrow, widen
from .ranges import clipped, inside, require
from .record import RecordError
from .samples import Samples
from .special_points import draw_special
from .style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION
from .symbols import MEAN_SPIN, SPIN, axis_label, number, observable_label, scene_title

_PERIODS = (BLUE, VERMILION, GREEN, PURPLE, "#7A5C00", "#AA4499", SKY, "#882255", "#44AA99", "#332288", "#999933", ORANGE)


def _observable(record):
    """(name of the variable in `samples` and `branches`, axis label)."""
    name = str(record.attributes("settings").get("observable", "S"))
    return ("S", SPIN) if name == "S" else ("value", observable_label(name))


def _draw_contact(axes, record, look):
    """Orbits that end in contact have no impacts to show: their mean spin."""
    if "attractors" not in record or _observable(record)[0] != "S":
        return []
    parameter, mean = record.column("attractors", "parameter"), record.column("attractors", "mean_S")
    of = (record.column("attractors", "samples") == 0) & numpy.isfinite(mean) & inside(parameter, look.xlim)
    of &= numpy.isin(record.names("attractors", "outcome"), ["in-contact", "contact-cut-short"])
    if not of.any():
        return []
    style = {"ls": "", "marker": "_", "ms": 5, "mew": 1.2, "color": "#8A8A8A"}
    axes.plot(parameter[of], mean[of], zorder=1, **style)
    return [Line2D([], [], label="in contact: mean $S$", **style)]


def _means(record, look):
    """The rows of `shares` that have a mean of what spreads over many values, in lines: neighbouring columns that have one
    such row each, of the same kind, follow one another in a line."""
    parameter, mean, kind = record.column("shares", "parameter"), record.column("shares", "mean_S"), record.names("shares", "kind")
    rows = numpy.flatnonzero((record.column("shares", "period") == 0) & numpy.isfinite(mean) & inside(parameter, look.xlim))
    place = numpy.searchsorted(numpy.unique(record.column("columns", "parameter")), parameter[rows])
    single = numpy.bincount(place, minlength=1)[place] == 1
    joined = (numpy.diff(place) == 1) & single[1:] & single[:-1] & (kind[rows[1:]] == kind[rows[:-1]])
    return numpy.split(rows, 1 + numpy.flatnonzero(~joined)) if len(rows) else []


def _draw_means(axes, record, look):
    """The mean over the time of what spreads over many values, of each group of starts with one verdict: joined where
    neighbouring columns have one such group each, with its standard error where the record has that."""
    lines = _means(record, look) if "shares" in record and _observable(record)[0] == "S" else []
    if not lines:
        return []
    parameter, mean = record.column("shares", "parameter"), record.column("shares", "mean_S")
    style = {"color": BLACK, "lw": 1.3, "marker": "o", "ms": 2.2 if len(parameter) < 80 else 0, "zorder": 3}
    for rows in lines:
        alone = {"ms": 2.6, "mec": "white", "mew": 0.5} if len(rows) == 1 else {}
        axes.plot(parameter[rows], mean[rows], path_effects=[Stroke(linewidth=2.8, foreground="white"), Normal()], **(style | alone))
    bars = ""
    if record.has("shares", "mean_S_error"):
        rows, error = numpy.concatenate(lines), record.column("shares", "mean_S_error")
        rows = rows[numpy.isfinite(error[rows])]
        axes.errorbar(parameter[rows], mean[rows], yerr=error[rows], fmt="none", ecolor=BLACK, elinewidth=0.8, zorder=3)
        bars = ", bars: standard error"
    return [Line2D([], [], label=f"mean spin {MEAN_SPIN} by time{bars}", **style)]


def _pieces(stable):
    """(first, last + 1, stable) of the pieces of one branch on which stability does not change; neighbours share the
    point where it does."""
    borders = [0, *(1 + numpy.flatnonzero(stable[1:] != stable[:-1])), len(stable)]
    return [(first, min(last + 1, len(stable)), stable[first]) for first, last in zip(borders, borders[1:])]


#: Special points at which stability changes; a border may change it, too.
_CRITICAL = ("fold", "flip", "neimark-sacker", "branch-point")


def _column(record, group, name, rows):
    """A variable of one branch, a column for each phase of its cycles."""
    values = record.column(group, name)[rows]
    return values if values.ndim == 2 else values[:, None]


def _with_special(record, branch, name):
    """(parameter, values, stable) along one branch: its points, and between them the special points that were located, so
    that stability changes where it does and not at the next point."""
    of = record.column("branches", "branch") == branch
    parameter = record.column("branches", "parameter")[of]
    values, stable = _column(record, "branches", name, of), record.column("branches", "stable")[of] != 0
    if not record.has("special", "after"):
        return parameter, values, stable
    on_it = record.column("special", "branch") == branch
    if record.has("special", "located"):
        on_it &= record.column("special", "located") != 0
    after = record.column("special", "after")[on_it].astype(int)
    kinds, places = record.names("special", "kind")[on_it], record.column("special", "parameter")[on_it]
    special_stable = numpy.zeros(len(after), dtype=bool)
    for gap in numpy.unique(after):
        inside = numpy.flatnonzero(after == gap)
        critical = next((i for i in inside if kinds[i] in _CRITICAL), inside[0])
        special_stable[inside] = numpy.where(inside < critical, stable[gap], stable[min(gap + 1, len(stable) - 1)])
    return (numpy.insert(parameter, after + 1, places),
            numpy.insert(values, after + 1, _column(record, "special", name, on_it), axis=0),
            numpy.insert(stable, after + 1, special_stable))


def _lines(record, branch, name, look):
    """{stable: polylines} of a variable along one branch, as far as they lie in the range."""
    parameter, values, stable = _with_special(record, branch, name)
    lines = {True: [], False: []}
    for first, last, is_stable in _pieces(stable):
        for column in values.T:
            line = numpy.column_stack([parameter, column])[first:last]
            lines[bool(is_stable)] += [piece for piece in clipped(line, look.xlim) if numpy.isfinite(piece).all(axis=1).any()]
    return lines


def _draw_branches(axes, record, name, look):
    """(periods, stabilities) that there are in the range."""
    period, branches = record.column("branches", "period"), record.column("branches", "branch")
    colours, periods, stabilities = _colours(record), set(), set()
    for branch in numpy.unique(branches):
        own = period[branches == branch][0]
        for stable, lines in _lines(record, branch, name, look).items():
            if lines:
                axes.add_collection(LineCollection(lines, colors=colours[own], linewidths=1.5 if stable else 1.1, zorder=2,
                                                   linestyles="solid" if stable else (0, (3, 1.6))))
                periods.add(own)
                stabilities.add(stable)
    return periods, stabilities


def draw_branches_in(colour, axes, record, look):
    """S of a record's branches of whatever period, in one colour; handles of the legend."""
    kinds = set()
    for branch in numpy.unique(record.column("branches", "branch")) if _has_branches(record) else []:
        for stable, lines in _lines(record, branch, "S", look).items():
            if lines:
                axes.add_collection(LineCollection(lines, colors=colour, linewidths=1.5 if stable else 0.9, zorder=2,
                                                   linestyles="solid" if stable else (0, (3, 1.6))))
                kinds.add(stable)
    return [Line2D([], [], color=colour, lw=1.5 if stable else 0.9, ls="-" if stable else (0, (3, 1.6)),
                   label="stable cycles" if stable else "unstable cycles") for stable in (True, False) if stable in kinds]


def _branch_handles(record, periods, stabilities):
    handles = [Line2D([], [], color=colour, lw=1.5, label=f"period {period}")
               for period, colour in _colours(record).items() if period in periods]
    if True in stabilities:
        handles.append(Line2D([], [], color="0.35", lw=1.5, label="stable"))
    if False in stabilities:
        handles.append(Line2D([], [], color="0.35", lw=1.1, ls=(0, (3, 1.6)), label="unstable"))
    return handles


def _are_driven(record):
    """Which samples are of orbits that are accelerated, or on their way along a chord: where they are then only says how long
    was waited."""
    if not all(record.has(group, name) for group in ("samples", "attractors") for name in ("column", "start", "origin")):
        return numpy.zeros(len(record.column("samples", "parameter")), dtype=bool)
    starts = 1 + max(record.column(group, "start").max(initial=0) for group in ("samples", "attractors"))
    orbits, of = ((record.column(group, "column") * starts + record.column(group, "start")) * 3 + record.column(group, "origin")
                  for group in ("attractors", "samples"))
    driven = numpy.isin(record.names("attractors", "kind"), ["accelerated", "chord"])
    return numpy.isin(of, orbits[driven & ~numpy.isfinite(record.column("attractors", "mean_S"))])


def _shown_values(record, look):
    """(every ordinate of the upper panel, which of them are driven)"""
    name = _observable(record)[0]
    values, driven = [numpy.zeros(0)], [numpy.zeros(0, dtype=bool)]
    for group in (group for group in ("samples", "branches", "special") if group in record):
        seen = inside(record.column(group, "parameter"), look.xlim)
        values.append(record.column(group, name)[seen].ravel())
        driven.append(_are_driven(record)[seen] if group == "samples" else numpy.zeros(len(values[-1]), dtype=bool))
    values, driven = numpy.concatenate(values), numpy.concatenate(driven)
    finite = numpy.isfinite(values)
    return values[finite], driven[finite]


def _most_of(values):
    """(low, high) that leave out at most 3 % of either side."""
    low, high = numpy.quantile(values, [0.03, 0.97])
    margin = 0.15 * (high - low)
    return max(low - margin, values.min()), min(high + margin, values.max())


def _limit_ordinate(axes, record, look):
    """A few far values (S grows as 1/alpha), and orbits that are driven away, would flatten all others: limits that leave them
    out where that at least halves the axis, and say how many."""
    values, driven = _shown_values(record, look)
    of_others = values[~driven]
    if len(of_others) < 50:
        return
    low, high = _most_of(of_others)
    if high - low > 0.5 * numpy.ptp(of_others):
        low, high = of_others.min(), of_others.max()
    if high - low <= 0 or high - low > 0.5 * numpy.ptp(values):
        return
    outside = int(((values < low) | (values > high)).sum())
    axes.set_ylim(low - 0.03 * (high - low), high + 0.03 * (high - low))
    between = "\n" if is_narrow(axes.figure) else " "
    axes.annotate(f"{outside:,} of {len(values):,} points lie outside:{between}from {number(values.min())} to "
                  f"{number(values.max())}", (0.995, 0.012), xycoords="axes fraction", ha="right", fontsize="small",
                  color="0.25", bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1}, zorder=5)


def _draw_multiplier(axes, record, look):
    modulus = record.column("branches", "largest_multiplier")[inside(record.column("branches", "parameter"), look.xlim)]
    _draw_branches(axes, record, "largest_multiplier", look)
    axes.axhline(1, color="0.6", lw=0.8, zorder=0)
    axes.set_title("stable where $|\\lambda| < 1$", fontsize="small", color="0.35", loc="right", pad=2)
    finite = modulus[numpy.isfinite(modulus)]
    top = finite.max(initial=1.0)
    if top > 5:
        axes.set_yscale("symlog", linthresh=1, linscale=1)
        most = int(numpy.log10(top))
        axes.set_yticks([0, 1] + [10.0**k for k in range(1, most + 1)][::-(-most // 4) or 1])
        axes.yaxis.set_major_formatter(lambda value, _: f"{value:g}" if value <= 10 else f"$10^{{{round(numpy.log10(value))}}}$")
        axes.minorticks_off()
    axes.set(ylabel="largest multiplier $|\\lambda|$", ylim=(0, top * 1.15))


def is_diagram(record):
    return "windows" not in record and any(record.has(name, "parameter") for name in ("samples", "branches", "special", "attractors"))


def _has_branches(record):
    return "branches" in record and len(record.column("branches", "parameter")) > 0


def size(record, look):
    width = look.width or 8.5
    return width, (4.8 + 2.2 * _has_branches(record)) * (1 if width >= NARROW else 0.9)


def _colours(record):
    """{period: colour} of its branches."""
    periods = numpy.unique(record.column("branches", "period")) if _has_branches(record) else []
    return {period: _PERIODS[i % len(_PERIODS)] for i, period in enumerate(periods)}


def _panels(figure, record):
    count = 1 + _has_branches(record)
    return figure.subplots(count, 1, sharex=True, squeeze=False, height_ratios=(7, 2)[:count])[:, 0]


def _draw_above(axes, record, look):
    """The upper panel, but for the special points; handles of the legend."""
    name, label = _observable(record)
    samples = Samples(axes, record, look, name) if "samples" in record else None
    handles = (samples.handles() if samples else []) + _draw_contact(axes, record, look)
    if _has_branches(record):
        handles += _branch_handles(record, *_draw_branches(axes, record, name, look))
    require(handles, look, record, "point", _abscissae(record))
    axes.autoscale_view()
    axes.margins(x=0.02)
    if look.xlim:
        axes.set_xlim(look.xlim)
    _limit_ordinate(axes, record, look)
    widen(axes, abscissa=False)
    if samples:
        samples.draw()
    handles += _draw_means(axes, record, look)
    axes.set_ylabel(f"{label}, just after each impact")
    return handles


def _abscissae(record):
    return numpy.concatenate([record.column(name, "parameter") for name in ("samples", "branches", "special", "attractors")
                              if name in record])


def draw_into(figure, record, look):
    """S, or the record's observable, against the parameter; below it, where there are branches, their largest
    multiplier."""
    if len(_abscissae(record)) == 0:
        raise RecordError(f"record '{record.path}' holds no samples and no branches: there is nothing to draw")
    along = str(record.attributes("settings").get("along", "parameter"))
    look.title(figure, scene_title(record.scene(), leave_out=[along]))
    parts = LegendBelow(figure)
    panels = _panels(parts.above, record)
    handles = _draw_above(panels[0], record, look)
    if _has_branches(record):
        _draw_multiplier(panels[1], record, look)
    if "special" in record:
        handles += draw_special(panels[0], record, look, _observable(record)[0])
    parts.fill(handles, look)
    panels[-1].set_xlabel(axis_label(along))
    return [panels[0]]
