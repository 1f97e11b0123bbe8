"""A regular polygon or a disk in a swirled circular container, in 50-digit arithmetic, written from the equations of
motion alone: flight, first contact and impact, in units R_c = omega_s = m = 1.

Vectors of the plane are complex numbers. The container's centre is O(t) = beta exp(i t). Vertex i of N lies at
X + V t + alpha exp(i (angle + spin t + 2 pi i / N)); a disk is sides = 0. The slip velocity at a contact is
u = V + i spin r - O'(t), with r from the body's centre to the contact.
"""

import heapq
from collections import namedtuple
from functools import partial

from mpmath import mp, mpc, mpf

mp.dps = 50

Scene = namedtuple("Scene", "sides alpha beta mu restitution law inertia")  # inertia: the moment, kappa alpha^2
State = namedtuple("State", "t x v angle spin")  # time, centre, velocity (laboratory), angle of vertex 0, spin
Impact = namedtuple("Impact", "flight_time vertex normal arm p q slip_before after")
Piece = namedtuple("Piece", "p c q dc dq")  # from the impulse p on, C and q have these values and slopes

LONGEST_FLIGHT = 10_000
CLOSE = mpf(10) ** -40  # a step this short has converged; Newton's method then gives the last digits


def scene_of(case):
    """The scene of an entry of a reference file: decimal strings, exact to 50 digits. A uniform lamina."""
    sides, alpha = case["sides"], mpf(case["alpha"])
    kappa = (2 + mp.cos(2 * mp.pi / sides)) / 6 if sides else mpf(1) / 2
    if sides == 2:  # a rod: its mass is on its line
        kappa = mpf(1) / 3
    return Scene(sides, alpha, mpf(case["beta"]), mpf(case["mu"]), mpf(case["restitution"]), case["law"],
                 kappa * alpha ** 2)


def swirl(scene, t):
    """The container's centre; its velocity is i times this."""
    return scene.beta * mp.expj(t)


def arm_of(scene, state, vertex, tau):
    return scene.alpha * mp.expj(state.angle + state.spin * tau + 2 * mp.pi * vertex / scene.sides)


def gap(scene, state, vertex, tau):
    """g = |x|^2 - (largest |x|)^2 and dg/dt, x being the vertex (of a disk: the centre) in the container's frame."""
    o = swirl(scene, state.t + tau)
    x, dx, reach = state.x + state.v * tau - o, state.v - 1j * o, 1 - scene.alpha
    if scene.sides:
        arm = arm_of(scene, state, vertex, tau)
        x, dx, reach = x + arm, dx + 1j * state.spin * arm, 1
    return x.real ** 2 + x.imag ** 2 - reach ** 2, 2 * (x.real * dx.real + x.imag * dx.imag)


def curvature_bound(scene, state):
    """M >= d2g/dt2 for every vertex while it is inside: 2 (|x'|^2 + |x| |x''|)."""
    speed, alpha, beta, spin = abs(state.v), scene.alpha, scene.beta, abs(state.spin)
    if not scene.sides:
        return 2 * ((speed + beta) ** 2 + beta * (1 - alpha))
    return 2 * ((speed + spin * alpha + beta) ** 2 + spin ** 2 * alpha + beta)


def earliest_root(vertices, gap_at, m, struck=None, most_steps=mp.inf):
    """(flight time, vertex) of the first contact, by conservative advancement of all vertices together.

    While a vertex is inside, g(tau + s) <= g + g' s + M s^2 / 2, so it may advance to the first positive root of that
    parabola without passing a contact. The vertex with the earliest bound advances; the first to converge is the first
    to touch. The vertex that has just struck starts at g = 0 exactly. `gap_at(vertex, tau)` gives g and g'.
    """
    waiting = [(mpf(0), i) for i in range(vertices)]
    steps = 0
    while waiting[0][0] < LONGEST_FLIGHT and steps < most_steps:
        steps += 1
        tau, i = waiting[0]
        g, dg = gap_at(i, tau)
        if tau == 0 and i == struck:
            if dg >= 0:
                raise ArithmeticError("the vertex that has just struck does not leave: sustained contact")
            step = -2 * dg / m
        elif tau == 0 and g > 0:
            raise ValueError(f"vertex {i} starts outside the container")
        else:
            root = mp.sqrt(dg * dg - 2 * m * min(g, mpf(0)))
            step = -2 * min(g, mpf(0)) / (dg + root) if dg > 0 else (root - dg) / m
            if step < CLOSE:
                return touching_time(gap_at, i, tau), i
        heapq.heapreplace(waiting, (tau + step, i))
    raise ArithmeticError(f"no contact within {LONGEST_FLIGHT}" if steps < most_steps else f"no contact in {steps} steps")


def touching_time(gap_at, vertex, tau):
    """The root of the gap near tau, by Newton's method; the vertex moves outward there."""
    for _ in range(60):
        g, dg = gap_at(vertex, tau)
        if dg <= 0:
            break
        step = g / dg
        tau -= step
        if abs(step) < CLOSE:  # quadratic: the next step would lie below the last digit
            return tau
    raise ArithmeticError("Newton's method for the time of impact does not converge: grazing")


def pieces(mu, b1, b2, b3, c0, ut0):
    """C(p) and q(p) under Coulomb's law, piecewise linear with at most one kink, where the slip stops.

    dC = B2 dp + B3 dq, du_t = B3 dp + B1 dq. Slipping: dq = -mu sign(u_t) dp. At u_t = 0 it sticks, dq = -(B3/B1) dp,
    if |B3| <= mu B1, and otherwise slips on the way in which B3 drives it.
    """
    path, p, c, q = [], 0 * c0, c0, 0 * c0
    if ut0 != 0:
        s = 1 if ut0 > 0 else -1
        dc, rate = b2 - s * mu * b3, b3 - s * mu * b1
        path.append(Piece(p, c, q, dc, -s * mu))
        if s * rate >= 0:
            return path
        p = -ut0 / rate
        c, q = c0 + dc * p, -s * mu * p
    dq = -b3 / b1 if abs(b3) <= mu * b1 else (-mu if b3 > 0 else mu)
    path.append(Piece(p, c, q, b2 + b3 * dq, dq))
    return path


def ends_of(path):
    return [piece.p for piece in path[1:]] + [None]


def impulse_at(path, level):
    """The impulse at which C rises through level."""
    for piece, end in zip(path, ends_of(path)):
        if piece.dc > 0:
            p = piece.p + (level - piece.c) / piece.dc
            if end is None or p <= end:
                return p
    raise ArithmeticError("C never rises so far")


def work(path, start, stop):
    """The integral of C dp."""
    total = 0 * start
    for piece, end in zip(path, ends_of(path)):
        a, b = max(piece.p, start), stop if end is None else min(end, stop)
        if a < b:
            total += (b - a) * (piece.c + piece.dc * ((a + b) / 2 - piece.p))
    return total


def impulse_after_work(path, start, needed):
    """The impulse at which the normal impulse has done this work since start, where C = 0."""
    for piece, end in zip(path, ends_of(path)):
        if end is not None and end <= start:
            continue
        done = 0 * start if end is None else work(path, start, end)
        if end is None or done >= needed:
            a = max(piece.p, start)
            c = piece.c + piece.dc * (a - piece.p)
            left = needed - work(path, start, a)
            return a + 2 * left / (c + (c * c + 2 * piece.dc * left) ** 0.5) if left else a
    raise AssertionError("the last piece has no end")


def impulse(scene, b1, b2, b3, c0, ut0):
    """(p, q) at the end of the impact, by Poisson's, Newton's or Stronge's law (the work of the normal impulse)."""
    e = scene.restitution
    path = pieces(scene.mu, b1, b2, b3, c0, ut0)
    compression = impulse_at(path, 0 * c0)
    if scene.law == "poisson":
        p = (1 + e) * compression
    elif scene.law == "newton":
        p = impulse_at(path, -e * c0)
    elif scene.law == "stronge":
        p = impulse_after_work(path, compression, -e * e * work(path, 0 * c0, compression))
    else:
        raise ValueError(f"law = {scene.law}: must be poisson, newton or stronge")
    piece = [piece for piece in path if piece.p <= p][-1]
    return p, piece.q + piece.dq * (p - piece.p)


def impact_at(scene, state, tau, vertex):
    """The impact of a vertex that touches after the flight time tau."""
    t = state.t + tau
    o, centre = swirl(scene, t), state.x + state.v * tau
    if scene.sides:
        arm = arm_of(scene, state, vertex, tau)
        n = (centre + arm - o) / abs(centre + arm - o)
    else:
        n = (centre - o) / abs(centre - o)
        arm = scene.alpha * n
    r = arm * mp.conj(n)  # in the axes (n, t)
    u = state.v * mp.conj(n) + 1j * state.spin * r - 1j * o * mp.conj(n)
    b1, b2 = 1 + r.real ** 2 / scene.inertia, 1 + r.imag ** 2 / scene.inertia
    p, q = impulse(scene, b1, b2, r.real * r.imag / scene.inertia, -u.real, u.imag)
    after = State(t, centre, state.v + mpc(-p, q) * n, state.angle + state.spin * tau,
                  state.spin + (r.real * q + r.imag * p) / scene.inertia)
    return Impact(tau, vertex, n, arm, p, q, u, after)


def first_contact(scene, state, struck=None):
    return earliest_root(scene.sides or 1, partial(gap, scene, state), curvature_bound(scene, state), struck)


def next_impact(scene, state, struck=None):
    return impact_at(scene, state, *first_contact(scene, state, struck))


def same_contact(scene, state, known):
    """Of a neighbouring orbit: the same vertex, at the neighbouring time."""
    return touching_time(partial(gap, scene, state), known.vertex, known.flight_time), known.vertex


def same_impact(scene, state, known):
    return impact_at(scene, state, *same_contact(scene, state, known))
