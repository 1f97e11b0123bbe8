"""J, the energy in the swirling frame, along an orbit, and what restitution and friction change of it at each impact."""

import numpy

from .legends import legend_inside
from .ranges import inside, part, require
from .record import RecordError
from .style import BLUE, ORANGE, VERMILION
from .symbols import ENERGY, TIME, scene_title
from .thinning import DOTS, band_of, thinned


def size(record, look):
    return look.width or 7.5, 6.4


def _parts(record):
    """(name, colour, change at each impact) of the two parts."""
    return (("restitution, $-p\\,\\bar u_n$", VERMILION, record.column("collisions", "jacobi_restitution")),
            ("friction, $q(\\bar u_t - 1)$", BLUE, record.column("collisions", "jacobi_friction")))


def _draw_energy(axes, record, t, shown):
    axes.plot(*thinned(t[shown], record.column("collisions", "jacobi")[shown]), color="0.25", lw=0.9, drawstyle="steps-post")
    axes.set(ylabel=ENERGY, title="After each impact")


def _draw_changes(axes, record, t, seen):
    t = t[seen]
    for name, colour, change in _parts(record)[::-1]:  # friction changes more: beneath
        if len(t) > DOTS:
            axes.fill_between(*band_of(t, change[seen]), color=colour, lw=0.3, alpha=0.75, label=f"{name}, least to greatest")
        else:
            axes.scatter(t, change[seen], s=float(numpy.clip(4000 / len(t), 0.5, 14)), lw=0, color=colour, label=name,
                         zorder=2)
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


def _draw_sums(axes, record, t, shown):
    """Summed from the first listed impact on, also where only later ones are shown."""
    for name, colour, change in _parts(record):
        total = numpy.cumsum(change) - change[0]
        axes.plot(*thinned(t[shown], total[shown]), color=colour, lw=1.1, label=name)
    in_contact = _in_contact(record, t)
    if in_contact is not None:
        axes.plot(*thinned(t[shown], in_contact[shown]), color=ORANGE, lw=1.1, label="contact with the wall")
    energy = record.column("collisions", "jacobi")
    axes.plot(*thinned(t[shown], (energy - energy[0])[shown]), color="0.25", lw=1.1, ls=(0, (4, 2)),
              label="all: $J$ less its first value")
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    axes.set(ylabel="sum of $\\Delta J$", xlabel=f"time {TIME}", title="Their sums since the first listed impact")


def _is_complete(record):
    """False where impacts were left out (--every): then the parts do not add up to J."""
    return int(record.attributes("settings").get("every", 1)) == 1


def draw_into(figure, record, look):
    t = record.column("collisions", "t")
    if len(t) == 0:
        raise RecordError(f"record '{record.path}' lists no impacts: there is nothing to draw")
    shown, seen = part(t, look.xlim), inside(t, look.xlim)
    require(seen.any(), look, record, "impact", t)
    complete = _is_complete(record)
    panels = figure.subplots(2 + complete, 1, sharex=True)
    _draw_energy(panels[0], record, t, shown)
    _draw_changes(panels[1], record, t, seen)
    if complete:
        _draw_sums(panels[2], record, t, shown)
    panels[-1].set_xlabel(f"time {TIME}")
    for axes in panels[1:]:
        legend_inside(axes, markerscale=1 if seen.sum() < 2000 else 4)
    panels[0].margins(x=0.01)
    look.title(figure, scene_title(record.scene()))
    return [panels[0]]
