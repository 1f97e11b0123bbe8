"""The energy of the body, E_p = ½ m v² + ½ I ω_p², in the laboratory (Sun 2019): constant in flight, changed by impacts."""

import numpy

from .flights import flights_of
from .legends import LegendBelow
from .ranges import inside, part, require
from .spin import MOST_STEPS
from .style import BLUE, MANY_POINTS, VERMILION
from .symbols import TIME, number, scene_title
from .thinning import thinned

KINETIC_ENERGY = r"energy $E_p/(m R_c^2 \omega_s^2)$"


def energy_of(record):
    """Just after each listed impact, the record's column; of a record that has none from its velocities."""
    if record.has("collisions", "energy"):
        return record.column("collisions", "energy")
    vx, vy, spin = (record.column("collisions", name) for name in ("vx", "vy", "spin"))
    scene = record.scene()
    return 0.5 * (vx**2 + vy**2 + scene["inertia_factor"] * scene["alpha"] ** 2 * spin**2)


def _flight_energy(record, flights):
    scene = record.scene()
    return 0.5 * (flights.vx**2 + flights.vy**2 + scene["inertia_factor"] * scene["alpha"] ** 2 * flights.spin**2)


def _draw_mean(axes, record, look):
    """Over the time of the flights that are listed, since the first."""
    flights = flights_of(record)
    since = numpy.cumsum(flights.end - flights.begin)
    mean = numpy.cumsum(_flight_energy(record, flights) * (flights.end - flights.begin)) / numpy.where(since > 0, since, 1)
    shown, seen = part(flights.end, look.xlim), mean[inside(flights.end, look.xlim)]
    last = f", at {'its end' if look.xlim else 'last'} {number(seen[-1])}" if len(seen) else ""
    axes.plot(*thinned(flights.end[shown], mean[shown]), color=VERMILION, lw=1.3, label=f"running mean over the flights{last}")


def size(record, look):
    return look.width or 7.5, 4.2


def draw_into(figure, record, look):
    t, energy = record.column("collisions", "t"), energy_of(record)
    shown, seen = part(t, look.xlim), inside(t, look.xlim)
    require(seen.any(), look, record, "impact", t)
    look.title(figure, scene_title(record.scene()))
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    if seen.sum() <= MOST_STEPS:
        axes.step(t[shown], energy[shown], where="post", color=BLUE, lw=1.1, label="just after each impact, until the next")
    else:
        dots = {"rasterized": True} if seen.sum() > MANY_POINTS else {}
        axes.scatter(t[seen], energy[seen], s=float(numpy.clip(4000 / seen.sum(), 0.3, 7)), lw=0, color=BLUE, label="just after each impact",
                     **dots)
    _draw_mean(axes, record, look)
    axes.margins(x=0.01)
    axes.set(xlabel=f"time {TIME}", ylabel=KINETIC_ENERGY, title=f"{seen.sum():,} impacts")
    parts.fill(axes.get_legend_handles_labels()[0], look)
    return [axes]
