"""The impact of a disk whose sticking impacts return the slip, in 50-digit arithmetic: flight and first contact are those of
dynamics.py.

The normal impulse is p = (1 + e) u_n. Friction would give q = -(1 + e_t) u_t / B1, after which the slip is -e_t u_t; it
gives no more than mu p (O. R. Walton's third coefficient).
"""

from mpmath import mpc, mpf

from dynamics import Impact, State, first_contact, same_contact, swirl


def impact_at_end(scene, returned, state, tau):
    t = state.t + tau
    centre = state.x + state.v * tau
    n = (centre - swirl(scene, t)) / abs(centre - swirl(scene, t))
    u = (state.v - 1j * swirl(scene, t)) / n + 1j * state.spin * scene.alpha
    p = (1 + scene.restitution) * u.real
    wanted = -(1 + returned) * u.imag / (1 + scene.alpha ** 2 / scene.inertia)
    most = scene.mu * p
    q = max(-most, min(most, wanted))
    after = State(t, centre, state.v + mpc(-p, q) * n, state.angle + state.spin * tau,
                  state.spin + scene.alpha * q / scene.inertia)
    return Impact(tau, 0, n, scene.alpha * n, p, q, u, after)


def slides(scene, impact):
    return abs(impact.q) == scene.mu * impact.p


def next_impact(scene, returned, state, struck=None):
    return impact_at_end(scene, returned, state, first_contact(scene, state, struck)[0])


def same_impact(scene, returned, state, known):
    return impact_at_end(scene, returned, state, same_contact(scene, state, known)[0])


def returned_of(case):
    return mpf(case["tangential_restitution"])
