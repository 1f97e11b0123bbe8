"""Portrait of an orbit on the section: two of its coordinates just after each impact."""

import numpy
from matplotlib.colors import Normalize
from matplotlib.lines import Line2D

from .legends import LegendBelow
from .look import ROUNDING, widen
from .ranges import inside, require
from .record import RecordError
from .style import CYCLE, TIMES
from .symbols import TIME, observable_label, scene_title
from .thinning import CELLS, DOTS, cells_of, mean_in_cells
from .words import ordinal

#: A coordinate of the section by its name: its column.
_COLUMNS = {"psi": "psi", "chi": "chi", "vn": "vn", "vt": "vt", "S": "spin"}


def _coordinate(record, name):
    if name not in _COLUMNS:
        raise RecordError(f"coordinate = {name}: the section's are {', '.join(_COLUMNS)}")
    if not record.has("collisions", _COLUMNS[name]):
        raise RecordError(f"coordinate = {name}: the section of record '{record.path}' has none, its body is a disk")
    return record.column("collisions", _COLUMNS[name])


def _span(values):
    return max(numpy.nanmax(values) - numpy.nanmin(values), ROUNDING)


def dot_size(x, y, spans=None):
    """Points², small where many dots would cover one another; those of a cycle lie on few places of a portrait that spans
    as much, or as little as they do."""
    across, upright = spans or (_span(x), _span(y))
    places = numpy.unique((CELLS * x / across).round() + 1j * (CELLS * y / upright).round())
    return float(numpy.clip(3000 / max(len(places), 1), 0.4, 12))


def _points(record, look):
    """(x, y, t) of the impacts in the range of the abscissa."""
    x, y = (_coordinate(record, name) for name in look.coordinates)
    if len(x) == 0:
        raise RecordError(f"record '{record.path}' lists no impacts: there is nothing to draw")
    seen = inside(x, look.xlim)
    require(seen.any(), look, record, "impact", x)
    return x[seen], y[seen], record.column("collisions", "t")[seen]


def _how_many(records, seen):
    """"600", or of a range "28 of 600"."""
    count = sum(len(record.column("collisions", "t")) for record in records)
    return f"{count:,}" if seen == count else f"{seen:,} of {count:,}"


def _label(axes, look):
    x, y = look.coordinates
    axes.set(xlabel=observable_label(x), ylabel=observable_label(y))
    axes.margins(0.03)
    axes.ticklabel_format(useOffset=False)
    widen(axes)


def size(record, look):
    width = look.width or 5.6
    return width, 0.3 + 0.78 * width


def draw_into(figure, record, look):
    """The colour tells the time."""
    x, y, t = _points(record, look)
    axes = figure.subplots()
    times = Normalize(t[0], t[-1])
    if len(t) > DOTS:
        cell, limits = cells_of(x, y)
        dots = axes.imshow(mean_in_cells(cell, t), extent=limits, origin="lower", aspect="auto", cmap=TIMES, norm=times,
                           interpolation="nearest")
    else:
        order = numpy.random.default_rng(1).permutation(len(t))  # late dots do not all lie on the early ones
        dots = axes.scatter(x[order], y[order], c=t[order], cmap=TIMES, norm=times, s=dot_size(x, y), lw=0)
    bar = figure.colorbar(dots, ax=axes, label=f"time {TIME}", pad=0.02, aspect=30)
    bar.ax.ticklabel_format(useOffset=False, style="plain")
    _label(axes, look)
    cells = ", the mean time in each cell" if len(t) > DOTS else ""
    look.title(figure, f"{scene_title(record.scene())}\n{_how_many([record], len(t))} impacts{cells}")
    return [axes]


def _differences(scenes):
    """What tells the runs apart: of each scene the parameters that are not those of the first."""
    varied = [name for name in scenes[0] if any(scene.get(name) != scenes[0][name] for scene in scenes)]
    return [scene_title({name: scene[name] for name in varied}) for scene in scenes]


def _names(records):
    """By what tells them apart: the scene, else the seed of the start, else their place."""
    names = _differences([record.scene() for record in records])
    for more in ([f"seed {seed}" if seed is not None else "" for seed in
                  (record.attributes("start").get("seed") for record in records)],
                 [f"run {i + 1}" for i in range(len(records))]):
        if len(set(names)) < len(names):
            names = [", ".join(filter(None, pair)) for pair in zip(names, more)]
    return names


def draw_together(figure, records, look):
    """Several orbits in the same axes, a colour a run; each has as large a share of the dots as any other, and the larger
    dots of those that have few lie above."""
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    shown = [_points(record, look)[:2] for record in records]
    spans = [_span(numpy.concatenate(values)) for values in zip(*shown)]
    handles = []
    for (x, y), colour, name in zip(shown, CYCLE, _names(records)):
        every = -(-len(x) * len(records) // DOTS)
        size_of_dots = dot_size(x[::every], y[::every], spans)
        axes.scatter(x[::every], y[::every], s=size_of_dots, lw=0, color=colour, zorder=1 + 0.01 * size_of_dots)
        handles.append(Line2D([], [], ls="", marker="o", ms=4, color=colour,
                              label=name + (f" (every {ordinal(every)} impact)" if every > 1 else "")))
    _label(axes, look)
    varied = {name for record in records for name, value in record.scene().items() if value != records[0].scene()[name]}
    look.title(figure, f"{scene_title(records[0].scene(), leave_out=varied)}\n"
                       f"{len(records)} orbits, {_how_many(records, sum(len(x) for x, _ in shown))} impacts")
    parts.fill(handles, look)
    return [axes]
