"""Contact of a polygon over a floor with dry friction, from Newton's equations in the container's frame, with the wall's
forces as what keeps the constraints: a vertex that touches stays on the wall, and slips with f = -s mu lambda or does not
slip; of an edge both do. The floor's friction is that of dry.py, by quadrature; the equations are solved by extrapolation.

An entry of dry_wall.json is one motion of a `vertex` or an `edge`: from `start` (psi, chi, ut, S at t = 0, of the edge's
clockwise vertex) until its event, or for `duration`; `end` is the time and these four then.
"""

import numpy
from mpmath import mpf

import dry
from dry_contact import with_end
from dynamics import scene_of

number = dry.number


class PolygonMotion:
    """sense: 1 and -1 slip along and against the tangent, 0 does not slip."""

    def __init__(self, entry):
        self.scene, self.floor = dry.in_numbers(scene_of(entry)), dry.Floor(entry)
        self.mu, self.sense = number(mpf(entry["mu"])), entry["sense"]
        self.touching = (0, 1) if entry["support"] == "edge" else (0,)
        psi, chi, ut, spin = (number(mpf(value)) for value in entry["start"])
        self.in_line = self.floor.carries and (len(self.touching) == 2 or bool(self.mu and not self.sense))
        self.heading = 1 if spin >= 0 else -1
        n = numpy.exp(1j * psi)
        r = self.scene.alpha * n * numpy.exp(1j * chi)
        self.start = numpy.array([n - r, 1j * n * ut - 1j * spin * r, psi + chi, spin], dtype=numpy.clongdouble)

    def arm(self, y, vertex):
        return self.scene.alpha * numpy.exp(1j * (y[2].real + 2 * dry.PI * vertex / self.scene.sides))

    def push(self, t, y):
        """The floor's force on the centre and its torque."""
        x, v, angle, spin = y
        slip, spin = (v if self.floor.carries else v + 1j * dry.swirl(self.scene, t)), spin.real
        if self.in_line:  # about one point, one way; what it does beyond is not asked
            spin = number(self.heading)
            slip = spin * 1j * (x if len(self.touching) == 2 else -self.arm(y, 0))
        direction, moment = dry.means(self.scene, slip, spin, angle.real)
        return -self.floor.a * direction, -self.floor.a * moment

    def contact(self, y, vertex):
        """r, n and the velocity of a vertex that touches."""
        r = self.arm(y, vertex)
        p = y[0] + r
        return r, p / abs(p), y[1] + 1j * y[3].real * r

    def forces(self, t, y):
        """lambda and f at each vertex that touches, and the accelerations of the centre and of S with them."""
        o, spin = dry.swirl(self.scene, t), y[3].real
        push, torque = self.push(t, y)
        contacts = [self.contact(y, vertex) for vertex in self.touching]
        sticks = self.mu and not self.sense
        parts = []  # (contact, force per unit)
        for index, (_, n, _) in enumerate(contacts):
            parts += [(index, -n), (index, 1j * n)] if sticks else [(index, n * (-1 - 1j * self.sense * self.mu))]

        def accelerations(sizes):
            a, turning = o + push, torque
            for size, (index, force) in zip(sizes, parts):
                a, turning = a + size * force, turning + size * (contacts[index][0].conjugate() * force).imag
            return a, turning / self.scene.inertia

        def misses(sizes):
            """How the vertices would leave the wall, and how a slip would begin."""
            a, turning = accelerations(sizes)
            found = []
            for r, n, u in contacts:
                at = a + 1j * turning * r - spin ** 2 * r
                found.append((n.conjugate() * at).real + abs(u) ** 2)
                if sticks:
                    found.append((n.conjugate() * at).imag)
            return found

        count = len(parts)
        none = misses([number(0)] * count)
        columns = [[a - b for a, b in zip(misses([number(int(i == k)) for i in range(count)]), none)] for k in range(count)]
        if count == 1:
            sizes = [-none[0] / columns[0][0]]
        else:
            (a, c), (b, d) = columns
            det = a * d - b * c
            sizes = [(-none[0] * d + b * none[1]) / det, (-a * none[1] + none[0] * c) / det]
        if sticks:
            return [sizes[0]], [sizes[1]], *accelerations(sizes)
        return sizes, [-self.sense * self.mu * size for size in sizes], *accelerations(sizes)

    def rates(self, t, y):
        _, _, a, turning = self.forces(t, y)
        return numpy.array([y[1], a, y[3], turning])

    def slip(self, y):
        _, n, u = self.contact(y, 0)
        return (n.conjugate() * u).imag

    def conditions(self, t, y):
        """Each ends the motion where it falls below zero."""
        normal, friction = self.forces(t, y)[:2]
        found = {}
        if len(self.touching) == 2:
            found["first lift"], found["second lift"] = normal
        else:
            found["release"] = normal[0]
            found["strike"] = min(1 - abs(y[0] + self.arm(y, side)) for side in (1, -1))
        if self.in_line:
            found["rest"] = self.heading * y[3].real
        elif self.sense and self.mu:
            found["stick"] = self.sense * self.slip(y)
        if self.mu and not self.sense:
            found["slip"] = self.mu * normal[0] - abs(friction[0])
        return found

    def state(self, t, y):
        r, n, _ = self.contact(y, 0)
        return [numpy.angle(n * numpy.exp(-1j * t)), numpy.angle(r / n), self.slip(y), y[3].real]


def polygon_contact_over_dry_floor(entry, text):
    return with_end(entry, PolygonMotion(entry), text)
