"""A sweep's figure, by the number of parameters that it varies."""

from .mode_bands import draw_mode_bands
from .mode_map import draw_mode_map
from .mode_panels import draw_mode_panels
from .record import open_record
from .sweep_grid import SweepGrid


def draw_sweep(record):
    record = open_record(record)
    return (draw_mode_bands, draw_mode_map, draw_mode_panels)[len(SweepGrid(record).axes) - 1](record)
