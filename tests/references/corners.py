"""A polygon with rounded corners, in 50-digit arithmetic, written from the velocities of its points.

The corners are arcs of radius r about the vertices of a regular polygon of circumradius alpha - r. One touches the wall
where its centre y is 1 - r from the container's, at y + r n with n = y / |y|. What an impulse there does to the slip is
found by giving the body unit impulses along n and along t; the uniform lamina's moment by integrals round its edge.
"""

from functools import lru_cache, partial

from mpmath import mp, mpc, mpf

from dynamics import Impact, State, earliest_root, impulse, swirl, touching_time


def corner_of(case):
    return mpf(case["corner"])


def cross(a, b):
    return a.real * b.imag - a.imag * b.real


@lru_cache(maxsize=None)
def moment(sides, alpha, corner):
    """I of a uniform lamina of mass 1: (1/4 of the integral of |z|^2 z x dz) over (1/2 of that of z x dz)."""
    half, rho = mp.pi / sides, alpha - corner
    edge = [rho * mp.expj(-half * 2) + corner * mp.expj(-half), rho + corner * mp.expj(-half)]
    side = edge[1] - edge[0]
    pieces = [(lambda s: edge[0] + s * side, lambda s: side, [0, 1]),
              (lambda a: rho + corner * mp.expj(a), lambda a: 1j * corner * mp.expj(a), [-half, half])]
    area = sum(mp.quad(lambda s: cross(z(s), dz(s)), ends) for z, dz, ends in pieces) / 2
    second = sum(mp.quad(lambda s: abs(z(s)) ** 2 * cross(z(s), dz(s)), ends) for z, dz, ends in pieces) / 4
    return second / area


def with_moment(scene, corner):
    return scene._replace(inertia=moment(scene.sides, scene.alpha, corner))


def centre_of_corner(scene, corner, state, vertex, tau):
    """From the body's centre."""
    return (scene.alpha - corner) * mp.expj(state.angle + state.spin * tau + 2 * mp.pi * vertex / scene.sides)


def gap(scene, corner, state, vertex, tau):
    """|y|^2 - (1 - r)^2 and its rate."""
    o, arm = swirl(scene, state.t + tau), centre_of_corner(scene, corner, state, vertex, tau)
    y, dy = state.x + state.v * tau - o + arm, state.v - 1j * o + 1j * state.spin * arm
    return y.real ** 2 + y.imag ** 2 - (1 - corner) ** 2, 2 * (y.real * dy.real + y.imag * dy.imag)


def curvature_bound(scene, corner, state):
    spin, arm = abs(state.spin), scene.alpha - corner
    return 2 * ((abs(state.v) + spin * arm + scene.beta) ** 2 + spin ** 2 * arm + scene.beta)


def velocity_at(v, spin, r):
    """Of the body's point r from its centre."""
    return v + 1j * spin * r


def impact_at(scene, corner, state, tau, vertex):
    t = state.t + tau
    o, centre = swirl(scene, t), state.x + state.v * tau
    arm = centre_of_corner(scene, corner, state, vertex, tau)
    y = centre + arm - o
    n = y / abs(y)
    r = arm + corner * n
    slip = (velocity_at(state.v, state.spin, r) - 1j * o) / n
    by_n, by_t = (velocity_at(j, cross(r, j) / scene.inertia, r) / n for j in (-n, 1j * n))
    p, q = impulse(scene, by_t.imag, -by_n.real, by_n.imag, -slip.real, slip.imag)
    given = (-p + 1j * q) * n
    after = State(t, centre, state.v + given, state.angle + state.spin * tau,
                  state.spin + cross(r, given) / scene.inertia)
    return Impact(tau, vertex, n, r, p, q, slip, after)


def next_impact(scene, corner, state, struck=None):
    found = earliest_root(scene.sides, partial(gap, scene, corner, state), curvature_bound(scene, corner, state), struck)
    return impact_at(scene, corner, state, *found)


def same_impact(scene, corner, state, known):
    tau = touching_time(partial(gap, scene, corner, state), known.vertex, known.flight_time)
    return impact_at(scene, corner, state, tau, known.vertex)
