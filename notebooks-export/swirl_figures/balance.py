"""J, the energy in the swirling frame, along an orbit, and what restitution and friction change of it at each impact."""

import numpy

from .look import is_narrow
from .record import RecordError
from .style import BLUE, MANY_POINTS, ORANGE, VERMILION
from .symbols import ENERGY, TIME, scene_title
from .thinning import DOTS, band_of, thinned


def size(record, width):
    return width or 7.5, 6.4


def _parts(record):
    """(name, colour, change at each impact) of the two parts."""
    return (("restitution, $-p\\,\\bar u_n$", VERMILION, record.column("collisions", "jacobi_restitution")),
            ("friction, $q(\\bar u_t - 1)$", BLUE, record.column("collisions", "jacobi_friction")))


def _draw_energy(axes, record, t):
    axes.plot(*thinned(t, record.column("collisions", "jacobi")), color="0.25", lw=0.9, drawstyle="steps-post")
    axes.set(ylabel=ENERGY, title="After each impact")


def _draw_changes(axes, record, t):
    for name, colour, change in _parts(record)[::-1]:  # friction changes more: beneath
        if len(t) > DOTS:
            axes.fill_between(*band_of(t, change), color=colour, lw=0.3, alpha=0.75, label=f"{name}, least to greatest")
        else:
            axes.scatter(t, change, s=float(numpy.clip(4000 / len(t), 0.5, 14)), lw=0, color=colour, label=name, zorder=2,
                         rasterized=2 * len(t) > MANY_POINTS)
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    axes.set(ylabel="$\\Delta J$ of each impact", title="What each impact changes")


def _in_contact(record, t):
    """What contact with the wall changed until each impact, its friction and the chatter before it."""
    if "contacts" not in record or len(record.column("contacts", "t_end")) == 0:
        return None
    end = record.column("contacts", "t_end")
    change = record.column("contacts", "jacobi_friction") + record.column("contacts", "landing_jacobi")
    so_far = numpy.append(0, numpy.nancumsum(change))
    return so_far[numpy.searchsorted(end, t, side="right")] - so_far[numpy.searchsorted(end, t[0], side="right")]


def _draw_sums(axes, record, t):
    for name, colour, change in _parts(record):
        total = numpy.cumsum(change) - change[0]
        axes.plot(*thinned(t, total), color=colour, lw=1.1, label=name)
    in_contact = _in_contact(record, t)
    if in_contact is not None:
        axes.plot(*thinned(t, in_contact), color=ORANGE, lw=1.1, label="contact with the wall")
    energy = record.column("collisions", "jacobi")
    axes.plot(*thinned(t, energy - energy[0]), color="0.25", lw=1.1, ls=(0, (4, 2)), label="all: $J$ less its first value")
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    axes.set(ylabel="sum of $\\Delta J$", xlabel=TIME, title="Their sums since the first listed impact")


def _is_complete(record):
    """False where impacts were left out (--every): then the parts do not add up to J."""
    return int(record.attributes("settings").get("every", 1)) == 1


def draw_into(figure, record, look):
    t = record.column("collisions", "t")
    if len(t) == 0:
        raise RecordError(f"record '{record.path}' lists no impacts: there is nothing to draw")
    complete = _is_complete(record)
    panels = figure.subplots(2 + complete, 1, sharex=True)
    _draw_energy(panels[0], record, t)
    _draw_changes(panels[1], record, t)
    if complete:
        _draw_sums(panels[2], record, t)
    panels[-1].set_xlabel(TIME)
    for axes in panels[1:]:
        axes.legend(loc="upper left", bbox_to_anchor=(0, 1), ncols=1 + 3 * (not is_narrow(figure)), borderaxespad=0.1,
                    markerscale=1 if len(t) < 2000 else 4, columnspacing=1.2, handlelength=1.6)
        bottom, top = axes.get_ylim()
        axes.set_ylim(bottom, top + (0.5 if is_narrow(figure) else 0.2) * (top - bottom))
    panels[0].margins(x=0.01)
    look.title(figure, scene_title(record.scene()))
    return [panels[0]]
