"""Contact over a floor that drags, from Newton's equations in the laboratory, with the wall's force as what keeps the
constraint: the point that touches stays on the wall, and slips with f = -s mu lambda or does not slip. No axes of the
contact, no angles of it: two linear equations for the force at each moment, and Taylor's method.

An entry of dragged_contact.json is one motion: from `start` (psi, chi, ut, S at t = 0, psi = arg n) until its event, or for
`duration`; `end` is the time and these four then. With `impacts` it is a landing: the disk bounces from `start` (just after an
impact, un = -v) until its impacts have died out, and moves on the wall from there.
"""

from mpmath import mp, mpc, mpf

import dragged
from dynamics import State, scene_of

#: Impacts are followed until they leave at so little; what is left moves the body by its square.
SILENT = mpf(10) ** -10
DIGITS = 15


class Motion:
    """sense: 1 and -1 slip along and against the tangent, 0 does not slip."""

    def __init__(self, scene, floor, sense):
        self.scene, self.floor, self.sense = scene, floor, sense
        self.inertia = scene.inertia

    def seen(self, y):
        x, v = mpc(y[0], y[1]), mpc(y[2], y[3])
        if not self.scene.sides:
            n = x / abs(x)
            return x, v, n, self.scene.alpha * n
        arm = self.scene.alpha * mp.expj(y[4])
        return x, v, x + arm, arm

    def accelerations(self, t, y, force):
        """Of the centre in the container's frame, and of S; force = -lambda + i f, in units of n."""
        x, v, n, arm = self.seen(y)
        o = self.scene.beta * mp.expj(t)
        floor_velocity = 1j * o if self.floor.kind == "dish" else 0
        a = -self.floor.drag * (v + 1j * o - floor_velocity) + o + force * n
        torque = (arm.conjugate() * (force * n)).imag
        return a, torque / self.inertia - self.floor.spin_drag * y[5]

    def misses(self, t, y, force):
        """How the point that touches would leave the wall, and how its slip would change."""
        x, v, n, arm = self.seen(y)
        a, turning = self.accelerations(t, y, force)
        if not self.scene.sides:
            return (x.conjugate() * a).real + abs(v) ** 2, (n.conjugate() * a).imag + self.scene.alpha * turning
        rate = v + 1j * y[5] * arm
        accelerates = a + (1j * turning - y[5] ** 2) * arm
        return (n.conjugate() * accelerates).real + abs(rate) ** 2, (n.conjugate() * accelerates).imag

    def force(self, t, y):
        none = self.misses(t, y, mpc(0))
        if self.sense or not self.scene.mu:
            pushed = mpc(-1, -self.sense * self.scene.mu)
            per = self.misses(t, y, pushed)[0] - none[0]
            return pushed * (-none[0] / per)
        by_normal, by_friction = self.misses(t, y, mpc(-1)), self.misses(t, y, mpc(0, 1))
        a, b = by_normal[0] - none[0], by_friction[0] - none[0]
        c, d = by_normal[1] - none[1], by_friction[1] - none[1]
        det = a * d - b * c
        normal, friction = (-none[0] * d + b * none[1]) / det, (-a * none[1] + c * none[0]) / det
        return mpc(-normal, friction)

    def slip(self, y):
        x, v, n, arm = self.seen(y)
        return (n.conjugate() * (v + 1j * y[5] * arm)).imag

    def vanishing(self, event, t, y):
        if event == "stick":
            return self.slip(y)
        force = self.force(t, y)
        return -force.real if event == "release" else self.scene.mu * -force.real - abs(force.imag)

    def rates(self, t, y):
        a, turning = self.accelerations(t, y, self.force(t, y))
        return [y[2], y[3], a.real, a.imag, y[5], turning]

    def begin(self, psi, chi, ut, spin):
        """t = 0; the slip is that of the point that touches."""
        n = mp.expj(psi)
        if not self.scene.sides:
            x, v, angle = (1 - self.scene.alpha) * n, 1j * n * (ut - self.scene.alpha * spin), mpf(0)
        else:
            arm, angle = self.scene.alpha * n * mp.expj(chi), psi + chi
            x, v = n - arm, 1j * n * ut - 1j * spin * arm
        return [x.real, x.imag, v.real, v.imag, angle, spin]

    def state(self, t, y):
        x, v, n, arm = self.seen(y)
        psi, chi = mp.arg(n * mp.expj(-t)), mp.arg(arm / n)
        return [psi, chi, self.slip(y), y[5]]


def followed(motion, at, y, event, duration):
    """The time and the state at the end: that of the event, or of `duration`."""
    solution = mp.odefun(motion.rates, at, y)
    if event == "horizon":
        end = at + duration
    else:
        step, end = mpf(1) / 16, at
        sign = mp.sign(motion.vanishing(event, at + step / 8, solution(at + step / 8)))
        while mp.sign(motion.vanishing(event, end + step, solution(end + step))) == sign:
            end += step
            if end > at + 8:
                raise ArithmeticError(f"no {event} comes")
        end = mp.findroot(lambda t: motion.vanishing(event, t, solution(t)), (end, end + step), solver="anderson")
    return end, solution(end)


def landed(scene, floor, start):
    """When impacts have died out, and the disk then: all of its last normal velocity gone."""
    psi, chi, ut, spin, leaving = start
    n = mp.expj(psi)
    v = n * mpc(-leaving, ut - scene.alpha * spin) + 1j * scene.beta
    state = State(mpf(0), scene.beta + (1 - scene.alpha) * n, v, mpf(0), spin)
    while True:
        state = dragged.next_impact(scene, floor, state, 0).after
        o = scene.beta * mp.expj(state.t)
        x, v = state.x - o, state.v - 1j * o
        n = x / abs(x)
        if -(n.conjugate() * v).real < SILENT:
            v = 1j * n * (n.conjugate() * v).imag
            return state.t, [x.real, x.imag, v.real, v.imag, mpf(0), state.spin]


def shown(value):
    """What is zero but for rounding is 0."""
    return mp.nstr(value, DIGITS) if abs(value) > mpf(10) ** -15 else "0"


def contact_motion_over_floor(entry):
    """The entry with `end` computed anew."""
    with mp.workdps(20):
        return {**entry, "end": [shown(number) for number in end_of(entry)]}


def end_of(entry):
    scene, floor = scene_of(entry), dragged.floor_of(entry)
    motion = Motion(scene, floor, entry["sense"])
    start = [mpf(number) for number in entry["start"]]
    if entry.get("impacts"):
        with mp.workdps(50):  # the search for impacts wants them
            at, y = landed(scene, floor, start)
        if abs(motion.slip(y)) > 1e-10:
            raise ArithmeticError("the disk slips when its impacts have died out")
        end, y = followed(motion, at, y, "horizon", mpf(entry["duration"]) - at)
    else:
        at, y = mpf(0), motion.begin(*start)
        end, y = followed(motion, at, y, entry["event"], mpf(entry["duration"]))
    return [end, *motion.state(end, y)]
