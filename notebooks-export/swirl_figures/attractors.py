"""A sweep over one parameter whose attractors were followed from cell to cell: the share of the starts that each has, and
its mean S, as curves. A dot is a cell; a line joins cells side by side that have the same attractor."""

import numpy
from matplotlib.lines import Line2D

from .caption import listed
from .legends import LegendBelow
from .mode_map import sweep_title
from .record import RecordError
from .style import CYCLE, GREY
from .sweep_grid import SweepGrid
from .sweep_points import is_sampled
from .symbols import MEAN_SPIN, axis_label, number

#: Attractors over more cells than the others have a colour and a line of the legend.
_MOST_NAMED = len(CYCLE) - 1


def has_tracks(record):
    """Followed over one parameter."""
    return record.has("attractors", "track") and "sweep" in record and not is_sampled(record) and len(record.derived(SweepGrid).axes) == 1


def size(record, look):
    width = look.width or 7
    return width, 5.6


class _Track:
    """The cells of one attractor, by rising parameter."""

    def __init__(self, record, rows, place):
        column = lambda name: record.column("attractors", name)[rows]
        cells = place[column("cell").astype(int)]
        order = numpy.argsort(cells)
        self.cells = cells[order]
        self.share, self.spin = column("share")[order], column("mean_S")[order]
        self.low, self.high = column("share_low")[order], column("share_high")[order]
        self.kind, self.period = record.names("attractors", "kind")[rows][0], int(column("period")[0])

    @property
    def label(self):
        name = f"{self.period}-cycle" if self.kind == "cycle" else str(self.kind)
        least, most = self.spin.min(), self.spin.max()
        short = lambda value: number(float(f"{value:.3g}"))
        return name + f", S = {short(least)}" + (f" … {short(most)}" if most - least > 1e-6 else "")

    def stretches(self):
        """Places of its cells, each run of cells side by side apart."""
        return numpy.split(numpy.arange(len(self.cells)), numpy.flatnonzero(numpy.diff(self.cells) > 1) + 1)


def _tracks(record, points, grid):
    numbers, cells = record.column("attractors", "track").astype(int), record.column("attractors", "cell")
    if ((cells < 0) | (cells >= len(points))).any():
        raise RecordError(f"record '{record.path}': attractors/cell is no place in its {len(points)} cells")
    place = numpy.argsort(numpy.argsort(record.column("sweep", grid.axes[0])))
    tracks = [_Track(record, numbers == number, place) for number in numpy.unique(numbers[numbers >= 0])]
    return sorted(tracks, key=lambda track: -len(track.cells))


def _draw(axes, track, points, values, colour, big):
    for cells in track.stretches():
        axes.plot(points[track.cells[cells]], values[cells], "-", lw=1.1, color=colour)
    axes.plot(points[track.cells], values, "o", ms=3.5 if big else 2, color=colour, mec="none")


def _listed_tracks(tracks, named):
    """For a caption: all attractors."""
    rows = [(track.label.split(",")[0], len(track.cells), f"{track.share.min():.4g}", f"{track.share.max():.4g}",
             f"{track.spin.min():.6g}", f"{track.spin.max():.6g}", "" if i < named else "in grey")
            for i, track in enumerate(tracks)]
    return listed(f"Attractors, {len(tracks)}:", ("", "cells", "share from", "to", "mean S from", "to", ""), rows)


def draw_into(figure, record, look):
    grid = record.derived(SweepGrid)
    points = grid.points[grid.axes[0]]
    tracks = _tracks(record, points, grid)
    colours = [CYCLE[i] if i < _MOST_NAMED else GREY for i in range(len(tracks))]
    handles = [Line2D([], [], marker="o", ms=4, color=colour, label=track.label)
               for track, colour in zip(tracks, colours) if colour != GREY]
    if len(tracks) > len(handles):
        handles.append(Line2D([], [], marker="o", ms=4, color=GREY, label=f"{len(tracks) - len(handles)} more, over fewer cells"))
    look.title(figure, sweep_title(grid))
    look.notes.append(_listed_tracks(tracks, len(handles) - (len(tracks) > _MOST_NAMED)))
    parts = LegendBelow(figure)
    parts.fill(handles, look)
    above, below = parts.above.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    below.axhline(0, color="0.8", lw=0.7, zorder=0)
    big = len(points) < 60
    for track, colour in reversed(list(zip(tracks, colours))):
        above.vlines(points[track.cells], track.low, track.high, color=colour, lw=0.6, alpha=0.45)
        _draw(above, track, points, track.share, colour, big)
        _draw(below, track, points, track.spin, colour, big)
    above.set(ylabel="share of the starts", ylim=(-0.03, 1.03))
    above.set_title("thin bars: Wilson's interval, 95 %", fontsize="small", color="0.25", loc="right", pad=2)
    below.set(xlabel=axis_label(grid.axes[0]), ylabel=f"mean spin {MEAN_SPIN}, in $\\omega_s$")
    return [above]
