"""What a fit made of a film: measured places and the arcs through them, straight or bent by a floor's drag, and the spin beside that of the orbit of the
scene that was found; or of falls on a plate (fall_arcs.py)."""

import numpy

from . import fall_arcs
from .legends import legend_inside
from .look import NARROW, width_of
from .ranges import inside, overlapping, part, require
from .style import BLACK, BLUE, GREY, ORANGE, VERMILION
from .symbols import SPIN, TIME

#: More arcs than these lie on one another in the laboratory, and as steps are a solid band.
_ARCS_OF_PATH, _ARCS_OF_SPIN = 12, 60
_POINTS_OF_BENT = 9


def has_arcs(record):
    return record.has("arcs", "vx") and record.has("frames", "x")


def size(record, look):
    width = look.width or 7.5
    return width, 5.6 if width >= NARROW else 8.0


def _begin(record):
    """Where the simulated orbit begins, and the film where there is none."""
    simulated = record.column("simulated", "time")
    return simulated[0] if simulated.size else record.column("arcs", "start")[0]


def _range(record, look, most):
    """(from, to) of the range that is asked for, at most so many arcs; without one from where the simulated orbit begins."""
    start, end = record.column("arcs", "start"), record.column("arcs", "end")
    shown = numpy.flatnonzero(overlapping(start, end, look.xlim) & (end >= (_begin(record) if look.xlim is None else start[0])))
    require(shown.size, look, record, "arc", numpy.array([start[0], end[-1]]))
    last = shown[min(most, shown.size) - 1]
    return start[shown[0]], end[last]


def _moved(record, times, middle, name):
    """What a velocity of 1 at the arc's middle moves the body by until then, and what the floor carries it by besides."""
    film = record.attributes("film")
    drag = film.get("arcs_drag", 0)
    if not drag:
        return times - middle, 0 * times
    factor = drag * film["floor_radius"] / (drag + 1j * film["floor_rate"])

    def carried(at):
        return factor * numpy.exp(1j * (film["floor_rate"] * at + film["floor_phase"]))

    part = numpy.real if name == "x" else numpy.imag
    free = -numpy.expm1(-drag * (times - middle)) / drag
    return free, part(carried(times) - carried(middle) - 1j * film["floor_rate"] * carried(middle) * free)


def _times(record, start, stop, drag):
    """From the arcs' starts to their ends, more of them where they bend, the last one twice: there the line is broken."""
    points = _POINTS_OF_BENT if record.attributes("film").get(drag, 0) else 2
    return start[:, None] + (stop - start)[:, None] * numpy.append(numpy.linspace(0, 1, points), 1)


def _lines(record, begin, end, name):
    """Arcs in (time, x) or (time, y), broken between them."""
    start, stop, middle, place, velocity = (record.column("arcs", of) for of in ("start", "end", "time", name, f"v{name}"))
    kept = overlapping(start, stop, (begin, end))
    times = _times(record, start[kept], stop[kept], "arcs_drag")
    free, carried = _moved(record, times, middle[kept, None], name)
    places = place[kept, None] + velocity[kept, None] * free + carried
    places[:, -1] = numpy.nan
    return times.ravel(), places.ravel()


def _impacts(record, begin, end):
    """Times of the kinks: (used, left out)."""
    time, use = record.column("kinks", "time"), record.column("kinks", "use")
    seen = inside(time, (begin, end))
    return time[seen & (use == "used")], time[seen & (use != "used")]


def _draw_path(axes, record, begin, end):
    seen = inside(record.column("frames", "time"), (begin, end))
    x, y = (record.column("frames", name)[seen] for name in "xy")
    axes.plot(x, y, ".", color=BLACK, ms=2.5, label="frames")
    axes.plot(_lines(record, begin, end, "x")[1], _lines(record, begin, end, "y")[1], color=VERMILION, lw=0.9, label="arcs")
    axes.set(xlabel="$x/R_c$", ylabel="$y/R_c$", title="The centre in the laboratory", aspect="equal")
    legend_inside(axes)


def _draw_places(axes, record, begin, end):
    time = record.column("frames", "time")
    seen = inside(time, (begin, end))
    for name, colour in (("x", BLUE), ("y", ORANGE)):
        axes.plot(time[seen], record.column("frames", name)[seen], ".", color=colour, ms=2.5, label=f"${name}/R_c$")
        axes.plot(*_lines(record, begin, end, name), color=VERMILION, lw=0.9)
    used, left_out = _impacts(record, begin, end)
    for times, colour, style in ((used, GREY, "-"), (left_out, GREY, ":")):
        for at in times:
            axes.axvline(at, color=colour, lw=0.6, ls=style, zorder=0)
    axes.set(xlabel=f"time {TIME}", title="Frames and arcs (dotted: kinks left out)", xlim=(begin, end))
    legend_inside(axes)


def _steps(time, spin, end):
    return numpy.append(time, end), numpy.append(spin, spin[-1:])


def _draw_spin(axes, record, begin, end):
    start, stop, middle, spin = (record.column("arcs", name) for name in ("start", "end", "time", "S"))
    kept = overlapping(start, stop, (begin, end))
    lines = _times(record, start[kept], stop[kept], "arcs_spin_drag")
    spins = spin[kept, None] * numpy.exp(-record.attributes("film").get("arcs_spin_drag", 0) * (lines - middle[kept, None]))
    spins[:, -1] = numpy.nan
    axes.plot(lines.ravel(), spins.ravel(), color=BLACK, lw=2.2, label="of the film's arcs")
    time, simulated = record.column("simulated", "time"), record.column("simulated", "S")
    if time.size:
        shown = part(time, (begin, end))
        ends = time[shown.stop] if shown.stop < time.size else end
        axes.step(*_steps(time[shown], simulated[shown], ends), where="post", color=VERMILION, lw=0.9,
                  label="of the orbit of the scene found")
    axes.set(xlabel=f"time {TIME}", ylabel=SPIN, xlim=(begin, end))
    legend_inside(axes)


def _title(record):
    film, fit = record.attributes("film"), record.attributes("fit")
    return (f"{int(film['frames']):,} frames on {int(film['arcs']):,} arcs; {int(fit['impacts']):,} of {int(film['kinks']):,} kinks "
            f"are fitted\nnoise {film['place_noise']:.2g} $R_c$ of a place, {film['angle_noise']:.2g} rad of an angle")


def draw_into(figure, record, look):
    if fall_arcs.are_falls(record):
        return fall_arcs.draw_into(figure, record, look)
    narrow = width_of(figure) < NARROW
    if narrow:
        path, places, spin = figure.subplots(3, 1, height_ratios=[1.3, 1, 1])
    else:
        panels = figure.subplot_mosaic([["path", "places"], ["spin", "spin"]])
        path, places, spin = panels["path"], panels["places"], panels["spin"]
    near = _range(record, look, _ARCS_OF_PATH)
    _draw_path(path, record, *near)
    _draw_places(places, record, *near)
    _draw_spin(spin, record, *_range(record, look, _ARCS_OF_SPIN))
    look.title(figure, _title(record))
    return [spin]
