"""The centre's path of a simulate record in three frames: laboratory, container, co-rotating with the swirl."""

import numpy
from matplotlib import rcParams
from matplotlib.collections import LineCollection
from matplotlib.colors import Normalize
from matplotlib.patches import Circle, Polygon
from matplotlib.ticker import MaxNLocator

from .flights import flights_of
from .look import NARROW, is_narrow, side_by_side, width_of
from .outline import outline
from .style import BLACK, TIMES, VERMILION
from .symbols import TIME, scene_title
from .words import broken

#: More flights than these only blacken the panels: the last are drawn.
MOST_FLIGHTS = 300
MOST_CORNERS = 200

_STEP = 0.1           # in radians of the swirl, between points of a curve: its chords leave it by 0.1 % of the container
_MOST_POINTS = 5_000  # of one flight


def _laboratory(x, y, t, beta):
    return x, y


def _container(x, y, t, beta):
    return x - beta * numpy.cos(t), y - beta * numpy.sin(t)


def _corotating(x, y, t, beta):
    return x * numpy.cos(t) + y * numpy.sin(t), y * numpy.cos(t) - x * numpy.sin(t)


FRAMES = {
    "Laboratory": _laboratory,
    "Container (not turning)": _container,
    "Co-rotating with the swirl": _corotating,
}


def sample(flights):
    """[(t, x, y)] along each flight, straight in the laboratory and dense enough for the frames that turn."""
    curves = []
    for begin, end, x, y, vx, vy in zip(flights.begin, flights.end, flights.x, flights.y, flights.vx, flights.vy):
        count = int(min(2 + (end - begin) / _STEP, _MOST_POINTS))
        t = numpy.linspace(begin, end, count)
        curves.append((t, x + vx * (t - end), y + vy * (t - end)))
    return curves


def stays(record):
    """[(t, x, y)] of each stay on the wall, from the record's samples (simulate --sample); none without these."""
    if "samples" not in record:
        return []
    t, x, y, on_wall = (record.column("samples", name) for name in ("t", "x", "y", "in_contact"))
    borders = numpy.flatnonzero(numpy.diff(on_wall.astype(int))) + 1
    parts = numpy.split(numpy.arange(len(t)), borders)
    return [(t[part], x[part], y[part]) for part in parts if len(part) > 1 and on_wall[part[0]]]


def _draw_container(axes, name, t, beta):
    """The container's circle at time t, the swirl's centre, and the circle on which the container's centre runs."""
    centre = FRAMES[name](beta * numpy.cos(t), beta * numpy.sin(t), t, beta)
    axes.add_patch(Circle(centre, 1, fill=False, ec=BLACK, lw=1.3, zorder=3))
    reach = 1.03
    if name == "Laboratory":
        axes.add_patch(Circle((0, 0), beta, fill=False, ec=BLACK, lw=0.8, ls=(0, (4, 3)), zorder=3))
        reach += beta
        centre = (0, 0)
    if name != "Container (not turning)":
        axes.plot(0, 0, "+", color=BLACK, ms=7, mew=1.2, zorder=3)
    axes.set_xlim(centre[0] - reach, centre[0] + reach)
    axes.set_ylim(centre[1] - reach, centre[1] + reach)


def _draw_body(axes, name, record):
    """The body's outline at the last impact."""
    scene = record.scene()
    t, x, y, angle = (record.column("collisions", c)[-1] for c in ("t", "x", "y", "angle"))
    beta, alpha = scene["beta"], scene["alpha"]
    style = {"fc": "none", "ec": VERMILION, "lw": 1.2, "zorder": 3}
    if scene["sides"] == "disk" or scene["sides"] > MOST_CORNERS:
        axes.add_patch(Circle(FRAMES[name](x, y, t, beta), alpha, **style))
        return
    edge = outline(scene, angle)
    axes.add_patch(Polygon(numpy.column_stack(FRAMES[name](x + edge.real, y + edge.imag, t, beta)), **style))


def _title(flights, record):
    shown = min(len(flights), MOST_FLIGHTS)
    which = "the last {0:,} of {1:,} flights" if shown < len(flights) else "{0:,} flight" + "s" * (shown > 1)
    text = f"Path of the centre, {which.format(shown, len(flights))}"
    if stays(record):
        text += "; thick: on the wall"
    elif not flights.last(shown).follows().all():
        text += "; gaps where the record lists no flight"
    return text


def draw_path_into(figure, panels, record):
    """Three panels, the colour of a flight telling its time."""
    flights = flights_of(record)
    shown = flights.last(MOST_FLIGHTS)
    beta = record.scene()["beta"]
    curves = sample(shown)
    walls = [(t, x, y) for t, x, y in stays(record) if t[-1] >= shown.begin[0]]
    ends = numpy.array([t[-1] for t, _, _ in walls])
    times = Normalize(shown.begin[0], max([shown.end[-1], *ends]))

    def lines_of(some, into, array, width):
        return LineCollection([numpy.column_stack(into(x, y, t, beta)) for t, x, y in some], cmap=TIMES,
                              norm=times, array=array, linewidths=width, capstyle="round")

    straight = [tuple(values[[0, -1]] for values in curve) for curve in curves]
    for axes, (name, into) in zip(panels, FRAMES.items()):
        lines = lines_of(straight if into is _laboratory else curves, into, shown.end, 0.8)
        axes.add_collection(lines)
        axes.add_collection(lines_of(walls, into, ends, 2))
        axes.set_aspect("equal")
        axes.set(title=name, xlabel=r"$x/R_c$")
        for axis in (axes.xaxis, axes.yaxis):
            axis.set_major_locator(MaxNLocator(5 if width_of(figure) > 9 or is_narrow(figure) else 3, steps=(1, 2, 5, 10)))
        _draw_container(axes, name, shown.end[-1], beta)
        _draw_body(axes, name, record)
    for axes in panels if is_narrow(figure) else panels[:1]:
        axes.set_ylabel(r"$y/R_c$")
    place = {"location": "bottom", "aspect": 40} if is_narrow(figure) else {"shrink": 0.75, "aspect": 25}
    bar = figure.colorbar(lines, ax=panels, label=f"time {TIME}", pad=0.01, **place)
    bar.ax.ticklabel_format(useOffset=False, style="plain")
    return _title(flights, record)


#: What the lines are that no axis names.
CAPTION = ("black: the container, red: the body, both at the last impact;  +: the swirl's centre;  "
           "dashed: the circle on which the container's centre runs;  thick: on the wall")

def panels_of(figure):
    return side_by_side(figure, len(FRAMES), NARROW if is_narrow(figure) else NARROW / len(FRAMES))


def write_caption(figure):
    longest = max(30, int(72 * width_of(figure) / (0.5 * 8 / 9 * rcParams["font.size"])))
    figure.supxlabel(broken(CAPTION, longest), fontsize="small", color="0.25")


def size(record, look):
    width = look.width or 10
    if width < NARROW:
        return width, 1.5 + len(FRAMES) * min(0.85 * width, 2.05)
    return width, 1.2 + 0.27 * width


def draw_into(figure, record, look):
    """The path in the three frames."""
    title = draw_path_into(figure, panels_of(figure), record)
    look.title(figure, f"{scene_title(record.scene())}\n{title}")
    write_caption(figure)
    return []
