"""Fewer points that look the same: so that a figure of a million points is quick to draw and small as a file."""

import numpy

#: A line has so many columns, each with its least and greatest value: more than a page can show.
COLUMNS = 2_000


def thinned(x, y):
    """A line y(x), x rising, with the first, least, greatest and last value of each of COLUMNS pieces: drawn, it covers
    what the whole line covers."""
    x, y = numpy.asarray(x), numpy.asarray(y)
    if len(x) <= 4 * COLUMNS:
        return x, y
    length = len(x) // COLUMNS
    whole = length * COLUMNS
    pieces = numpy.where(numpy.isfinite(y[:whole]), y[:whole], 0).reshape(COLUMNS, length)
    first = numpy.arange(COLUMNS) * length
    chosen = numpy.concatenate([first, first + pieces.argmin(axis=1), first + pieces.argmax(axis=1), first + length - 1,
                                numpy.arange(whole, len(x))])
    chosen = numpy.unique(chosen)
    return x[chosen], y[chosen]


def apart(x, y, least_x, least_y):
    """Which points to draw of those that would lie on one another: in their order, each that is at least `least_x` or
    `least_y` away from every one drawn before it."""
    kept = numpy.zeros(len(x), dtype=bool)
    for i in range(len(x)):
        near = (abs(x[kept] - x[i]) < least_x) & (abs(y[kept] - y[i]) < least_y)
        kept[i] = not near.any()
    return kept


#: A picture of so many cells in each direction shows as much as dots do.
CELLS = 500

#: More points than these are drawn as cells: dots would take seconds, and cover one another.
DOTS = 100_000


def cells_of(x, y):
    """Which of CELLS × CELLS cells each point lies in, and (left, right, bottom, top) of them all. Points that are no
    numbers are in cell -1."""
    finite = numpy.isfinite(x) & numpy.isfinite(y)
    limits = [x[finite].min(), x[finite].max(), y[finite].min(), y[finite].max()]
    for i in (0, 2):
        if limits[i + 1] <= limits[i]:
            limits[i], limits[i + 1] = limits[i] - 0.5, limits[i + 1] + 0.5
    column = ((x - limits[0]) / (limits[1] - limits[0]) * CELLS * (1 - 1e-12))
    row = ((y - limits[2]) / (limits[3] - limits[2]) * CELLS * (1 - 1e-12))
    cell = numpy.where(finite, numpy.where(finite, row, 0).astype(int) * CELLS + numpy.where(finite, column, 0).astype(int),
                       -1)
    return cell, limits


def mean_in_cells(cell, values):
    """CELLS × CELLS means, NaN where there is no point."""
    inside = cell >= 0
    count = numpy.bincount(cell[inside], minlength=CELLS * CELLS)
    total = numpy.bincount(cell[inside], weights=values[inside], minlength=CELLS * CELLS)
    return numpy.where(count > 0, total / numpy.maximum(count, 1), numpy.nan).reshape(CELLS, CELLS)


def band_of(x, y):
    """(x, least, greatest) of y in each of COLUMNS pieces, x rising."""
    length = -(-len(x) // COLUMNS)
    first = numpy.arange(0, len(x), length)
    return x[first], numpy.fmin.reduceat(y, first), numpy.fmax.reduceat(y, first)
