"""A simulate record in one figure: the spin above, the path in three frames below."""

from matplotlib.figure import Figure

from .path import CAPTION, draw_path_into
from .record import open_record
from .spin import draw_spin_into, spin_panels
from .style import styled
from .symbols import scene_title


@styled
def draw_orbit(record):
    record = open_record(record)
    figure = Figure(figsize=(10, 6.9), layout="constrained")
    figure.suptitle(scene_title(record.scene()))
    above, below = figure.subfigures(2, 1, height_ratios=(3, 4))
    draw_spin_into(list(above.subplots(1, spin_panels(record), squeeze=False)[0]), record)
    title = draw_path_into(below, list(below.subplots(1, 3)), record)
    below.suptitle(title, fontsize=9)
    below.supxlabel(CAPTION, fontsize=8, color="0.25")
    return figure
