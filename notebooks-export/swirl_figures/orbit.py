"""A simulate record in one figure: the spin above, the path in three frames below."""

from . import path, spin
from .look import NARROW
from .symbols import scene_title


def _heights(record, width):
    """Of the spin, which is above, and of the path."""
    if width < NARROW:
        return 0.4 + 1.95 * record.derived(spin.spin_panels), path.size(record, width)[1] - 0.2  # no higher than a page
    return 2.95, 3.95


def size(record, width):
    width = width or 10
    return width, sum(_heights(record, width))


def draw_into(figure, record, look):
    look.title(figure, scene_title(record.scene()))
    width = figure.bbox.width / figure.figure.dpi
    above, below = figure.subfigures(2, 1, height_ratios=_heights(record, width))
    count = record.derived(spin.spin_panels)
    shape = (count, 1) if width < NARROW else (1, count)
    panels = list(above.subplots(*shape, squeeze=False).ravel())
    spin.draw_spin_into(panels, record)
    below.suptitle(path.draw_path_into(below, path.panels_of(below), record), fontsize="medium")
    path.write_caption(below)
    return panels[:1]
