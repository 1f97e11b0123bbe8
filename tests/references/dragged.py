"""Flight over a floor that drags, in 50-digit arithmetic, from the equations of motion in the laboratory:

    V' = -gamma (V - V_floor)    S' = -gamma_r S    V_floor = O'(t) of a dish, 0 of a table.

With O = beta exp(i t) V has a part K exp(i t) that stays, i K = -gamma K + i gamma beta, and what is left decays. The
impact is that of dynamics.py, which knows no floor; so is the search for the first contact, with a bound of its own.
"""

from collections import namedtuple
from functools import partial

from mpmath import mp, mpc, mpf

from dynamics import Impact, State, earliest_root, impact_at, scene_of, swirl, touching_time

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


def next_impact(scene, floor, state, struck=None):
    found = earliest_root(scene.sides or 1, partial(gap, scene, floor, state), curvature_bound(scene, floor, state),
                          struck, most_steps=20_000)  # a body that rides with the floor has no contact
    return impact_at_end(scene, floor, state, *found)


def impact_at_end(scene, floor, state, tau, vertex):
    """The impact after the flight, which is one of no duration from the state that the floor has led to."""
    impact = impact_at(scene, moved(scene, floor, state, tau), mpf(0), vertex)
    return Impact(tau, *impact[1:])


def same_impact(scene, floor, state, known):
    tau = touching_time(partial(gap, scene, floor, state), known.vertex, known.flight_time)
    return impact_at_end(scene, floor, state, tau, known.vertex)


__all__ = ["floor_of", "moved", "next_impact", "same_impact", "scene_of"]
