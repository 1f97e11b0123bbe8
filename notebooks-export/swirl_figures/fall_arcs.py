"""Falls on a plate as a fit has them: height and angle of some of them, measured and on the arcs, with the impacts between these."""

import numpy

from .legends import legend_inside
from .look import NARROW, width_of
from .ranges import inside, require
from .style import BLACK, GREY, VERMILION

#: Falls side by side; a narrow figure has one.
_FALLS = 3
_POINTS = 25


def are_falls(record):
    return record.has("arcs", "vx") and record.has("frames", "fall")


def _shown(record, most):
    """Falls with the most impacts that are used, in their order."""
    used = record.column("kinks", "fall")[record.column("kinks", "use") == "used"].astype(int)
    counts = numpy.bincount(used, minlength=int(record.column("frames", "fall").max()) + 1)
    return sorted(numpy.argsort(-counts, kind="stable")[:most])


def _moved(tau, drag):
    """What a velocity of 1 moves the body by in that time, and a gravity of 1."""
    if not drag:
        return tau, tau * tau / 2
    eased = -numpy.expm1(-drag * tau) / drag
    return eased, (tau - eased) / drag


def _lines(record, fall, name):
    """(time, place) along the arcs of a fall, broken between them."""
    kept = record.column("arcs", "fall") == fall
    start, end, middle = (record.column("arcs", of)[kept][:, None] for of in ("start", "end", "time"))
    place = record.column("arcs", name)[kept][:, None]
    velocity = record.column("arcs", "S" if name == "angle" else f"v{name}")[kept][:, None]
    falls = record.attributes("falls")
    times = start + (end - start) * numpy.append(numpy.linspace(0, 1, _POINTS), 1)
    moved, fallen = _moved(times - middle, falls["arcs_spin_drag" if name == "angle" else "arcs_drag"])
    places = place + velocity * moved
    if name == "y":
        places = places + falls["gravity"][1] * fallen
    places[:, -1] = numpy.nan
    return times.ravel(), places.ravel()


def _measured(record, fall, name):
    kept = record.column("frames", "fall") == fall
    time, values = record.column("frames", "time")[kept], record.column("frames", name)[kept]
    if name == "angle":
        values = _on_branch(values, *_lines(record, fall, name), time)
    return time, values


def _on_branch(values, line_times, line, times):
    """Arcs count the turns; frames may not: each is within half a turn of the arc beside it."""
    known = numpy.isfinite(line)
    if not known.any():
        return values
    beside = numpy.interp(times, line_times[known], line[known])
    return values + 2 * numpy.pi * numpy.round((beside - values) / (2 * numpy.pi))


def _draw(axes, record, fall, name, look):
    time, values = _measured(record, fall, name)
    axes.plot(time, values, ".", color=BLACK, ms=2.5, label="frames")
    axes.plot(*_lines(record, fall, name), color=VERMILION, lw=0.9, label="free arcs")
    kinks, uses = record.column("kinks", "fall") == fall, record.column("kinks", "use")
    for kept, style, width, label in ((uses == "used", "-", 0.8, "impact used"), (uses != "used", ":", 0.6, "kink left out")):
        for number, at in enumerate(record.column("kinks", "time")[kinks & kept]):
            axes.axvline(at, color=GREY, lw=width, ls=style, zorder=0, label=label if number == 0 else None)
    if look.xlim is not None:
        axes.set_xlim(look.xlim)
        seen = values[inside(time, look.xlim)]
        if seen.size:
            axes.set_ylim(seen.min() - 0.1 * numpy.ptp(seen), seen.max() + 0.1 * numpy.ptp(seen))


def _title(record):
    falls, fit = record.attributes("falls"), record.attributes("fit")
    return (f"{int(falls['falls']):,} falls, {int(falls['frames']):,} frames on {int(falls['arcs']):,} arcs; {int(fit['impacts']):,} of "
            f"{int(falls['kinks']):,} kinks are fitted\nnoise {falls['place_noise']:.2g} of a place, {falls['angle_noise']:.2g} rad of an angle")


def draw_into(figure, record, look):
    times = record.column("frames", "time")
    require(inside(times, look.xlim).any(), look, record, "frame", times)
    shown = _shown(record, _FALLS if width_of(figure) >= NARROW else 1)
    panels = figure.subplots(2, len(shown), sharex="col", squeeze=False)
    for column, fall in enumerate(shown):
        height, angle = panels[:, column]
        _draw(height, record, fall, "y", look)
        _draw(angle, record, fall, "angle", look)
        height.set_title(f"fall {fall + 1}")
        angle.set_xlabel("time from the first frame")
    panels[0, 0].set_ylabel("height $y$ of the centre")
    panels[1, 0].set_ylabel("angle, in radians")
    legend_inside(panels[0, 0])
    look.title(figure, _title(record))
    return [panels[0, 0]]
