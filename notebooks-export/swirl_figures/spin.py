"""S(t) of a simulate record, flight by flight, with its running time mean."""

import numpy
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm
from matplotlib.ticker import MaxNLocator

from .cut import tell_cut
from .flights import flights_of
from .legends import legend_inside
from .look import columns_of
from .ranges import inside, overlapping, part, require
from .style import BLUE, MANY_POINTS, ORANGE, VERMILION
from .symbols import SPIN, TIME, number, scene_title
from .thinning import thinned

#: More flights than these are a solid band as steps; then dots show all of them and steps the last.
MOST_STEPS = 300
LAST_STEPS = 100

_POINTS_OF_A_CONTACT = 500


def _flights_in(record, look):
    """Those that the range shows, wholly or in part."""
    flights = flights_of(record)
    if look.xlim is None:
        return flights
    first, last = numpy.searchsorted(flights.end, look.xlim[0]), numpy.searchsorted(flights.begin, look.xlim[1], side="right")
    return flights.part(slice(first, last))


def _steps(flights, record):
    """The polyline of S(t): level in flight, upright at an impact, broken where no flight is listed."""
    impacts = record.column("collisions", "t")
    after = record.column("collisions", "spin")[numpy.searchsorted(impacts, flights.end[-1])]
    t = numpy.column_stack([flights.begin, flights.end]).ravel()
    spin = numpy.repeat(flights.spin, 2)
    breaks = 2 * (1 + numpy.flatnonzero(~flights.follows()))
    t, spin = numpy.insert(t, breaks, numpy.nan), numpy.insert(spin, breaks, numpy.nan)
    return numpy.append(t, flights.end[-1]), numpy.append(spin, after)


def running_mean(record):
    """Times and ∫S dt / T, see _running_mean."""
    return record.derived(_running_mean)


def _running_mean(record):
    """Times and ∫S dt / T since the first listed impact: vertex 0's angle is ∫S dt, through contact too. After the last
    impact it goes on with the means of the pieces of contact."""
    t, angle = record.column("collisions", "t"), record.column("collisions", "angle")
    times, time, turned = [t[1:]], [t[1:] - t[0]], [angle[1:] - angle[0]]
    elapsed, so_far = (t[-1] - t[0], angle[-1] - angle[0]) if len(t) > 1 else (0, 0)
    for start, end, mean in zip(*_contacts(record, after=t[-1])):
        since = numpy.linspace(0, end - start, _POINTS_OF_A_CONTACT)[1:]
        times.append(start + since)
        time.append(elapsed + since)
        turned.append(so_far + mean * since)
        elapsed, so_far = time[-1][-1], turned[-1][-1]
    return numpy.concatenate(times), numpy.concatenate(turned) / numpy.concatenate(time)


def _contacts(record, after=-numpy.inf, xlim=None):
    if "contacts" not in record:
        return numpy.empty((3, 0))
    start, end, mean = (record.column("contacts", name) for name in ("t_start", "t_end", "mean_S"))
    kept = (start >= after) & (end > start) & overlapping(start, end, xlim)
    return start[kept], end[kept], mean[kept]


def spin_on_wall(record, after=-numpy.inf, xlim=None):
    """([(t, S)] through the contact that the record's samples show, simulate --sample; and whether each piece of
    _contacts lies within them)."""
    start, end, _ = _contacts(record, after, xlim)
    curves, shown = [], numpy.zeros(len(start), dtype=bool)
    if "samples" not in record:
        return curves, shown
    t, spin, on_wall = (record.column("samples", name) for name in ("t", "spin", "in_contact"))
    kept = t >= after
    t, spin, on_wall = (values[kept][part(t[kept], xlim)] for values in (t, spin, on_wall))
    if xlim:
        start, end = numpy.clip(start, *xlim), numpy.clip(end, *xlim)
    borders = numpy.flatnonzero(numpy.diff(on_wall.astype(int))) + 1
    for piece in numpy.split(numpy.arange(len(t)), borders):
        if len(piece) < 2 or not on_wall[piece[0]]:
            continue
        curves.append((t[piece], spin[piece]))
        between = t[1] - t[0]  # a piece may begin and end up to a sample beside it
        shown |= (start >= t[piece[0]] - between) & (end <= t[piece[-1]] + between)
    return curves, shown


def _draw_contacts(axes, record, after=-numpy.inf, xlim=None):
    start, end, mean = _contacts(record, after, xlim)
    curves, shown = spin_on_wall(record, after, xlim)
    if curves:
        axes.add_collection(LineCollection([numpy.column_stack(curve) for curve in curves], colors=ORANGE,
                                           linewidths=1.6, label="S on the wall"))
    lines = numpy.stack([numpy.column_stack([start, mean]), numpy.column_stack([end, mean])], axis=1)[~shown]
    if len(lines):
        axes.add_collection(LineCollection(lines, colors=ORANGE, linewidths=2.2,
                                           label="on the wall (mean of each piece)"))


def _last_mean(record, look, seen, means):
    """Of the whole orbit what `simulate` says, also where the panel shows a part; of a range that was asked for its last."""
    if look.xlim:
        return f", at its end {number(seen[-1])}" if len(seen) else ""
    return f", at last {number(record.attributes('result').get('mean_S', means[-1]))}"


def _draw_mean(axes, record, look, after=-numpy.inf, xlim=None):
    times, means = running_mean(record)
    kept = times >= after
    times, means = times[kept], means[kept]
    shown, seen = part(times, xlim), means[inside(times, xlim)]
    if len(times[shown]):
        axes.plot(*thinned(times[shown], means[shown]), color=VERMILION, lw=1.3,
                  label=f"running time mean{_last_mean(record, look, seen, means)}")


def _before_the_long_rest(record, look, begin):
    """(the range of the abscissa from `begin` on, the time until which there is more) A last contact far longer than
    everything before it would squeeze that into a line: it is cut. Where nothing is: (the range that is asked for, None)."""
    struck = record.column("collisions", "t")[-1]
    _, end, _ = _contacts(record, after=struck)
    cut = struck + 0.3 * (struck - begin)
    if look.xlim or len(end) == 0 or end[-1] <= cut or struck <= begin:
        return look.xlim, None
    return (begin - 0.01 * (cut - begin), cut), end[-1]


def _finish(axes, look, title, xlim, end):
    axes.margins(x=0.01)
    axes.autoscale_view()
    axes.set(xlabel=f"time {TIME}", ylabel=SPIN, title=title)
    if end is not None:
        axes.set_xlim(xlim)
        tell_cut(axes, look, title, xlim[1], end)
    if axes.get_xlim()[1] >= 1e5:
        axes.xaxis.set_major_locator(MaxNLocator(4, steps=(1, 2, 5, 10)))
    axes.ticklabel_format(axis="x", useOffset=False, style="plain")
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    legend_inside(axes)


def _how_many(record, look, noun):
    """"600 impacts", or of a range "28 of 600 impacts"."""
    t = record.column("collisions", "t")
    some = f"{inside(t, look.xlim).sum():,} of " if look.xlim else ""
    return f"{some}{len(t):,} {noun}{'s' * (len(t) > 1)}"


def _draw_all(axes, record, look):
    t, spin = record.column("collisions", "t"), record.column("collisions", "spin")
    xlim, end = _before_the_long_rest(record, look, t[0])
    seen = inside(t, xlim)
    t, spin = t[seen], spin[seen]
    many = len(t) > MANY_POINTS
    if many:
        axes.hist2d(t, spin, bins=(300, 150), cmin=1, norm=LogNorm(), cmap="Blues", rasterized=True)
    else:
        axes.scatter(t, spin, s=7 if len(t) < 2000 else 2, color=BLUE, alpha=0.8, lw=0)
    axes.plot([], [], "o", color=BLUE, ms=3.5, mec="none", label="after each impact")
    _draw_contacts(axes, record, xlim=xlim)
    _draw_mean(axes, record, look, xlim=xlim)
    _finish(axes, look, f"Spin, {_how_many(record, look, 'listed impact')}{' (darker: more)' * many}", xlim, end)


def _draw_steps(axes, record, flights, look, title):
    begin = -numpy.inf
    if len(flights):
        begin = flights.begin[0]
        axes.plot(*_steps(flights, record), color=BLUE, lw=1.1, label="S")
    xlim, end = _before_the_long_rest(record, look, begin)
    _draw_contacts(axes, record, begin, xlim)
    _draw_mean(axes, record, look, begin, xlim)
    _finish(axes, look, title, xlim, end)


def _are_steps(flights):
    """False where most flights are missing: an orbit listed with --every."""
    return flights.follows().sum() * 2 >= len(flights) - 1


def spin_panels(record, look):
    """How many panels draw_spin_into wants."""
    flights = _flights_in(record, look)
    return 2 if len(flights) > MOST_STEPS and _are_steps(flights) else 1


def draw_spin_into(panels, record, look):
    flights = _flights_in(record, look)
    require(len(flights) or len(_contacts(record, xlim=look.xlim)[0]), look, record, "impact", flights_of(record).end)
    if len(flights) <= MOST_STEPS and _are_steps(flights):
        _draw_steps(panels[0], record, flights, look, f"Spin, {_how_many(record, look, 'impact')}")
        return
    _draw_all(panels[0], record, look)
    if len(panels) > 1:
        these = "of these " if look.xlim else ""
        _draw_steps(panels[1], record, flights.last(LAST_STEPS), look, f"The last {LAST_STEPS} {these}impacts")


#: Inches of width that a panel needs beside another.
_LEAST_PANEL = 3.2


def columns(record, width, look):
    """In how many columns the panels stand where the figure is `width` wide."""
    return columns_of(width, spin_panels(record, look), _LEAST_PANEL)


def size(record, look):
    return look.width or 7.5, 1.2 + 2.6 * spin_panels(record, look)


def draw_into(figure, record, look):
    """S(t) as steps; of many impacts dots for all and steps for the last."""
    panels = list(figure.subplots(spin_panels(record, look), 1, squeeze=False)[:, 0])
    look.title(figure, scene_title(record.scene()))
    draw_spin_into(panels, record, look)
    return panels[:1]
