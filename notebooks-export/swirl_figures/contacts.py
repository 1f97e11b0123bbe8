"""Sustained contact with the wall: which motion when, what began and ended each piece, and, where the record has samples
(simulate --sample), the wall's forces and the slip."""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .cut import tell_cut
from .legends import LegendBelow, legend_inside, panel_size
from .ranges import inside, overlapping, part, require
from .spin import spin_on_wall
from .style import BLACK, BLUE, GREEN, ORANGE, PURPLE, SKY, VERMILION
from .symbols import SPIN, TIME, scene_title

_MOTIONS = {"sliding": (VERMILION, "sliding"), "sticking": (BLUE, "sticking"), "rolling": (GREEN, "rolling"),
            "resting": (PURPLE, "resting")}

#: Points that a mark of an event takes.
_MARK = 6.0

_EVENTS = {"landing": "v", "release": "^", "slip": ">", "stick": "s", "strike": "X", "lift": "d", "jam": "P"}

_FORCES = ("normal_force", "friction", "slip")


def has_contacts(record):
    return "collisions" in record and "contacts" in record and len(record.column("contacts", "t_start")) > 0


def _has_forces(record):
    return record.has("samples", "normal_force")


def size(record, look):
    return look.width or 7.5, 6.6 if _has_forces(record) else 3.9


def _whole(record):
    """The contacts and a tenth of the orbit about them, or the pieces before one that is far longer than the rest."""
    start, end = record.column("contacts", "t_start"), record.column("contacts", "t_end")
    last = end[-1]
    before = end[-2] if len(end) > 1 else start[-1]
    if end[-1] - start[-1] > 20 * max(before - start[0], 1):
        last = start[-1] + max(before - start[0], 20)
    margin = 0.05 * (last - start[0])
    return max(start[0] - margin, 0), last + margin


def _meet(times, others, near):
    """Whether any of these lies that near to one of the others."""
    others = numpy.sort(others)
    return (numpy.searchsorted(others, times + near, side="right") > numpy.searchsorted(others, times - near)).any()


def _lanes(times, near):
    """{event: lane} of the times of each event on one bar: those that would lie on another event's marks go to another
    lane."""
    lanes, lane_of = [], {}
    for event, own in times.items():
        free = (i for i, lane in enumerate(lanes) if not any(_meet(own, other, near) for other in lane))
        lane_of[event] = next(free, len(lanes))
        if lane_of[event] == len(lanes):
            lanes.append([])
        lanes[lane_of[event]].append(own)
    return lane_of


def _draw_events(axes, times, row, rows, xlim):
    """Marks on one of the bars; lanes lie as far above one another as marks are high, where its row has room."""
    width, height = (72 * inches for inches in panel_size(axes))
    lane_of = _lanes(times, _MARK / width * (xlim[1] - xlim[0]))
    count = max(lane_of.values(), default=0) + 1
    step = min(_MARK / height * rows, 0.8 / count)
    for event, own in times.items():
        place = row + ((count - 1) / 2 - lane_of[event]) * step
        axes.plot(own, numpy.full(len(own), place), zorder=3, **_style(event))


def _style(event):
    return {"ls": "", "marker": _EVENTS[event], "ms": 5, "mfc": "white", "mec": BLACK, "mew": 0.8}


def _draw_motions(axes, record, xlim):
    """A bar a motion and piece; marks where events begin and end it. Handles of the legend."""
    start, end = record.column("contacts", "t_start"), record.column("contacts", "t_end")
    seen = overlapping(start, end, xlim)
    start, end, motion = start[seen], end[seen], record.names("contacts", "motion")[seen]
    present = [name for name in _MOTIONS if name in motion]
    for row, name in enumerate(present):
        of = motion == name
        axes.add_collection(LineCollection([[(a, row), (b, row)] for a, b in zip(start[of], end[of])], linewidths=7,
                                           colors=_MOTIONS[name][0], capstyle="butt"))
    begun_by, ended_by = record.names("contacts", "begin")[seen], record.names("contacts", "end")[seen]
    drawn = set()
    for row, name in enumerate(present):
        times = {event: numpy.concatenate([start[(begun_by == event) & (motion == name) & inside(start, xlim)],
                                           end[(ended_by == event) & (motion == name) & inside(end, xlim)]])
                 for event in _EVENTS}
        times = {event: own for event, own in times.items() if len(own)}
        _draw_events(axes, times, row, len(present) + 0.2, xlim)
        drawn |= set(times)
    axes.set(yticks=range(len(present)), yticklabels=[_MOTIONS[name][1] for name in present],
             ylim=(-0.6, len(present) - 0.4), title="Motion on the wall, and its events")
    return [Line2D([], [], label=event, **_style(event)) for event in _EVENTS if event in drawn]


def _draw_spin(axes, record, xlim):
    curves, _ = spin_on_wall(record, xlim=xlim)
    t = record.column("collisions", "t")
    seen = inside(t, xlim)
    if seen.any():
        axes.plot(t[seen], record.column("collisions", "spin")[seen], "o", ms=2.5, color=BLUE, mec="none",
                  label="after each impact")
    for index, (t, spin) in enumerate(curves):
        axes.plot(t, spin, color=ORANGE, lw=1.6, label="on the wall" if index == 0 else None)
    if not curves:
        start, end, mean = (record.column("contacts", name) for name in ("t_start", "t_end", "mean_S"))
        pieces = overlapping(start, end, xlim)
        axes.hlines(mean[pieces], start[pieces], end[pieces], color=ORANGE, lw=2, label="on the wall (mean of each piece)")
    axes.set(ylabel=SPIN)
    legend_inside(axes, "right")


def _draw_forces(force, slip, record, xlim):
    shown = part(record.column("samples", "t"), xlim)
    t, on_wall = record.column("samples", "t")[shown], record.column("samples", "in_contact")[shown].astype(bool)
    normal, friction, velocity = (numpy.where(on_wall, record.column("samples", name)[shown], numpy.nan) for name in _FORCES)
    limit = record.scene()["mu"] * normal
    force.fill_between(t, -limit, limit, color="0.9", lw=0, label="$|f| \\leq \\mu\\lambda$")
    force.plot(t, normal, color=BLACK, lw=1.1, label="normal force $\\lambda$")
    force.plot(t, friction, color=VERMILION, lw=1.1, label="friction $f$")
    force.set(ylabel="force$/(m R_c \\omega_s^2)$")
    legend_inside(force, "right")
    slip.plot(t, velocity, color=SKY, lw=1.3)
    slip.axhline(0, color="0.8", lw=0.7, zorder=0)
    slip.set(ylabel="slip $u_t/(R_c\\omega_s)$")


def draw_into(figure, record, look):
    start, end = record.column("contacts", "t_start"), record.column("contacts", "t_end")
    xlim = look.xlim or _whole(record)
    require(overlapping(start, end, xlim).any(), look, record, "contact with the wall", [start[0], end[-1]])
    look.title(figure, scene_title(record.scene()))
    parts = LegendBelow(figure)
    forces = _has_forces(record)
    count = 4 if forces else 2
    panels = parts.above.subplots(count, 1, sharex=True, height_ratios=(1, 1.4, 1.4, 1)[:count])
    parts.fill(_draw_motions(panels[0], record, xlim), look)
    _draw_spin(panels[1], record, xlim)
    if forces:
        _draw_forces(panels[2], panels[3], record, xlim)
    panels[0].set_xlim(xlim)
    panels[-1].set_xlabel(f"time {TIME}")
    if not look.xlim and end[-1] > xlim[1]:
        tell_cut(panels[0], look, panels[0].get_title(), xlim[1], end[-1])
    return [panels[0]]
