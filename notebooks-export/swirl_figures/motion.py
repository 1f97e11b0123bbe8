"""Where the body is and how it turns at any time that a record tells: between the impacts of an orbit, on the wall where it
has samples, and along a fixed point or cycle of a record of orbits."""

from dataclasses import dataclass

import numpy

from .flights import flights_of
from .record import RecordError


@dataclass
class Pieces:
    """Uniform motions that follow one another, perhaps with gaps: centre in the laboratory and angle of vertex 0 at their
    ends, velocity and S during them."""
    begin: numpy.ndarray
    end: numpy.ndarray
    x: numpy.ndarray
    y: numpy.ndarray
    vx: numpy.ndarray
    vy: numpy.ndarray
    angle: numpy.ndarray
    spin: numpy.ndarray

    def at(self, times):
        """x, y, angle, S at the times; NaN in a gap."""
        piece = numpy.clip(numpy.searchsorted(self.end, times), 0, len(self.end) - 1)
        before = times - self.end[piece]
        slack = 1e-9 * (1 + abs(times))
        known = (times >= self.begin[piece] - slack) & (before <= slack)
        values = (self.x[piece] + self.vx[piece] * before, self.y[piece] + self.vy[piece] * before,
                  self.angle[piece] + self.spin[piece] * before, self.spin[piece])
        return [numpy.where(known, value, numpy.nan) for value in values]


@dataclass
class Motion:
    """`at(times)` gives x, y (laboratory), angle, S; times from `first` to `last`."""
    at: object
    first: float
    last: float
    what: str = None  #: which cycle it is


def motion_of(record, orbit=None):
    """Of a record of `simulate`, or of one of the orbits of a record of `orbits`, from 1, the first if None."""
    if "collisions" in record:
        if orbit is not None:
            raise RecordError(f"orbit = {orbit}: record '{record.path}' is of one orbit, that of swirl {record.command}")
        return _motion_of_simulate(record)
    if "orbits" in record:
        return _motion_of_cycle(record, 1 if orbit is None else orbit)
    raise RecordError(f"record '{record.path}' holds no orbit to be shown in motion; records of simulate and orbits do")


def _motion_of_simulate(record):
    flights = flights_of(record)
    pieces = Pieces(flights.begin, flights.end, flights.x, flights.y, flights.vx, flights.vy,
                    record.column("collisions", "angle"), flights.spin)
    if "samples" not in record or len(record.column("samples", "t")) < 2:
        return Motion(pieces.at, float(flights.begin[0]), float(flights.end[-1]))
    return Motion(_with_samples(record, pieces), float(min(flights.begin[0], record.column("samples", "t")[0])),
                  float(max(flights.end[-1], record.column("samples", "t")[-1])))


def _with_samples(record, pieces):
    """On the wall between two samples: both in contact, so close that the motion between is straight in the axes that turn
    with the swirl."""
    t, x, y, angle, spin = (record.column("samples", name) for name in ("t", "x", "y", "angle", "spin"))
    turned = (x + 1j * y) * numpy.exp(-1j * t)
    ends = pieces.end[-1]

    def at(times):
        values = pieces.at(times)
        between = (times >= t[0]) & (times <= t[-1])
        missing = numpy.isnan(values[0]) & between | (times > ends) & between
        place = (numpy.interp(times, t, turned.real) + 1j * numpy.interp(times, t, turned.imag)) * numpy.exp(1j * times)
        sampled = (place.real, place.imag, numpy.interp(times, t, angle), numpy.interp(times, t, spin))
        return [numpy.where(missing, b, a) for a, b in zip(values, sampled)]
    return at


def _motion_of_cycle(record, number):
    record.require_straight_flights()
    count, orbit = record.size("orbits", "period"), number - 1
    if not 1 <= number <= count:
        raise RecordError(f"orbit = {number}: record '{record.path}' holds the orbits 1 to {count}")
    scene, names = record.scene(), [str(name) for name in record.names("orbits", "coordinate")]
    period = int(record.column("orbits", "period")[orbit])
    points = dict(zip(names, record.column("orbits", "points")[orbit, :period].T))
    return_time = float(record.column("orbits", "return_time")[orbit])
    pieces = _flights_of_cycle(points, scene, return_time)
    if pieces is None:
        raise RecordError(f"orbit = {number} of record '{record.path}' is no cycle of flights alone: it leads through "
                          "contact, and a record of simulate --sample shows that")
    return _repeated(pieces, return_time, _cycle_in_words(record, orbit, period))


def _cycle_in_words(record, orbit, period):
    kind = "fixed point" if period == 1 else f"cycle of period {period}"
    return f"orbit {orbit + 1}: {kind}, {record.names('orbits', 'stability')[orbit]}"


#: Points that are joined by a flight meet to this, in R_c; a record's points are polished to rounding.
_MEETS = 1e-6


def _flight_time(start, velocity, target, total):
    """τ of the flight from `start` with `velocity`, places as complex numbers in axes that turn with the swirl, at whose
    end the body is at `target` in the axes turned by τ: |start + velocity τ| = |target|, and the directions agree."""
    a, b = abs(velocity) ** 2, (start * velocity.conjugate()).real
    c = abs(start) ** 2 - abs(target) ** 2
    root = numpy.sqrt(max(b * b - a * c, 0.0))
    candidates = [tau for tau in ((-b + root) / a, (-b - root) / a) if 1e-12 < tau <= total * (1 + 1e-9)] if a > 0 else []
    errors = [abs(start + velocity * tau - target * numpy.exp(1j * tau)) for tau in candidates]
    return candidates[int(numpy.argmin(errors))] if errors and min(errors) < _MEETS else None


def _flights_of_cycle(points, scene, return_time):
    """One period; None where a pair of points is not joined by a flight."""
    psi, chi = points["psi"], points.get("chi", numpy.zeros_like(points["psi"]))
    alpha, beta = scene["alpha"], scene["beta"]
    corner = scene.get("corner", 0)
    place = beta + (1 - corner) * numpy.exp(1j * psi) - (alpha - corner) * numpy.exp(1j * (psi + chi))
    velocity = numpy.exp(1j * psi) * (points["vn"] + 1j * points["vt"])
    if len(psi) == 1:  # the time is known, also where the body does not move in these axes
        times = [return_time]
        if abs(place[0] + velocity[0] * return_time - place[0] * numpy.exp(1j * return_time)) > _MEETS:
            return None
    else:
        times = [_flight_time(place[i], velocity[i], place[(i + 1) % len(psi)], return_time) for i in range(len(psi))]
        if None in times or abs(sum(times) - return_time) > _MEETS * (1 + return_time):
            return None
    begin = numpy.concatenate([[0], numpy.cumsum(times)[:-1]])
    end, turn = numpy.cumsum(times), numpy.exp(1j * begin)
    goes = velocity * turn
    stops = place * turn + goes * times
    angle = psi[0] + chi[0] + numpy.cumsum(points["S"] * times)
    return Pieces(begin, end, stops.real, stops.imag, goes.real, goes.imag, angle, points["S"])


#: A cycle is shown for two turns of the swirl at least, in whole periods.
_LEAST_SHOWN = 4 * numpy.pi


def _repeated(pieces, return_time, what):
    """Period after period: all has turned with the swirl by the return time."""
    count = max(1, int(numpy.ceil(_LEAST_SHOWN / return_time)))

    def at(times):
        number = numpy.clip(numpy.floor(times / return_time), 0, count - 1)
        x, y, angle, spin = pieces.at(times - number * return_time)
        place = (x + 1j * y) * numpy.exp(1j * number * return_time)
        return [place.real, place.imag, angle + number * (pieces.angle[-1] - _first_angle(pieces)), spin]
    return Motion(at, 0.0, count * return_time, what)


def _first_angle(pieces):
    return pieces.angle[0] - pieces.spin[0] * (pieces.end[0] - pieces.begin[0])
