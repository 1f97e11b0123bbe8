"""A sweep's figure, by the number of parameters that it varies, and of points in a box."""

from . import mode_bands, mode_map, mode_panels, sweep_points
from .sweep_grid import SweepGrid

_SIZES = (mode_bands.size, mode_map.size, mode_panels.size)
_DRAWINGS = (mode_bands.draw_mode_bands, mode_map.draw_mode_map, mode_panels.draw_mode_panels)


def size(record, width):
    if sweep_points.is_sampled(record):
        return sweep_points.size(record, width)
    grid = record.derived(SweepGrid)
    return _SIZES[len(grid.axes) - 1](grid, width)


def draw_into(figure, record, look):
    if sweep_points.is_sampled(record):
        return sweep_points.draw_into(figure, record, look)
    grid = record.derived(SweepGrid)
    return _DRAWINGS[len(grid.axes) - 1](figure, grid, look)
