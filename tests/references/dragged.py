"""Flight over a floor that drags, in 50-digit arithmetic, from the equations of motion in the laboratory:

    V' = -gamma (V - V_floor)    S' = -gamma_r S    V_floor = O'(t) of a dish, 0 of a table.

With O = beta exp(i t) V has a part K exp(i t) that stays, i K = -gamma K + i gamma beta, and what is left decays. The
impact is that of dynamics.py, which knows no floor; so is the search for the first contact, with a bound of its own.
"""

import heapq
from collections import namedtuple

from mpmath import mp, mpc, mpf

from dynamics import CLOSE, LONGEST_FLIGHT, Impact, State, impact_at, scene_of, swirl

Floor = namedtuple("Floor", "drag spin_drag kind")


def floor_of(case):
    return Floor(mpf(case["drag"]), mpf(case["spin_drag"]), case["floor"])


def length(rate, tau):
    """The integral of exp(-rate s) from 0 to tau."""
    return -mp.expm1(-rate * tau) / rate if rate else tau


def carried(scene, floor):
    """K."""
    return 1j * floor.drag * scene.beta / (floor.drag + 1j) if floor.kind == "dish" else mpc(0)


def moved(scene, floor, state, tau):
    """The state at a time tau of the flight."""
    k = carried(scene, floor) * mp.expj(state.t)
    left = state.v - k
    x = state.x - 1j * k * (mp.expj(tau) - 1) + left * length(floor.drag, tau)
    v = k * mp.expj(tau) + left * mp.exp(-floor.drag * tau)
    return State(state.t + tau, x, v, state.angle + state.spin * length(floor.spin_drag, tau),
                 state.spin * mp.exp(-floor.spin_drag * tau))


def gap(scene, floor, state, vertex, tau):
    """As dynamics.gap."""
    now, reach = moved(scene, floor, state, tau), 1 - scene.alpha
    o = swirl(scene, now.t)
    x, dx = now.x - o, now.v - 1j * o
    if scene.sides:
        arm = scene.alpha * mp.expj(now.angle + 2 * mp.pi * vertex / scene.sides)
        x, dx, reach = x + arm, dx + 1j * now.spin * arm, 1
    return x.real ** 2 + x.imag ** 2 - reach ** 2, 2 * (x.real * dx.real + x.imag * dx.imag)


def curvature_bound(scene, floor, state):
    """M >= d2g/dt2 while nothing is outside: 2 (|x'|^2 + |x''|) with |x'| and |x''| from their parts."""
    left, ridden = abs(state.v - carried(scene, floor) * mp.expj(state.t)), abs(carried(scene, floor))
    spin, alpha = abs(state.spin) if scene.sides else mpf(0), scene.alpha
    first = left + ridden + scene.beta + spin * alpha
    second = floor.drag * left + ridden + scene.beta + alpha * spin * (spin + floor.spin_drag)
    return 2 * (first ** 2 + second)


def first_contact(scene, floor, state, struck=None):
    """As dynamics.first_contact."""
    m = curvature_bound(scene, floor, state)
    waiting = [(mpf(0), i) for i in range(scene.sides or 1)]
    steps = 0
    while waiting[0][0] < LONGEST_FLIGHT and steps < 20_000:
        steps += 1
        tau, i = waiting[0]
        g, dg = gap(scene, floor, state, i, tau)
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
                return touching_time(scene, floor, state, i, tau), i
        heapq.heapreplace(waiting, (tau + step, i))
    raise ArithmeticError("no contact is found: the body may ride with the floor")


def touching_time(scene, floor, state, vertex, tau):
    for _ in range(60):
        g, dg = gap(scene, floor, state, vertex, tau)
        if dg <= 0:
            break
        step = g / dg
        tau -= step
        if abs(step) < CLOSE:
            return tau
    raise ArithmeticError("Newton's method for the time of impact does not converge: grazing")


def next_impact(scene, floor, state, struck=None):
    tau, vertex = first_contact(scene, floor, state, struck)
    return impact_at_end(scene, floor, state, tau, vertex)


def impact_at_end(scene, floor, state, tau, vertex):
    """The impact after the flight, which is one of no duration from the state that the floor has led to."""
    impact = impact_at(scene, moved(scene, floor, state, tau), mpf(0), vertex)
    return Impact(tau, *impact[1:])


def same_impact(scene, floor, state, known):
    tau = touching_time(scene, floor, state, known.vertex, known.flight_time)
    return impact_at_end(scene, floor, state, tau, known.vertex)


__all__ = ["floor_of", "moved", "next_impact", "same_impact", "scene_of"]
