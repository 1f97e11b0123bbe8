"""The flights of a simulate record, by the impacts that end them.

A record lists the state just after each impact, with its impulse (−p n + q t). The state just before follows exactly,
V⁻ = V⁺ + p n − q t and S⁻ = S⁺ − (r_n q + r_t p)/I, so each listed impact gives the straight flight that ends in it,
whatever lies before: also where only every tenth impact is listed, or where the body had been on the wall.
"""

from dataclasses import dataclass

import numpy

from .record import RecordError


@dataclass
class Flights:
    begin: numpy.ndarray  #: time at which each flight begins
    end: numpy.ndarray    #: time of the impact that ends it
    spin: numpy.ndarray   #: S during the flight
    x: numpy.ndarray      #: centre at the end, laboratory
    y: numpy.ndarray
    vx: numpy.ndarray     #: velocity during the flight
    vy: numpy.ndarray

    def __len__(self):
        return len(self.end)

    def last(self, count):
        return self.part(slice(-count, None))

    def part(self, chosen):
        return Flights(*(column[chosen] for column in vars(self).values()))

    def follows(self):
        """Whether each flight but the first begins where the one before it ends."""
        return self.begin[1:] <= self.end[:-1] + 1e-9 * (1 + abs(self.end[:-1]))


def _begins(t, flight_time, contact_ends):
    """After the impact before, or after the last contact in between: flight_time counts both."""
    begin = t - flight_time
    if len(contact_ends) == 0:
        return begin
    before = numpy.searchsorted(contact_ends, t * (1 + 1e-12), side="right") - 1
    released = numpy.where(before >= 0, contact_ends[numpy.maximum(before, 0)], -numpy.inf)
    return numpy.minimum(numpy.maximum(begin, released), t)


def flights_of(record):
    """The flights of all listed impacts."""
    return record.derived(_flights_of)


def _flights_of(record):
    def column(name):
        return record.column("collisions", name)

    t = column("t")
    if len(t) == 0:
        raise RecordError(f"record '{record.path}' lists no impacts: there is nothing to draw")
    record.require_straight_flights()
    scene = record.scene()
    p, q, normal = column("impulse_normal"), column("impulse_tangential"), column("psi") + t
    chi = column("chi") if record.has("collisions", "chi") else numpy.zeros_like(t)
    corner, inertia = scene.get("corner", 0), scene["inertia_factor"] * scene["alpha"] ** 2
    arm = scene["alpha"] - corner
    contact_ends = record.column("contacts", "t_end") if "contacts" in record else numpy.array([])
    return Flights(
        begin=_begins(t, column("flight_time"), contact_ends),
        end=t,
        spin=column("spin") - (arm * (numpy.cos(chi) * q + numpy.sin(chi) * p) + corner * q) / inertia,
        x=column("x"),
        y=column("y"),
        vx=column("vx") + p * numpy.cos(normal) + q * numpy.sin(normal),
        vy=column("vy") + p * numpy.sin(normal) - q * numpy.cos(normal))
