"""Figures of Swirl's records, for scripts and notebooks: they read records and nothing else.

    from swirl_figures import draw, open_record
    figure = draw("orbit.h5")            # the kind of figure follows from what the record holds
    figure = draw("orbit.h5", "path")    # or by its name
    open_record("orbit.h5")["collisions"]  # the numbers, as an xarray.Dataset

Figures are matplotlib Figures that belong to no window: save them with save(figure, "orbit.pdf").
"""

from .kinds import KINDS, draw, kind_of, kinds_of
from .output import SUFFIXES, save
from .record import Record, RecordError, open_record

__all__ = ["KINDS", "SUFFIXES", "Record", "RecordError", "draw", "kind_of", "kinds_of", "open_record", "save"]
