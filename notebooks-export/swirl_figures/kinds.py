"""The kinds of figure by name, and which of them a record can be drawn as."""

from .bifurcation import draw_bifurcation
from .multipliers import draw_multipliers
from .orbit import draw_orbit
from .path import draw_path
from .record import RecordError, open_record
from .spin import draw_spin
from .sweep import draw_sweep
from .tradeoff import draw_tradeoff

#: name: (the groups of which a record must hold one, what draws it); a record's first match is its default
KINDS = {
    "orbit": ({"collisions"}, draw_orbit),
    "spin": ({"collisions"}, draw_spin),
    "path": ({"collisions"}, draw_path),
    "modes": ({"sweep"}, draw_sweep),
    "bifurcation": ({"samples", "branches", "special", "attractors"}, draw_bifurcation),
    "multipliers": ({"orbits"}, draw_multipliers),
    "tradeoff": ({"rungs"}, draw_tradeoff),
}


def kinds_of(record):
    """The names of the figures that a record can be drawn as, the default first."""
    groups = open_record(record).groups
    return [name for name, (needed, _) in KINDS.items() if needed & groups]


def kind_of(record, kind=None):
    """The kind that is asked for, or the default. RecordError where the record cannot be drawn as that."""
    record = open_record(record)
    possible = kinds_of(record)
    if not possible:
        raise RecordError(f"record '{record.path}' holds nothing that there is a figure of "
                          f"(its groups: {', '.join(sorted(record.groups)) or 'none'})")
    if kind is not None and kind not in possible:
        raise RecordError(f"kind = {kind} is no figure of record '{record.path}'; its figures: {', '.join(possible)}")
    return kind or possible[0]


def draw(record, kind=None):
    """The figure of a record: of its default kind, or of the kind named."""
    record = open_record(record)
    return KINDS[kind_of(record, kind)][1](record)
