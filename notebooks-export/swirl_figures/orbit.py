"""A simulate record in one figure: the spin above, the path in three frames below."""

import dataclasses

from . import path, spin
from .look import NARROW, width_of
from .symbols import scene_title
from .words import broken, letters_across


def _heights(record, width, look):
    """Of the spin, which is above, and of the path."""
    rows = spin.spin_panels(record, look) // spin.columns(record, width, look)
    below = path.size(record, dataclasses.replace(look, width=width))[1] - 0.2
    if width < NARROW or rows > 1:
        return 0.4 + (1.95 if width < NARROW else 1.75) * rows, below
    return 0.55 + min(0.24 * width, 2.4), below


def size(record, look):
    width = look.width or 10
    return width, sum(_heights(record, width, look))


def draw_into(figure, record, look):
    look.title(figure, scene_title(record.scene()))
    width = width_of(figure)
    above, below = figure.subfigures(2, 1, height_ratios=_heights(record, width, look))
    count, columns = spin.spin_panels(record, look), spin.columns(record, width, look)
    panels = list(above.subplots(count // columns, columns, squeeze=False).ravel())
    spin.draw_spin_into(panels, record, look)
    title = path.draw_path_into(below, path.panels_of(below), record)
    below.suptitle(broken(title, letters_across(width, look.letters)), fontsize="medium")
    path.write_caption(below)
    return panels[:1]
