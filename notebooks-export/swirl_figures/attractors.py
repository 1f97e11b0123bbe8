"""A sweep over one parameter whose attractors were followed from cell to cell: the share of the starts that each has, and
its mean S, as curves. A dot is a cell; a line joins cells side by side that have the same attractor. What the runs of a cell came
to whose verdicts name no attractor is a ring: it was not followed."""

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
    """The cells of one attractor, by rising parameter; of number -1 what was not followed, of which a cell may have several."""

    def __init__(self, record, number, place):
        rows = record.column("attractors", "track") == number
        column = lambda name: record.column("attractors", name)[rows]
        cells = place[column("cell").astype(int)]
        order = numpy.argsort(cells)
        self.cells = cells[order]
        self.share, self.spin = column("share")[order], column("mean_S")[order]
        self.low, self.high = column("share_low")[order], column("share_high")[order]
        self.kind, self.period = record.names("attractors", "kind")[rows][0], int(column("period")[0])
        self.followed = number >= 0

    @property
    def name(self):
        if not self.followed:
            return "no attractor by the verdict: not followed"
        return f"{self.period}-cycle" if self.kind == "cycle" else str(self.kind)

    @property
    def label(self):
        least, most = self.spin_range
        short = lambda value: number(float(f"{value:.3g}"))
        several = f" … {short(most)}" if most - least > 1e-6 else ""
        return self.name + (f", {MEAN_SPIN} = {short(least)}{several}" if self.followed else "")

    @property
    def spin_range(self):
        return numpy.fmin.reduce(self.spin), numpy.fmax.reduce(self.spin)

    def stretches(self):
        """Places of its cells, each run of cells side by side apart."""
        return numpy.split(numpy.arange(len(self.cells)), numpy.flatnonzero(numpy.diff(self.cells) > 1) + 1)


def _tracks(record, points, grid):
    """Those over more cells first, what was not followed at the end."""
    numbers, cells = record.column("attractors", "track").astype(int), record.column("attractors", "cell")
    if ((cells < 0) | (cells >= len(points))).any():
        raise RecordError(f"record '{record.path}': attractors/cell is no place in its {len(points)} cells")
    place = numpy.argsort(numpy.argsort(record.column("sweep", grid.axes[0])))
    tracks = [_Track(record, number, place) for number in numpy.unique(numbers)]
    return sorted(tracks, key=lambda track: (not track.followed, -len(track.cells)))


def _sizes(tracks, size):
    """Diameters of each one's dots. Where several of a cell have one share those beneath are larger, and seen as rings: the
    shares that are seen of a cell add up to 1."""
    above, sizes = {}, []
    for track in tracks:
        own = []
        for place in zip(track.cells, track.share.round(2)):
            own.append(size + 3 * min(above.get(place, 0), 3))
            above[place] = above.get(place, 0) + 1
        sizes.append(numpy.array(own))
    return sizes


def _draw(axes, track, points, values, colour, size):
    if not track.followed:
        axes.scatter(points[track.cells], values, s=size**2, fc="white", ec=colour, lw=0.9, zorder=2)
        return
    for cells in track.stretches():
        axes.plot(points[track.cells[cells]], values[cells], "-", lw=1.1, color=colour)
    axes.scatter(points[track.cells], values, s=size**2, color=colour, lw=0, zorder=2)


def _handles(tracks, colours):
    handles = [Line2D([], [], marker="o", ms=4, color=colour, label=track.label)
               for track, colour in zip(tracks, colours) if colour != GREY]
    more = sum(track.followed for track in tracks) - len(handles)
    if more:
        handles.append(Line2D([], [], marker="o", ms=4, color=GREY, label=f"{more} more, over fewer cells"))
    return handles + [Line2D([], [], ls="", marker="o", ms=4, mfc="white", mec=GREY, mew=0.9, label=track.label)
                      for track in tracks if not track.followed]


def _listed_tracks(tracks, colours):
    """For a caption: all attractors."""
    rows = [(track.name, len(set(track.cells)), f"{track.share.min():.4g}", f"{track.share.max():.4g}",
             *(f"{spin:.6g}" for spin in track.spin_range), "in grey" if colour == GREY else "")
            for track, colour in zip(tracks, colours)]
    count = sum(track.followed for track in tracks)
    return listed(f"Attractors, {count}:", ("", "cells", "share from", "to", "mean S from", "to", ""), rows)


def draw_into(figure, record, look):
    grid = record.derived(SweepGrid)
    points = grid.points[grid.axes[0]]
    tracks = _tracks(record, points, grid)
    colours = [CYCLE[i] if i < _MOST_NAMED and track.followed else GREY for i, track in enumerate(tracks)]
    look.title(figure, sweep_title(grid))
    look.notes.append(_listed_tracks(tracks, colours))
    parts = LegendBelow(figure)
    parts.fill(_handles(tracks, colours), look)
    above, below = parts.above.subplots(2, 1, sharex=True, height_ratios=(3, 2))
    below.axhline(0, color="0.8", lw=0.7, zorder=0)
    size = 3.5 if len(points) < 60 else 2
    for track, colour, sizes in reversed(list(zip(tracks, colours, _sizes(tracks, size)))):
        above.vlines(points[track.cells], track.low, track.high, color=colour, lw=0.6, alpha=0.45)
        _draw(above, track, points, track.share, colour, sizes)
        _draw(below, track, points, track.spin, colour, size)
    above.set(ylabel="share of the starts", ylim=(-0.03, 1.03))
    above.set_title("thin bars: Wilson's interval, 95 %", fontsize="small", color="0.25", loc="right", pad=2)
    below.set(xlabel=axis_label(grid.axes[0]), ylabel=f"mean spin {MEAN_SPIN}")
    grid.name_ticks(below)
    return [above]
