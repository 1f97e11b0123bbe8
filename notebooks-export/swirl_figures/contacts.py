"""Sustained contact with the wall: which motion when, what began and ended each piece, and, where the record has samples
(simulate --sample), the wall's forces and the slip."""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.lines import Line2D

from .look import LegendBelow, is_narrow
from .spin import spin_on_wall
from .style import BLACK, BLUE, GREEN, ORANGE, SKY, VERMILION
from .symbols import SPIN, TIME, scene_title

_MOTIONS = {"sliding": (VERMILION, "sliding"), "sticking": (BLUE, "sticking"), "rolling": (GREEN, "rolling")}

_EVENTS = {"landing": "v", "release": "^", "slip": ">", "stick": "s", "strike": "X", "lift": "d", "jam": "P"}

_FORCES = ("normal_force", "friction", "slip")


def has_contacts(record):
    return "collisions" in record and "contacts" in record and len(record.column("contacts", "t_start")) > 0


def _has_forces(record):
    return record.has("samples", "normal_force")


def size(record, width):
    return width or 7.5, 6.6 if _has_forces(record) else 3.9


def _whole(record):
    """The contacts and a tenth of the orbit about them, or the pieces before one that is far longer than the rest."""
    start, end = record.column("contacts", "t_start"), record.column("contacts", "t_end")
    last = end[-1]
    before = end[-2] if len(end) > 1 else start[-1]
    if end[-1] - start[-1] > 20 * max(before - start[0], 1):
        last = start[-1] + max(before - start[0], 20)
    margin = 0.05 * (last - start[0])
    return max(start[0] - margin, 0), last + margin


def _draw_motions(axes, record):
    """A bar a motion and piece; marks where events begin and end it. Handles of the legend."""
    start, end = record.column("contacts", "t_start"), record.column("contacts", "t_end")
    motion = record.names("contacts", "motion")
    present = [name for name in _MOTIONS if name in motion]
    for row, name in enumerate(present):
        of = motion == name
        axes.add_collection(LineCollection([[(a, row), (b, row)] for a, b in zip(start[of], end[of])], linewidths=7,
                                           colors=_MOTIONS[name][0], capstyle="butt"))
    height = numpy.array([present.index(name) for name in motion])
    handles = []
    for event, marker in _EVENTS.items():
        begun, ended = record.names("contacts", "begin") == event, record.names("contacts", "end") == event
        style = {"ls": "", "marker": marker, "ms": 5, "mfc": "white", "mec": BLACK, "mew": 0.8}
        if begun.any() or ended.any():
            axes.plot(numpy.concatenate([start[begun], end[ended]]), numpy.concatenate([height[begun], height[ended]]),
                      zorder=3, **style)
            handles.append(Line2D([], [], label=event, **style))
    axes.set(yticks=range(len(present)), yticklabels=[_MOTIONS[name][1] for name in present],
             ylim=(-0.6, len(present) - 0.4), title="Motion on the wall, and its events")
    return handles


def _draw_spin(axes, record):
    curves, _ = spin_on_wall(record)
    axes.plot(record.column("collisions", "t"), record.column("collisions", "spin"), "o", ms=2.5, color=BLUE, mec="none",
              label="after each impact")
    for index, (t, spin) in enumerate(curves):
        axes.plot(t, spin, color=ORANGE, lw=1.6, label="on the wall" if index == 0 else None)
    if not curves:
        start, end, mean = (record.column("contacts", name) for name in ("t_start", "t_end", "mean_S"))
        axes.hlines(mean, start, end, color=ORANGE, lw=2, label="on the wall (mean of each piece)")
    axes.set(ylabel=SPIN)
    axes.legend(loc="upper right", ncols=1 + (not is_narrow(axes.figure)))


def _draw_forces(force, slip, record):
    t, on_wall = record.column("samples", "t"), record.column("samples", "in_contact").astype(bool)
    normal, friction, velocity = (numpy.where(on_wall, record.column("samples", name), numpy.nan) for name in _FORCES)
    limit = record.scene()["mu"] * normal
    force.fill_between(t, -limit, limit, color="0.9", lw=0, label="$|f| \\leq \\mu\\lambda$")
    force.plot(t, normal, color=BLACK, lw=1.1, label="normal force $\\lambda$")
    force.plot(t, friction, color=VERMILION, lw=1.1, label="friction $f$")
    force.set(ylabel="in $m R_c \\omega_s^2$")
    force.legend(loc="upper right", ncols=1 + 2 * (not is_narrow(force.figure)))
    slip.plot(t, velocity, color=SKY, lw=1.3)
    slip.axhline(0, color="0.8", lw=0.7, zorder=0)
    slip.set(ylabel="slip $u_t/(R_c\\omega_s)$")


def _limit(panels, begin, end):
    """The ordinates are those of what is shown, with room for a legend."""
    room = 0.6 if is_narrow(panels[0].figure) else 0.3
    for axes in panels[1:]:
        values = [numpy.asarray(line.get_ydata(), float)[(line.get_xdata() >= begin) & (line.get_xdata() <= end)]
                  for line in axes.get_lines() if len(line.get_xdata()) > 2]
        values = numpy.concatenate(values) if values else numpy.zeros(0)
        values = values[numpy.isfinite(values)]
        if len(values) and numpy.ptp(values) > 0:
            axes.set_ylim(values.min() - 0.06 * numpy.ptp(values), values.max() + room * numpy.ptp(values))
    panels[0].set_xlim(begin, end)


def draw_into(figure, record, look):
    parts = LegendBelow(figure)
    forces = _has_forces(record)
    count = 4 if forces else 2
    panels = parts.above.subplots(count, 1, sharex=True, height_ratios=(1, 1.4, 1.4, 1)[:count])
    parts.fill(_draw_motions(panels[0], record), look)
    _draw_spin(panels[1], record)
    if forces:
        _draw_forces(panels[2], panels[3], record)
    begin, end = look.xlim or _whole(record)
    _limit(panels, begin, end)
    panels[-1].set_xlabel(TIME)
    total = record.column("contacts", "t_end")[-1]
    cut = f"; shown until {TIME} = {end:.4g} of {total:.6g}" if total > end else ""
    look.title(figure, scene_title(record.scene()) + cut)
    return [panels[0]]
