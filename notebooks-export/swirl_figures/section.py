"""Portrait of an orbit on the section: two of its coordinates just after each impact."""

import numpy
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from .look import LegendBelow, widen
from .record import RecordError
from .style import CYCLE, MANY_POINTS, TIMES
from .symbols import TIME, observable_label, scene_title
from .thinning import DOTS, cells_of, mean_in_cells

#: A coordinate of the section by its name: its column.
_COLUMNS = {"psi": "psi", "chi": "chi", "vn": "vn", "vt": "vt", "S": "spin"}


def _coordinate(record, name):
    if name not in _COLUMNS:
        raise RecordError(f"coordinate = {name}: the section's are {', '.join(_COLUMNS)}")
    if not record.has("collisions", _COLUMNS[name]):
        raise RecordError(f"coordinate = {name}: the section of record '{record.path}' has none, its body is a disk")
    return record.column("collisions", _COLUMNS[name])


def dot_size(count):
    """Points², small where many dots would cover one another."""
    return float(numpy.clip(3000 / max(count, 1), 0.4, 12))


def _label(axes, look):
    axes.set(xlabel=observable_label(look.x), ylabel=observable_label(look.y))
    axes.margins(0.03)
    axes.ticklabel_format(useOffset=False)
    widen(axes)


def size(record, width):
    width = width or 5.6
    return width, 0.3 + 0.78 * width


def draw_into(figure, record, look):
    """The colour tells the time."""
    x, y, t = _coordinate(record, look.x), _coordinate(record, look.y), record.column("collisions", "t")
    if len(t) == 0:
        raise RecordError(f"record '{record.path}' lists no impacts: there is nothing to draw")
    axes = figure.subplots()
    times = Normalize(t[0], t[-1])
    if len(t) > DOTS:
        cell, limits = cells_of(x, y)
        dots = axes.imshow(mean_in_cells(cell, t), extent=limits, origin="lower", aspect="auto", cmap=TIMES, norm=times,
                           interpolation="nearest")
    else:
        order = numpy.random.default_rng(1).permutation(len(t))  # late dots do not all lie on the early ones
        dots = axes.scatter(x[order], y[order], c=t[order], cmap=TIMES, norm=times, s=dot_size(len(t)), lw=0,
                            rasterized=len(t) > MANY_POINTS)
    bar = figure.colorbar(dots, ax=axes, label=TIME, pad=0.02, aspect=30)
    bar.ax.ticklabel_format(useOffset=False, style="plain")
    _label(axes, look)
    look.title(figure, f"{scene_title(record.scene())}\n{len(t):,} impacts{', the mean time in each cell' * (len(t) > DOTS)}")
    return [axes]


def _differences(scenes):
    """What tells the runs apart: of each scene the parameters that are not those of the first."""
    varied = [name for name in scenes[0] if any(scene.get(name) != scenes[0][name] for scene in scenes)]
    return [scene_title({name: scene[name] for name in varied}) for scene in scenes]


def _names(records):
    names = _differences([record.scene() for record in records])
    seeds = [record.attributes("start").get("seed") for record in records]
    if len(set(names)) < len(names):
        names = [", ".join(filter(None, (name, f"seed {seed}" if seed is not None else f"run {i + 1}")))
                 for i, (name, seed) in enumerate(zip(names, seeds))]
    return names


def draw_together(figure, records, look):
    """Several orbits in the same axes, a colour a run."""
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    count = sum(len(record.column("collisions", "t")) for record in records)
    handles = []
    for record, colour, name in zip(records, CYCLE, _names(records)):
        x, y = _coordinate(record, look.x), _coordinate(record, look.y)
        every = -(-count // DOTS)
        axes.scatter(x[::every], y[::every], s=dot_size(count), lw=0, color=colour, rasterized=count > MANY_POINTS)
        handles.append(Line2D([], [], ls="", marker="o", ms=4, color=colour,
                              label=name + (f" (every {every}th impact)" if every > 1 else "")))
    _label(axes, look)
    varied = {name for record in records for name, value in record.scene().items() if value != records[0].scene()[name]}
    look.title(figure, scene_title(records[0].scene(), leave_out=varied))
    parts.fill(handles, look)
    return [axes]
