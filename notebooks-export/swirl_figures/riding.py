"""What rides with a floor that drags is steady, but off the wall: figures show it as a mode of its own."""

import numpy

RIDING = "riding"


def riding_runs(record, order=None):
    """Which runs of a sweep ride, in this order of the dimensions' names; None of a sweep in which none does."""
    if not record.has("sweep", "run_kind"):
        return None
    attributes = record.column_attributes("sweep", "run_kind")
    names = dict(zip(attributes.get("flag_meanings", "").split(), numpy.atleast_1d(attributes.get("flag_values", []))))
    if RIDING not in names:
        return None
    rides = record.column("sweep", "run_kind", order) == names[RIDING]
    return rides if rides.any() else None


def share_apart(modes, share, rides):
    """The modes and their shares along the last axis, with riding taken out of the steady ones.
    rides: of each run, along the last axis"""
    if rides is None:
        return modes, share
    steady = modes.index("steady")
    riding, share = rides.mean(axis=-1), share.copy()
    share[..., steady] = numpy.maximum(share[..., steady] - riding, 0)
    apart = numpy.concatenate([share[..., :steady + 1], riding[..., None], share[..., steady + 1:]], axis=-1)
    return [*modes[:steady + 1], RIDING, *modes[steady + 1:]], apart


def shown_modes(record, group):
    """The modes of a group's rows, riding by its own name."""
    return numpy.where(record.names(group, "kind") == RIDING, RIDING, record.names(group, "mode"))
