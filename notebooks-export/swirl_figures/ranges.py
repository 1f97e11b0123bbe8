"""The range of the abscissa that --xlim asks for. What lies in it is chosen before it is thinned, counted or named: what is
drawn is then as fine as the range allows, and the ordinates and the legend are those of what is seen."""

import numpy

from .record import RecordError


def range_words(look, of="xlim"):
    """--xlim, or --ylim, as it was given."""
    digits = ".12g" if of in look.scales else ".15g"  # of what was converted, without the conversion's rounding
    return ":".join(f"{look.scales.get(of, 1.0) * end:{digits}}" for end in getattr(look, of))


def inside(x, xlim):
    """Which values lie in the range; all of no range."""
    return numpy.ones(len(x), dtype=bool) if xlim is None else (x >= xlim[0]) & (x <= xlim[1])


def part(x, xlim):
    """Of rising x those in the range, and one more on either side, to which a line leads: a slice."""
    if xlim is None:
        return slice(None)
    return slice(max(numpy.searchsorted(x, xlim[0]) - 1, 0), numpy.searchsorted(x, xlim[1], side="right") + 1)


def overlapping(begin, end, xlim):
    """Which pieces from `begin` to `end` lie in the range, wholly or in part."""
    return numpy.ones(len(begin), dtype=bool) if xlim is None else (end >= xlim[0]) & (begin <= xlim[1])


def _cut(line, border, below):
    """The pieces of a polyline on one side of a border, each to where it meets that."""
    kept = line[:, 0] <= border if below else line[:, 0] >= border
    pieces, piece = [], []
    for i, point in enumerate(line):
        if i > 0 and kept[i] != kept[i - 1]:
            before = line[i - 1]
            piece.append(before + (border - before[0]) / (point[0] - before[0]) * (point - before))
        if kept[i]:
            piece.append(point)
        elif piece:
            pieces.append(numpy.array(piece))
            piece = []
    return pieces + [numpy.array(piece)] * bool(piece)


def clipped(line, xlim):
    """The pieces of a polyline (rows of x, y) that lie in the range, x going to and fro as it likes."""
    if xlim is None:
        return [line]
    return [piece for part_below in _cut(line, xlim[1], True) for piece in _cut(part_below, xlim[0], False)]


def require(found, look, record, what, times=None):
    """RecordError where the range holds none of what the figure shows; `times` are those at which there is some."""
    if look.xlim is None or found:
        return
    scale = look.scales.get("xlim", 1.0)
    where = (f"; there are some from {scale * numpy.min(times):.6g} to {scale * numpy.max(times):.6g}"
             if times is not None and len(times) else "")
    raise RecordError(f"xlim = {range_words(look)}: record '{record.path}' has no {what} there{where}")
