"""A sweep's figure, by the number of parameters that it varies, and of points in a box. Of more than three parameters those
with the fewest values stand at their middle one."""

from . import mode_bands, mode_map, mode_panels, sweep_points
from .sweep_grid import SweepGrid

_SIZES = (mode_bands.size, mode_map.size, mode_panels.size)
_DRAWINGS = (mode_bands.draw_mode_bands, mode_map.draw_mode_map, mode_panels.draw_mode_panels)


def _shown(record):
    grid = record.derived(SweepGrid)
    while len(grid.axes) > len(_DRAWINGS):
        numbers = [name for name in grid.axes if name not in grid.words]  # laws are compared, and have no middle
        grid = grid.at_middle(min(numbers, key=lambda name: len(grid.points[name])))
    return grid


def size(record, look):
    if sweep_points.is_sampled(record):
        return sweep_points.size(record, look)
    grid = _shown(record)
    return _SIZES[len(grid.axes) - 1](grid, look)


def draw_into(figure, record, look):
    if sweep_points.is_sampled(record):
        return sweep_points.draw_into(figure, record, look)
    grid = _shown(record)
    return _DRAWINGS[len(grid.axes) - 1](figure, grid, look)
