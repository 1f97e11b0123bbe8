"""The points of a diagram where branches of cycles change: drawn where they do not hide one another, listed all."""

import numpy
from matplotlib.lines import Line2D

from .caption import listed
from .look import is_narrow
from .ranges import inside
from .style import BLACK
from .symbols import kind_label
from .thinning import apart

_MARKERS = {"fold": ">", "flip": "s", "neimark-sacker": "D", "branch-point": "*", "grazing": "^",
            "two-vertices": "v", "stick-slip": "P", "landing": "p", "border": "X"}

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


def _kinds(record):
    """The names of their kinds, in which it is told where one was not located."""
    kinds = record.names("special", "kind")
    if not record.has("special", "located"):
        return kinds
    located = record.column("special", "located") != 0
    return numpy.where(located, kinds, [f"{kind}, not located" for kind in kinds])


def draw_special(axes, record, look, variable):
    """Handles of the legend. A cycle's special point has a marker at each phase; it is one point, and counts as drawn if any
    of these is."""
    seen = inside(record.column("special", "parameter"), look.xlim)
    parameter, values = record.column("special", "parameter")[seen], record.column("special", variable)[seen]
    kinds = _kinds(record)[seen]
    handles = []
    scale = (1 if numpy.isfinite(values).sum() <= 60 else 0.75) * (0.8 if is_narrow(axes.figure) else 1)
    near = _size_of_a_marker(axes, scale * _MARKER)
    limits = axes.axis()
    drawn = numpy.zeros(len(kinds), dtype=bool)
    for kind in dict.fromkeys(kinds):
        of = kinds == kind
        plain = kind.split(",")[0]
        marker = {"marker": _MARKERS.get(plain, "o"), "mec": BLACK if kind == plain else "0.6", "mfc": "white",
                  "mew": 0.9 * scale, "ms": scale * (9 if plain == "branch-point" else _MARKER)}
        x, y = numpy.repeat(parameter[of], values.shape[1]), values[of].ravel()
        finite = numpy.flatnonzero(numpy.isfinite(y))
        kept = finite[apart(x[finite], y[finite], *near)]
        drawn[numpy.flatnonzero(of)[kept // values.shape[1]]] = True
        axes.plot(x[kept], y[kept], ls="", zorder=4, **marker)
        count = f" ({drawn[of].sum():,} of {of.sum():,} drawn)" if not drawn[of].all() else ""
        handles.append(Line2D([], [], ls="", label=kind_label(kind) + count, **{**marker, "ms": marker["ms"] / scale}))
    axes.axis(limits)
    look.notes.append(_listed(record, look, kinds, parameter, values[:, 0], drawn))
    return handles


def _listed(record, look, kinds, parameter, values, drawn):
    """Those in the range by rising parameter, for a caption: their values at the first phase of each cycle."""
    settings = record.attributes("settings")
    along, observable = str(settings.get("along", "parameter")), str(settings.get("observable", "S"))
    rows = [(kind_label(kinds[i]), f"{parameter[i]:.10g}", f"{values[i]:.6g}", "" if drawn[i] else "left out where it would hide others")
            for i in numpy.argsort(parameter, kind="stable")]
    where = f" with {along} from {look.xlim[0]:g} to {look.xlim[1]:g}" if look.xlim else ""
    return listed(f"Special points{where}, {len(rows)}, of which {int(drawn.sum())} are drawn:", ("kind", along, observable, ""),
                  rows)
