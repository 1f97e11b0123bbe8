"""The multipliers of fixed points and cycles in the complex plane, and which mean spin each orbit has."""

import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Circle
from matplotlib.ticker import MaxNLocator

from .legends import LegendBelow
from .look import NARROW, side_by_side
from .record import RecordError
from .style import BLACK, CYCLE
from .symbols import MEAN_SPIN, number, scene_title

#: Within this modulus the plane is drawn as it is; beyond, moduli are drawn on a logarithmic scale outside the circle.
LINEAR_UP_TO = 2.0


#: How full a marker is; a stability that is not here is drawn as unstable.
_FILLS = {"stable": "full", "neutral": "left", "unstable": "none"}


def _marker(colour, stability):
    return {"ls": "", "marker": "o", "ms": 5, "color": colour, "markerfacecoloralt": "white",
            "fillstyle": _FILLS.get(stability, "none")}


def _radius(modulus, logarithmic):
    """Where a modulus is drawn: |λ| up to 1, then 1 + log10 |λ| where the scale is logarithmic."""
    if not logarithmic:
        return modulus
    return numpy.where(modulus <= 1, modulus, 1 + numpy.log10(numpy.maximum(modulus, 1)))


def _emptiest_direction(multiplier):
    """Of 16 directions the one that is farthest from every multiplier outside the unit circle."""
    taken = numpy.angle(multiplier[abs(multiplier) > 0.9])
    directions = (numpy.arange(16) + 0.5) * numpy.pi / 8
    distance = abs(numpy.angle(numpy.exp(1j * (directions[:, None] - taken))))
    return directions[distance.min(axis=1).argmax()]


def _draw_rings(axes, multiplier):
    """Circles of |λ| = 10, 100, … with their names, in place of axes whose numbers would be no λ."""
    direction = numpy.exp(1j * _emptiest_direction(multiplier))
    for power in range(int(numpy.ceil(numpy.log10(numpy.nanmax(abs(multiplier))))) + 1):
        radius = 1.0 + power
        if power > 0:
            axes.add_patch(Circle((0, 0), radius, fill=False, ec="0.7", lw=0.7, ls=(0, (4, 3)), zorder=0))
        name = ("1", "10")[power] if power < 2 else f"$10^{{{power}}}$"
        axes.text(radius * direction.real, radius * direction.imag, name, size="small", color="0.25", ha="center",
                  va="center", bbox={"fc": "white", "ec": "none", "pad": 0.6}, zorder=1.5)


def _draw_plane(axes, multiplier, logarithmic):
    axes.add_patch(Circle((0, 0), 1, fill=False, ec=BLACK, lw=1.2, zorder=1))
    axes.axhline(0, color="0.85", lw=0.7, zorder=0)
    axes.axvline(0, color="0.85", lw=0.7, zorder=0)
    reach = 1.2 * float(_radius(numpy.nanmax(abs(multiplier), initial=1.0), logarithmic))
    axes.set(xlim=(-reach, reach), ylim=(-reach, reach), aspect="equal", xlabel="Re λ", ylabel="Im λ",
             title="Multipliers λ and the unit circle")
    if logarithmic:
        _draw_rings(axes, multiplier)
        axes.set(xticks=[], yticks=[], title="Multipliers λ: |λ| linear up to 1, logarithmic beyond")


def _colours(period, mean_spin):
    """A colour for each orbit, or of many orbits for each period; and its name in the legend."""
    if len(period) <= len(CYCLE):
        return list(CYCLE), [f"period {k}, {MEAN_SPIN} = {number(s)}" for k, s in zip(period, mean_spin)]
    periods = list(numpy.unique(period))
    return ([CYCLE[periods.index(k) % len(CYCLE)] for k in period], [f"period {k}" for k in period])


def _handles(colours, names, stability):
    handles = [Line2D([], [], label=name, **_marker(colour, "stable"))
               for name, colour in dict(zip(names, colours)).items()]
    present = [name for name in _FILLS if name in stability] + sorted(set(stability) - set(_FILLS))
    return handles + [Line2D([], [], label=name, **_marker("0.3", name)) for name in present]


def _draw_spins(axes, period):
    axes.set(xlabel="period, in impacts", ylabel=f"mean spin {MEAN_SPIN}", title="The orbits")
    axes.set_xlim(period.min() - 0.5, period.max() + 0.5)
    axes.xaxis.set_major_locator(MaxNLocator(integer=True, min_n_ticks=1))
    axes.margins(y=0.1)


def size(record, look):
    width = look.width or 8.6
    return width, min(5.6, 1.6 + 0.47 * width) if width >= NARROW else 1.6 + 1.75 * width


def draw_into(figure, record, look):
    if record.size("orbits", "period") == 0:
        raise RecordError(f"record '{record.path}' holds no orbits: there is nothing to draw")
    period, mean_spin = record.column("orbits", "period"), record.column("orbits", "mean_S")
    multiplier = record.column("orbits", "multiplier_re") + 1j * record.column("orbits", "multiplier_im")
    stability = record.names("orbits", "stability")
    logarithmic = numpy.nanmax(abs(multiplier), initial=1.0) > LINEAR_UP_TO
    look.title(figure, scene_title(record.scene()))
    colours, names = _colours(period, mean_spin)
    parts = LegendBelow(figure)
    parts.fill(_handles(colours, names, stability), look)
    plane, spins = side_by_side(parts.above, 2, NARROW / 2)
    _draw_plane(plane, multiplier, logarithmic)
    for values, k, s, colour, name in zip(multiplier, period, mean_spin, colours, stability):
        place = _radius(abs(values), logarithmic) * numpy.exp(1j * numpy.angle(values))
        plane.plot(place.real, place.imag, **_marker(colour, name))
        spins.plot(k, s, **_marker(colour, name))
    _draw_spins(spins, period)
    return [spins]
