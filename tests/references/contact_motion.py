"""A polygon without restitution, e = 0, in a swirled container, through contact on a vertex, in 60-digit arithmetic,
written from the equations of motion (dynamics.py has flight and impact): nothing of chatter is summed.

After an impact a vertex stays on the wall if it would not leave in free flight. On it x = exp(i nu), with r = alpha exp(i chi) in the
axes (n, t) from the centre to the vertex; the container's frame feels w = beta exp(i (t - nu)). Newton's law in these axes:

    lambda = w_n + u^2 - S' r_t - S^2 r_n     u' = w_t + f + S' r_n - S^2 r_t     I S' = r_n f + r_t lambda     u = nu'

with f = -mu sign(u) lambda while it slides, u = u' = 0 while it sticks. A motion is a power series in time of order ORDER. A neighbour
that strikes receives its impulse, then the vertex in contact one, in turn, until neither approaches. Where such strikes accumulate
they are followed until they are slower than STILL; then each motion of one vertex is tried in which the other one leaves the wall, and
exactly one must be consistent.
"""

from collections import namedtuple

from mpmath import mp, mpc, mpf

from dynamics import State, impulse, scene_of, swirl

DIGITS = 60
ORDER = 40
STILL = mpf(10) ** -22  # a velocity below this is rest
LEAST = mpf(10) ** -25  # the first moment at which a condition is looked at
LONGEST = mpf(1) / 16  # a step; a condition is looked at 32 times in it, and where it turns
Contact = namedtuple("Contact", "vertex mode")  # mode: 0 sticks, 1 or -1 slides in that sense
Held = namedtuple("Held", "t nu u angle spin")  # a state on a vertex; angle is vertex 0's


def turned(scene, vertex):
    return 2 * mp.pi * vertex / scene.sides


# Power series: lists of coefficients of equal length.

def product(a, b):
    return [mp.fdot(a[:k + 1], b[k::-1]) for k in range(len(a))]


def quotient(a, b):
    q = []
    for k in range(len(a)):
        q.append((a[k] - mp.fdot(q, b[k:0:-1])) / b[0])
    return q


def cosine_and_sine(a):
    c, s = [mp.cos(a[0])], [mp.sin(a[0])]
    da = [j * x for j, x in enumerate(a)]
    for k in range(1, len(a)):
        c.append(-mp.fdot(da[1:k + 1], s[::-1]) / k)
        s.append(mp.fdot(da[1:k + 1], c[k - 1::-1]) / k)
    return c, s


def at(series, t):
    return mp.polyval(series[::-1], t)


def forces(scene, contact, z):
    """(lambda, f, u', S'): series of a vertex's motion from the series of its Held state."""
    wn, wt = (([scene.beta * x for x in part]) for part in cosine_and_sine([a - b for a, b in zip(z.t, z.nu)]))
    chi = [a - b for a, b in zip(z.angle, z.nu)]
    chi[0] += turned(scene, contact.vertex)
    rn, rt = ([scene.alpha * x for x in part] for part in cosine_and_sine(chi))
    s2 = product(z.spin, z.spin)
    if contact.mode == 0:
        rate = [(a - b) / (scene.inertia + scene.alpha ** 2) for a, b in zip(product(rt, wn), product(rn, wt))]
        normal = [a - b - c for a, b, c in zip(wn, product(rate, rt), product(s2, rn))]
        return normal, [-a - b + c for a, b, c in zip(wt, product(rate, rn), product(s2, rt))], [mpf(0)] * len(wn), rate
    smu = contact.mode * scene.mu
    pull = [a + b - c for a, b, c in zip(wn, product(z.u, z.u), product(s2, rn))]
    stiff = [x / scene.inertia for x in product(rt, [a - smu * b for a, b in zip(rt, rn)])]
    stiff[0] += 1
    normal = quotient(pull, stiff)
    friction = [-smu * x for x in normal]
    rate = [(a + b) / scene.inertia for a, b in zip(product(rn, friction), product(rt, normal))]
    slip = [a + b + c - d for a, b, c, d in zip(wt, friction, product(rate, rn), product(s2, rt))]
    return normal, friction, slip, rate


def motion(scene, contact, start, order=ORDER):
    """The series of a Held state from `start` on, and those of its forces."""
    z = Held([start.t], [start.nu], [start.u], [start.angle], [start.spin])
    for k in range(1, order):
        _, _, slip, rate = forces(scene, contact, z)
        z = Held(z.t + [mpf(k == 1)], z.nu + [z.u[-1] / k], z.u + [slip[-1] / k], z.angle + [z.spin[-1] / k],
                 z.spin + [rate[-1] / k])
    return z, forces(scene, contact, z)


def step_of(z):
    """As long as the last terms are below 10^-50."""
    last = max(abs(z.u[-1]), abs(z.spin[-1]), mpf(10) ** -40)
    return min(LONGEST, (mpf(10) ** -50 / last) ** (mpf(1) / (len(z.u) - 1)))


def at_rest_on(z, t=mpf(0)):
    return Held(*(at(series, t) for series in z))


def in_laboratory(scene, contact, z):
    """The State of a Held one."""
    n, o = mp.expj(z.nu), swirl(scene, z.t)
    arm = scene.alpha * mp.expj(z.angle + turned(scene, contact.vertex))
    return State(z.t, n - arm + o, 1j * (o + z.u * n - z.spin * arm), z.angle, z.spin)


def vertex_at(scene, state, vertex):
    """x - O, and its velocity, along n and t."""
    o, arm = swirl(scene, state.t), scene.alpha * mp.expj(state.angle + turned(scene, vertex))
    x = state.x + arm - o
    return x, (state.v + 1j * (state.spin * arm - o)) * mp.conj(x) / abs(x)


def held(scene, state, vertex):
    """The Held state of a vertex on the wall with u_n = 0; a slip below STILL is none."""
    x, u = vertex_at(scene, state, vertex)
    return Held(state.t, mp.arg(x), u.imag if abs(u.imag) > STILL else mpf(0), state.angle, state.spin)


def struck(scene, state, vertex):
    """The state after an impulse at a vertex on the wall."""
    x, u = vertex_at(scene, state, vertex)
    n = x / abs(x)
    r = scene.alpha * mp.expj(state.angle + turned(scene, vertex)) * mp.conj(n)
    b1, b2, b3 = 1 + r.real ** 2 / scene.inertia, 1 + r.imag ** 2 / scene.inertia, r.real * r.imag / scene.inertia
    p, q = impulse(scene, b1, b2, b3, -u.real, u.imag if abs(u.imag) > STILL else mpf(0))
    return state._replace(v=state.v + mpc(-p, q) * n, spin=state.spin + (r.real * q + r.imag * p) / scene.inertia)


def leaves_in_flight(scene, state, vertex):
    """Of a vertex with u_n = 0: does it accelerate away from the wall without forces?"""
    x, u = vertex_at(scene, state, vertex)
    n = x / abs(x)
    r = scene.alpha * mp.expj(state.angle + turned(scene, vertex)) * mp.conj(n)
    return (scene.beta * mp.expj(state.t) * mp.conj(n)).real + u.imag ** 2 - state.spin ** 2 * r.real < 0


def is_consistent(scene, contact, z, broken):
    """A slip that begins as friction ceases to hold has u' = 0 at first."""
    normal, friction, slip, _ = (series[0] for series in forces(scene, contact, Held(*([x] for x in z))))
    if contact.mode == 0:
        return not broken and normal >= 0 and abs(friction) <= scene.mu * normal
    return normal >= 0 and (z.u * contact.mode > 0 or slip * contact.mode > (-STILL if broken else 0))


def normal_acceleration(scene, contact, z, other):
    """Of another vertex on the wall, outward, as contact on the first one moves it."""
    series, _ = motion(scene, contact, z, 4)
    gaps = [abs(vertex_at(scene, in_laboratory(scene, contact, at_rest_on(series, t)), other)[0]) - 1
            for t in (mpf(10) ** -15, mpf(10) ** -12)]
    return gaps[1]


def contacts_from(scene, state, touching, broken):
    """The contacts in which the body may go on: of the vertices on the wall one, in which motion, the others leaving.

    broken: friction has just ceased to hold
    """
    found = []
    for vertex in touching:
        z = held(scene, state, vertex)
        if leaves_in_flight(scene, state, vertex):
            continue
        for mode in ([0, 1, -1] if z.u == 0 else [1 if z.u > 0 else -1]):
            contact = Contact(vertex, mode)
            if not is_consistent(scene, contact, z, broken):
                continue
            if all(normal_acceleration(scene, contact, z, other) < 0 for other in touching if other != vertex):
                found.append((contact, z))
    return found


def first_failure(conditions, longest):
    """(moment, name) of the first of the conditions, functions of time that hold while > 0, that fails; None if none does."""
    first = None
    grid, t = [], LEAST
    while t < longest / 32:
        grid.append(t)
        t *= 4
    grid += [longest * k / 32 for k in range(1, 33)]
    for name, value in conditions:
        before, last = grid[0], value(grid[0])
        for moment in grid[1:]:
            now = value(moment)
            if first and moment > first[0] and before > first[0]:
                break
            if now <= 0 < last:
                root = mp.findroot(value, (before, moment), solver="anderson", tol=mpf(10) ** -90, verify=False)
                if first is None or root < first[0]:
                    first = (root, name)
                break
            before, last = moment, now
    return first


def first_touch(scene, state, longest):
    """(flight time, vertex) of the first contact of a flight within `longest`; vertices that start on the wall leave it."""
    def gap_of(vertex):
        def value(t):
            x = state.x + state.v * t + scene.alpha * mp.expj(state.angle + state.spin * t + turned(scene, vertex))
            return 1 - abs(x - swirl(scene, state.t + t)) ** 2
        return value
    return first_failure([(vertex, gap_of(vertex)) for vertex in range(scene.sides)], longest)


def end_of_contact(scene, contact, series, longest):
    """(moment, event) of the first event along a step: "release", "slip", "stick", or the vertex that strikes."""
    z, (normal, friction, _, _) = series
    conditions = [("release", lambda t: at(normal, t))]
    if contact.mode == 0:
        conditions.append(("slip", lambda t: scene.mu * at(normal, t) - abs(at(friction, t))))
    else:
        conditions.append(("stick", lambda t: contact.mode * at(z.u, t)))

    def room_of(vertex):
        # |x|^2 - 1 of another vertex, without the difference of numbers near 1: x = n + d, |x|^2 - 1 = 2 n.d + |d|^2.
        def value(t):
            now = at_rest_on(z, t)
            chord = scene.alpha * mp.expj(now.angle) * (mp.expj(turned(scene, vertex)) -
                                                        mp.expj(turned(scene, contact.vertex)))
            n = mp.expj(now.nu)
            return -2 * (chord * mp.conj(n)).real - abs(chord) ** 2
        return value
    for side in (1, scene.sides - 1):
        vertex = (contact.vertex + side) % scene.sides
        conditions.append((vertex, room_of(vertex)))
    return first_failure(conditions, longest)


def strikes(scene, state, touching):
    """The state once no vertex on the wall approaches, by impulses in turn; and those that stay on it."""
    for _ in range(10_000):
        speeds = {vertex: vertex_at(scene, state, vertex)[1].real for vertex in touching}
        striking = max(touching, key=speeds.get)
        if speeds[striking] <= STILL:
            return state, [vertex for vertex in touching if abs(speeds[vertex]) <= STILL]
        state = struck(scene, state, striking)
    raise ArithmeticError("the impulses of two vertices in turn do not end")


class Follower:
    """An orbit from a State inside on; `samples` are (t, S, angle, x) at the moments asked for."""

    def __init__(self, scene, state, moments):
        self.scene, self.state, self.moments = scene, state, list(moments)
        self.samples, self.events = [], []

    def note(self, until, state_at):
        while self.moments and self.moments[0] <= until:
            now = state_at(self.moments.pop(0))
            self.samples.append((now.t, now.spin, now.angle, now.x))

    def fly(self):
        start = self.state
        found = first_touch(self.scene, start, LONGEST)
        tau = found[0] if found else LONGEST
        moved = lambda t: State(t, start.x + start.v * (t - start.t), start.v, start.angle + start.spin * (t - start.t),
                                start.spin)
        self.note(start.t + tau, moved)
        self.state = moved(start.t + tau)
        if not found:
            return None
        self.events.append((start.t + tau, "impact"))
        return self.begin([found[1]])

    def begin(self, touching, broken=False):
        """The contact in which the body goes on after the strikes of vertices on the wall; None: in flight."""
        self.state, staying = strikes(self.scene, self.state, touching)
        found = contacts_from(self.scene, self.state, staying, broken)
        if len(found) > 1:
            raise ArithmeticError(f"several motions are consistent: {[contact for contact, _ in found]}")
        if not found and not all(leaves_in_flight(self.scene, self.state, vertex) for vertex in staying):
            raise ArithmeticError("two vertices stay in contact, or a slip jams")
        return found[0] if found else None

    def press(self, contact, z):
        series = motion(self.scene, contact, z)
        step = step_of(series[0])
        found = end_of_contact(self.scene, contact, series, step)
        span = found[0] if found else step
        laboratory = lambda t: in_laboratory(self.scene, contact, at_rest_on(series[0], t - z.t))
        self.note(z.t + span, laboratory)
        end = at_rest_on(series[0], span)
        if not found:
            return contact, end
        self.events.append((end.t, found[1]))
        self.state = in_laboratory(self.scene, contact, end)
        if found[1] == "release":
            return None
        if found[1] == "stick":
            return self.begin([contact.vertex])
        if found[1] == "slip":
            return self.begin([contact.vertex], True)
        return self.begin([contact.vertex, found[1]])

    def follow(self):
        at_work = None
        while self.moments:
            at_work = self.press(*at_work) if at_work else self.fly()
        return self.samples


def contact_orbit(entry, digits):
    """An entry of contact_orbits.json."""
    with mp.workdps(DIGITS):
        start = {key: mpf(value) for key, value in entry["initial"].items()}
        state = State(mpf(0), mpc(start["x"], start["y"]), mpc(start["vx"], start["vy"]), start["angle"], start["spin"])
        follower = Follower(scene_of(entry), state, [mpf(sample["t"]) for sample in entry["samples"]])
        rows = [(t, x.real, x.imag, angle, spin) for t, spin, angle, x in follower.follow()]
        names = ("t", "x", "y", "angle", "spin")
        return {**entry, "samples": [{name: mp.nstr(value, digits) for name, value in zip(names, row)} for row in rows]}
