"""Figures of Swirl's records, for scripts and notebooks: they read records and nothing else.

    from swirl_figures import Look, draw, open_record
    figure = draw("orbit.h5")            # the kind of figure follows from what the record holds
    figure = draw("orbit.h5", "path")    # or by its name
    figure = draw(["a.h5", "b.h5"], look=Look(width=3.4, titles=False))  # for a paper's column, in inches
    open_record("orbit.h5")["collisions"]  # the numbers, as an xarray.Dataset

Figures are matplotlib Figures that belong to no window: save them with save(figure, "orbit.pdf").
"""

from .kinds import KINDS, draw, kind_of, kinds_of
from .look import Look
from .output import SUFFIXES, save
from . import caption, output, physical
from .record import Record, RecordError, open_record

__all__ = ["KINDS", "SUFFIXES", "Look", "Record", "RecordError", "draw", "kind_of", "kinds_of", "open_record", "save"]
