"""Samples of attractors and branches of cycles across a parameter, with the points where branches change."""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .caption import listed
from .look import NARROW, LegendBelow, is_narrow, widen
from .record import RecordError
from .style import BLACK, BLUE, GREEN, MANY_POINTS, ORANGE, PURPLE, SKY, VERMILION
from .symbols import SPIN, axis_label, number, observable_label, scene_title
from .thinning import apart

#: By the record's `origin`: name, colour, size. Light, for the branches lie over them; of falling size, for attractors
#: that are found in several ways lie on one another.
_ORIGINS = {0: ("random starts", "#8A8A8A", 7), 1: ("followed up", SKY, 4), 2: ("followed down", ORANGE, 2)}

_PERIODS = (BLUE, VERMILION, GREEN, PURPLE, "#7A5C00", BLACK, SKY, "#882255", "#44AA99", "#332288", "#999933", ORANGE)

_MARKERS = {"fold": ">", "flip": "s", "neimark-sacker": "D", "branch-point": "*", "grazing": "^",
            "two-vertices": "v", "stick-slip": "P", "landing": "p", "border": "X"}


def _observable(record):
    """(name of the variable in `samples` and `branches`, axis label)."""
    name = str(record.attributes("settings").get("observable", "S"))
    return ("S", SPIN) if name == "S" else ("value", observable_label(name))


def _draw_samples(axes, record):
    parameter, spin = record.column("samples", "parameter"), record.column("samples", _observable(record)[0])
    origin = record.column("samples", "origin")
    handles = []
    scale = 0.5 if len(spin) > 5_000 else 1
    only_one = len(numpy.unique(origin)) == 1
    for value, (label, colour, size) in _ORIGINS.items():
        of = origin == value
        if of.any():
            axes.scatter(parameter[of], spin[of], s=scale * (2 if only_one else size), color=colour, lw=0, zorder=1,
                         rasterized=len(spin) > MANY_POINTS)
            handles.append(Line2D([], [], ls="", marker="o", ms=3, mec="none", color=colour, label=label))
    return handles


def _draw_contact(axes, record):
    """Orbits that end in contact have no impacts to show: their mean spin."""
    if "attractors" not in record or _observable(record)[0] != "S":
        return []
    without = record.column("attractors", "samples") == 0
    mean = record.column("attractors", "mean_S")
    of = without & numpy.isin(record.names("attractors", "outcome"), ["in-contact", "contact-cut-short"]) & numpy.isfinite(mean)
    if not of.any():
        return []
    style = {"ls": "", "marker": "_", "ms": 5, "mew": 1.2, "color": "#8A8A8A"}
    axes.plot(record.column("attractors", "parameter")[of], mean[of], zorder=1, **style)
    return [Line2D([], [], label="in contact: mean $S$", **style)]


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


def _lines(record, branch, name):
    """{stable: polylines} of a variable along one branch."""
    parameter, values, stable = _with_special(record, branch, name)
    lines = {True: [], False: []}
    for first, last, is_stable in _pieces(stable):
        for column in values.T:
            line = numpy.column_stack([parameter, column])[first:last]
            if numpy.isfinite(line).all(axis=1).any():
                lines[bool(is_stable)].append(line)
    return lines


def _draw_branches(axes, record, name, colours):
    period, branches = record.column("branches", "period"), record.column("branches", "branch")
    for branch in numpy.unique(branches):
        colour = colours[period[branches == branch][0]]
        for stable, lines in _lines(record, branch, name).items():
            axes.add_collection(LineCollection(lines, colors=colour, linewidths=1.5 if stable else 1.1, zorder=2,
                                               linestyles="solid" if stable else (0, (3, 1.6))))


def _branch_handles(record, colours):
    stable = record.column("branches", "stable") != 0
    handles = [Line2D([], [], color=colour, lw=1.5, label=f"period {period}") for period, colour in colours.items()]
    if stable.any():
        handles.append(Line2D([], [], color="0.35", lw=1.5, label="stable"))
    if not stable.all():
        handles.append(Line2D([], [], color="0.35", lw=1.1, ls=(0, (3, 1.6)), label="unstable"))
    return handles


#: Size, in points, of a special point's marker. Of one kind those that lie within a marker of one already drawn, in both
#: directions, are left out, and the legend says how many: crowded, they would hide the branches that they are on.
_MARKER = 5.5


def _size_of_a_marker(axes, points):
    """(along the abscissa, along the ordinate) in the axes' numbers; the panel takes some 0.85 of the width and 0.55 of the
    height of its figure."""
    figure = axes.figure
    size = (0.85 * figure.bbox.width, 0.55 * figure.bbox.height)
    return [points / 72 * figure.figure.dpi / length * abs(end - begin)
            for length, (begin, end) in zip(size, (axes.get_xlim(), axes.get_ylim()))]


def _draw_special(axes, record, look):
    parameter, spin = record.column("special", "parameter"), record.column("special", _observable(record)[0])
    kinds = record.names("special", "kind")
    if record.has("special", "located"):
        located = record.column("special", "located") != 0
        kinds = numpy.where(located, kinds, [f"{kind}, not located" for kind in kinds])
    handles = []
    scale = (1 if numpy.isfinite(spin).sum() <= 60 else 0.75) * (0.8 if is_narrow(axes.figure) else 1)
    near = _size_of_a_marker(axes, scale * _MARKER)
    limits = axes.axis()
    drawn = numpy.zeros(len(kinds), dtype=bool)
    for kind in dict.fromkeys(kinds):
        of = kinds == kind
        plain = kind.split(",")[0]
        marker = {"marker": _MARKERS.get(plain, "o"), "mec": BLACK if kind == plain else "0.6", "mfc": "white",
                  "mew": 0.9 * scale, "ms": scale * (9 if plain == "branch-point" else _MARKER)}
        x, y = numpy.repeat(parameter[of], spin.shape[1]), spin[of].ravel()
        shown = numpy.flatnonzero(numpy.isfinite(y))
        kept = shown[apart(x[shown], y[shown], *near)]
        drawn[numpy.flatnonzero(of)[kept // spin.shape[1]]] = True
        axes.plot(x[kept], y[kept], ls="", zorder=4, **marker)
        count = f" ({len(kept)} of {len(shown)} drawn)" if len(kept) < len(shown) else ""
        handles.append(Line2D([], [], ls="", label=kind + count, **{**marker, "ms": marker["ms"] / scale}))
    axes.axis(limits)
    look.notes.append(_listed_special(record, kinds, drawn))
    return handles


def _listed_special(record, kinds, drawn):
    """All special points by rising parameter, for a caption: their values at the first phase of each cycle."""
    name, _ = _observable(record)
    along = str(record.attributes("settings").get("along", "parameter"))
    parameter, values = record.column("special", "parameter"), record.column("special", name)
    first = values if values.ndim == 1 else values[:, 0]
    rows = [(kinds[i], f"{parameter[i]:.10g}", f"{first[i]:.6g}", "" if drawn[i] else "left out where it would hide others")
            for i in numpy.argsort(parameter, kind="stable")]
    return listed(f"Special points, {len(rows)}, of which {int(drawn.sum())} are drawn:",
                  ("kind", along, str(record.attributes("settings").get("observable", "S")), ""), rows)


def _shown_values(record):
    """Every ordinate of the upper panel."""
    name = _observable(record)[0]
    values = [record.column(group, name).ravel() for group in ("samples", "branches", "special") if group in record]
    values = numpy.concatenate(values) if values else numpy.zeros(0)
    return values[numpy.isfinite(values)]


def _limit_ordinate(axes, record):
    """A few far values (S grows as 1/alpha) would flatten all others: limits that leave out at most 3 % of either side
    where that at least halves the axis, and say how many."""
    values = _shown_values(record)
    if len(values) < 50:
        return
    low, high = numpy.quantile(values, [0.03, 0.97])
    margin = 0.15 * (high - low)
    low, high = max(low - margin, values.min()), min(high + margin, values.max())
    if high - low <= 0 or high - low > 0.5 * (values.max() - values.min()):
        return
    outside = int(((values < low) | (values > high)).sum())
    axes.set_ylim(low - 0.03 * (high - low), high + 0.03 * (high - low))
    between = "\n" if is_narrow(axes.figure) else " "
    axes.annotate(f"{outside:,} of {len(values):,} points lie outside:{between}from {number(values.min())} to "
                  f"{number(values.max())}", (0.995, 0.012), xycoords="axes fraction", ha="right", fontsize="small",
                  color="0.25", bbox={"fc": "white", "ec": "none", "alpha": 0.8, "pad": 1}, zorder=5)


def _draw_multiplier(axes, record, colours):
    modulus = record.column("branches", "largest_multiplier")
    _draw_branches(axes, record, "largest_multiplier", colours)
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
    axes.set(ylabel="largest $|\\lambda|$", ylim=(0, top * 1.15))


def is_diagram(record):
    return any(record.has(name, "parameter") for name in ("samples", "branches", "special", "attractors"))


def _has_branches(record):
    return "branches" in record and len(record.column("branches", "parameter")) > 0


def size(record, width):
    width = width or 8.5
    return width, (4.8 + 2.2 * _has_branches(record)) * (1 if width >= NARROW else 0.9)


def _curves(record):
    """{period: colour} of its branches."""
    periods = numpy.unique(record.column("branches", "period")) if _has_branches(record) else []
    return {period: _PERIODS[i % len(_PERIODS)] for i, period in enumerate(periods)}


def _panels(figure, record):
    count = 1 + _has_branches(record)
    return figure.subplots(count, 1, sharex=True, squeeze=False, height_ratios=(7, 2)[:count])[:, 0]


def _draw_above(axes, record, look):
    """The upper panel, but for the special points; handles of the legend."""
    name, label = _observable(record)
    handles = (_draw_samples(axes, record) if "samples" in record else []) + _draw_contact(axes, record)
    if _has_branches(record):
        colours = _curves(record)
        _draw_branches(axes, record, name, colours)
        handles += _branch_handles(record, colours)
    axes.autoscale_view()
    axes.margins(x=0.02)
    if look.xlim:
        axes.set_xlim(look.xlim)
    _limit_ordinate(axes, record)
    widen(axes, abscissa=False)
    axes.set_ylabel(f"{label}, just after each impact")
    return handles


def draw_into(figure, record, look):
    """S, or the record's observable, against the parameter; below it, where there are branches, their largest
    multiplier."""
    drawn = [name for name in ("samples", "branches", "special", "attractors") if name in record]
    if not any(len(record.column(name, "parameter")) for name in drawn):
        raise RecordError(f"record '{record.path}' holds no samples and no branches: there is nothing to draw")
    along = str(record.attributes("settings").get("along", "parameter"))
    look.title(figure, scene_title(record.scene(), leave_out=[along]))
    parts = LegendBelow(figure)
    panels = _panels(parts.above, record)
    handles = _draw_above(panels[0], record, look)
    if _has_branches(record):
        _draw_multiplier(panels[1], record, _curves(record))
    if "special" in record:
        handles += _draw_special(panels[0], record, look)
    parts.fill(handles, look)
    panels[-1].set_xlabel(axis_label(along))
    return [panels[0]]
