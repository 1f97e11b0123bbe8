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


def _let_notebooks_show():
    """A notebook shows figures as pictures once pyplot is imported, which these do without."""
    if "ipykernel" not in sys.modules:
        return
    from IPython import get_ipython
    from IPython.core.pylabtools import print_figure
    from matplotlib.figure import Figure
    shell = get_ipython()
    formatters = shell.display_formatter.formatters if shell else {}
    pictures = [formatters[name] for name in ("image/png", "image/svg+xml") if name in formatters]
    if pictures and not any(Figure in picture.type_printers for picture in pictures):
        pictures[0].for_type(Figure, lambda figure: print_figure(figure, fmt="png"))


def draw(record, kind, look):
    place = folder()
    if place not in sys.path:
        sys.path.insert(0, place)
    import swirl_figures
    try:
        _let_notebooks_show()
        opened = swirl_figures.open_record(record)
        return swirl_figures.draw(opened, kind, swirl_figures.Look(**look))
    except swirl_figures.RecordError as error:
        raise ValueError(str(error)) from None
