"""The kinds of figure by name, and which of them a record can be drawn as."""

import dataclasses
from dataclasses import dataclass
from typing import Callable

from . import (arcs, attractors, balance, basins, bifurcation, boundaries, cells, contacts, energy, fit, lyapunov, multipliers, orbit, path,
               quantities, ramp, recurrence, section, sets, shares, spectrum, spin, steady_modes, sweep, tour, tradeoff, verdict)
from .look import Look, blank_figure, limit, require_kinds
from .record import RecordError, open_record
from .room import PAGE, make_room
from .style import rasterise_what_exceeds, styled_with


@dataclass(frozen=True)
class Kind:
    """`draw_into(figure, record, look)` draws into a figure or a part of one and gives back the axes that `--xlim`
    limits; `size(record, look)` is the (width, height) in inches that it wants, of no width the one it is drawn in on a
    screen; `together(figure, records, look)` draws several records into the same axes."""
    fits: Callable
    draw_into: Callable
    size: Callable
    together: Callable = None


def _with(group, column=None):
    """Has the group, and in it the column: a result of nothing has its group alone."""
    return lambda record: group in record and (column is None or record.has(group, column))


_simulate = _with("collisions")


def _describes(record):
    """Other records list the attracting modes of a scene beside what orbits came to."""
    return "steady_modes" in record and not {"runs", "sweep", "columns"} & set(record.groups)


#: By name; a record's first match is its default.
KINDS = {
    "orbit": Kind(_simulate, orbit.draw_into, orbit.size),
    "spin": Kind(_simulate, spin.draw_into, spin.size),
    "path": Kind(_simulate, path.draw_into, path.size),
    "section": Kind(_simulate, section.draw_into, section.size, section.draw_together),
    "balance": Kind(_simulate, balance.draw_into, balance.size),
    "energy": Kind(_simulate, energy.draw_into, energy.size),
    "contacts": Kind(contacts.has_contacts, contacts.draw_into, contacts.size),
    "basins": Kind(basins.has_basins, basins.draw_into, basins.size),
    "attractors": Kind(attractors.has_tracks, attractors.draw_into, attractors.size),
    "modes": Kind(_with("sweep"), sweep.draw_into, sweep.size),
    "means": Kind(quantities.has_quantities, quantities.draw_means, quantities.means_size),
    "map": Kind(quantities.has_plane, quantities.draw_map, quantities.map_size),
    "boundaries": Kind(boundaries.is_of_curves, boundaries.draw_into, boundaries.size),
    "cells": Kind(cells.is_of_cells, cells.draw_into, cells.size),
    "sets": Kind(sets.is_of_sets, sets.draw_into, sets.size),
    "bifurcation": Kind(bifurcation.is_diagram, bifurcation.draw_into, bifurcation.size),
    "ramp": Kind(ramp.is_ramp, ramp.draw_into, ramp.size),
    "multipliers": Kind(_with("orbits"), multipliers.draw_into, multipliers.size),
    "shares": Kind(_with("runs", "mode"), shares.draw_into, shares.size),
    "verdict": Kind(verdict.has_verdict, verdict.draw_into, verdict.size),
    "spectrum": Kind(_with("spectrum", "frequency"), spectrum.draw_into, spectrum.size),
    "recurrence": Kind(_with("recurrence", "RR"), recurrence.draw_into, recurrence.size),
    "lyapunov": Kind(_with("lyapunov", "exponents"), lyapunov.draw_into, lyapunov.size),
    "fit": Kind(_with("impacts", "misfit"), fit.draw_into, fit.size),
    "arcs": Kind(arcs.has_arcs, arcs.draw_into, arcs.size),
    "steady-modes": Kind(_describes, steady_modes.draw_into, steady_modes.size),
    "tour": Kind(tour.is_tour, tour.draw_into, tour.size),
    "tradeoff": Kind(_with("rungs"), tradeoff.draw_into, tradeoff.size),
}

#: Records below one another; more would be too small to read, or too high for a page.
MOST_RECORDS = 8


def kinds_of(record):
    """The names of the figures that a record can be drawn as, the default first."""
    record = open_record(record)
    return [name for name, kind in KINDS.items() if kind.fits(record)]


def nothing_in(record, of_what):
    """What is said of a record that none can be made of: why, where its orbit ended before there was anything to show."""
    for group in ("orbit", "result"):
        outcome = record.attributes(group).get("outcome", "completed")
        if outcome != "completed":
            return (f"record '{record.path}' holds nothing that there is {of_what} of: its orbit ended ({outcome}) before there "
                    "was enough of it")
    return f"record '{record.path}' holds nothing that there is {of_what} of (its groups: {', '.join(sorted(record.groups)) or 'none'})"


def kind_of(record, kind=None):
    """The kind that is asked for, or the default. RecordError where the record cannot be drawn as that."""
    record = open_record(record)
    possible = kinds_of(record)
    if not possible and "shard" in record:
        number, count = (record.attribute("shard", name) for name in ("number", "of"))
        raise RecordError(f"record '{record.path}' is shard {number} of {count} of a sweep, which swirl join makes one record; "
                          "that one can be drawn")
    if not possible:
        raise RecordError(nothing_in(record, "a figure"))
    if kind is not None and kind not in possible:
        raise RecordError(f"kind = {kind} is no figure of record '{record.path}'; its figures: {', '.join(possible)}")
    return kind or possible[0]


def draw(records, kind=None, look=Look()):
    """The figure of a record, of its default kind or of the kind named; of several records one figure: those of a section
    portrait in the same axes, boundaries over the mode map that they follow, ramps over the diagram of their parameter, others
    below one another, (a), (b), …"""
    records = [open_record(record) for record in (records if isinstance(records, (list, tuple)) else [records])]
    if len(records) > MOST_RECORDS:
        raise RecordError(f"{len(records)} records: a figure shows at most {MOST_RECORDS}")
    names = [kind_of(record, kind) for record in records]
    require_kinds(look, names)
    with styled_with(look.letters):
        figure = _drawn(records, names, look)
        rasterise_what_exceeds(figure)
        make_room(figure, look, f"a figure of kind {names[0]}" if len(records) == 1 else f"a figure of {len(records)} records")
        return figure


def _drawn(records, names, look):
    if len(records) == 1:
        return _draw_one(records[0], names[0], look)
    if names[0] == "modes" and set(names[1:]) == {"boundaries"}:
        return _draw_over_map(records, look)
    if names[0] == "bifurcation" and set(names[1:]) == {"ramp"}:
        return _draw_over_diagram(records, look)
    together = KINDS[names[0]].together
    if together and set(names) == {names[0]}:
        return _draw_together(records, names[0], look)
    return _draw_below_one_another(records, names, look)


def _blank(size, look):
    width, height = size
    return blank_figure(width, height if look.width is None else min(height, PAGE))


def _draw_one(record, name, look):
    kind = KINDS[name]
    figure = _blank(kind.size(record, look), look)
    limit(kind.draw_into(figure, record, look), look, name, record)
    return figure


def _draw_over_map(records, look):
    figure = _blank(boundaries.size(records[0], look), look)
    limit(boundaries.draw_over_map(figure, records, look), look, "boundaries", records[0])
    return figure


def _draw_over_diagram(records, look):
    figure = _blank(ramp.size(records[1], look), look)
    limit(ramp.draw_over_diagram(figure, records, look), look, "ramp", records[1])
    return figure


def _draw_together(records, name, look):
    kind = KINDS[name]
    figure = _blank(kind.size(records[0], look), look)
    limit(kind.together(figure, records, look), look, name, records[0])
    return figure


#: Their legends may be as high as their panels: how high shows when they are drawn.
_OF_ANY_HEIGHT = ("bifurcation", "multipliers")


def _height(record, name, look):
    if name in _OF_ANY_HEIGHT:
        return _draw_one(record, name, dataclasses.replace(look, notes=[])).get_size_inches()[1]  # tried, not shown
    return KINDS[name].size(record, look)[1]


def _see_through(figure):
    """Parts are drawn after what stands in the whole, and would cover it."""
    for part in figure.subfigs:
        part.patch.set_visible(False)
        _see_through(part)


def _draw_below_one_another(records, names, look):
    width = look.width or max(KINDS[name].size(record, look)[0] for record, name in zip(records, names))
    heights = [_height(record, name, dataclasses.replace(look, width=width)) for record, name in zip(records, names)]
    figure = _blank((width, sum(heights)), look)
    parts = figure.subfigures(len(records), 1, height_ratios=heights, squeeze=False)[:, 0]
    for letter, part, record, name in zip("abcdefgh", parts, records, names):
        look.notes.append(f"({letter}) {name}" if len(set(names)) > 1 else f"({letter})")
        limit(KINDS[name].draw_into(part, record, look), look, name, record)
        _see_through(part)
        part.text(0.004, 0.995, f"({letter})", va="top", ha="left", weight="bold")
    return figure
