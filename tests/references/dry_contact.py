"""Contact of a disk over a floor with dry friction, from Newton's equations in the container's frame, with the wall's force
as what keeps the constraint: the point that touches stays on the wall, and slips with f = -s mu lambda or does not slip.
The floor's friction is that of dry.py, by quadrature; the equations are solved by extrapolation.

An entry of dry_contact.json is one motion: from `start` (psi, ut, S at t = 0, psi = arg n) until its event, or for `duration`;
`end` is the time and these three then.
"""

import numpy
from mpmath import mp, mpf

import dry
from dynamics import scene_of

number = dry.number
TOLERANCE, SHORTEST = 1e-16, 1e-8


class Motion:
    """sense: 1 and -1 slip along and against the tangent, 0 does not slip."""

    def __init__(self, entry):
        self.scene, self.floor = dry.in_numbers(scene_of(entry)), dry.Floor(entry)
        self.mu, self.sense = number(mpf(entry["mu"])), entry["sense"]
        psi, ut, spin = (number(mpf(value)) for value in entry["start"])
        n = numpy.exp(1j * psi)
        along = ut - self.scene.alpha * spin
        self.heading = 1 if along >= 0 else -1
        self.start = numpy.array([(1 - self.scene.alpha) * n, 1j * n * along, spin], dtype=numpy.clongdouble)

    def push(self, t, y):
        """The floor's force on the centre and its torque."""
        x, v, spin = y
        slip, spin = (v if self.floor.carries else v + 1j * dry.swirl(self.scene, t)), spin.real
        if self.floor.carries and not self.sense and self.mu:  # it rolls one way, and what it does beyond is not asked
            slip, spin = self.heading * 1j * x / abs(x), -self.heading / self.scene.alpha
        direction, moment = dry.means(self.scene, slip, spin, number(0))
        return -self.floor.a * direction, -self.floor.a * moment

    def force(self, t, y):
        """-lambda + i f in units of n, and the accelerations of the centre and of S with it."""
        x, v, _ = y
        n, o = x / abs(x), dry.swirl(self.scene, t)
        push, torque = self.push(t, y)

        def accelerations(force):
            return o + push + force * n, (torque + self.scene.alpha * force.imag) / self.scene.inertia

        def misses(force):
            """How the disk would leave the wall, and how its slip would change."""
            a, turning = accelerations(force)
            return ((x.conjugate() * a).real + abs(v) ** 2, (n.conjugate() * a).imag + self.scene.alpha * turning)

        none = misses(numpy.clongdouble(0))
        if self.sense or not self.mu:
            pushed = numpy.clongdouble(complex(-1, 0)) - 1j * self.sense * self.mu
            force = pushed * (-none[0] / (misses(pushed)[0] - none[0]))
        else:
            by_normal = [a - b for a, b in zip(misses(numpy.clongdouble(-1)), none)]
            by_friction = [a - b for a, b in zip(misses(numpy.clongdouble(1j)), none)]
            det = by_normal[0] * by_friction[1] - by_friction[0] * by_normal[1]
            normal = (-none[0] * by_friction[1] + by_friction[0] * none[1]) / det
            friction = (-by_normal[0] * none[1] + by_normal[1] * none[0]) / det
            force = -normal + 1j * friction
        return force, *accelerations(force)

    def rates(self, t, y):
        _, a, turning = self.force(t, y)
        return numpy.array([y[1], a, turning])

    def slip(self, y):
        x, v, spin = y
        return (x.conjugate() * v).imag / abs(x) + self.scene.alpha * spin.real

    def conditions(self, t, y):
        """Each ends the motion where it falls below zero."""
        force = self.force(t, y)[0]
        found = {"release": -force.real}
        if self.sense and self.mu:
            found["stick"] = self.sense * self.slip(y)
        elif not self.sense:
            found["slip"] = self.mu * -force.real - abs(force.imag)
            if self.floor.carries:
                found["rest"] = self.heading * (y[0].conjugate() * y[1]).imag
        return found

    def state(self, t, y):
        psi = numpy.angle(y[0] * numpy.exp(-1j * t))
        return [psi, self.slip(y), y[2].real]


def followed(motion, duration):
    """The event, the time and the state at the end: at the first event, or after `duration`."""
    t, y, longest = number(0), motion.start, number(dry.MACRO)
    while t < duration:
        h = min(longest, duration - t)
        after, error = dry.extrapolated_with_error(motion.rates, t, y, h)
        if error > TOLERANCE and h > SHORTEST:  # where |U| = alpha |S| on a slip the means have no derivative
            longest = h / 2
            continue
        longest = min(2 * h, number(dry.MACRO))
        failed = [name for name, value in motion.conditions(t + h, after).items() if value < 0]
        if not failed:
            t, y = t + h, after
            continue
        times = {}
        for name in failed:
            value = lambda part: motion.conditions(t + part, dry.extrapolated(motion.rates, t, y, part) if part else y)[name]
            times[name] = dry.zero_between(value, number(0), h)
        event = min(times, key=times.get)
        return event, t + times[event], dry.extrapolated(motion.rates, t, y, times[event])
    return "horizon", t, y


def contact_motion_over_dry_floor(entry, text):
    return with_end(entry, Motion(entry), text)


def with_end(entry, motion, text):
    """The entry with `event` and `end` computed anew."""
    event, t, y = followed(motion, number(mpf(entry["duration"])))
    values = [t, *motion.state(t, y)]
    shown = [mpf(numpy.format_float_scientific(value, 25)) if abs(value) > 1e-15 else mpf(0) for value in values]
    return {**entry, "event": event, "end": [text(value, dry.DIGITS) for value in shown]}
