"""The figures of records, which live beside the command (notebooks-export)."""

import os
import sys

from ._places import FIGURES_FROM_MODULE, FIGURES_SOURCE


def folder():
    """SWIRL_FIGURES, or where it was installed, or that of the source tree."""
    chosen = os.environ.get("SWIRL_FIGURES")
    installed = os.path.normpath(os.path.join(os.path.dirname(os.path.realpath(__file__)), FIGURES_FROM_MODULE))
    for place in [chosen] if chosen else [installed, FIGURES_SOURCE]:
        if os.path.isfile(os.path.join(place, "plot_record.py")):
            return place
    raise OSError(f"{chosen or 'the folder of figures'} holds no plot_record.py: install python3-swirl-figures, or set "
                  "SWIRL_FIGURES to notebooks-export")


def draw(record, kind, look):
    place = folder()
    if place not in sys.path:
        sys.path.insert(0, place)
    import swirl_figures
    try:
        opened = swirl_figures.open_record(record)
        return swirl_figures.draw(opened, kind, swirl_figures.Look(**look))
    except swirl_figures.RecordError as error:
        raise ValueError(str(error)) from None
