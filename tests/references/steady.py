"""Steady modes: the fixed points of F, from two equations in the flight time tau and the angle chi.

From one impact to the next everything turns by tau about the swirl's centre. With P0 the body's centre seen from there,
in the axes (n, t) of the impact, V = (exp(i tau) - 1) P0 / tau, and the impulse -p + iq = V - exp(-i tau) V points at
the swirl's centre. The spin is the same after as before, so it points through the body's centre too: arg P0 = chi, that
is beta sin(psi + chi) = -sin chi, with a branch +1 (psi near 0) or -1 (psi near pi). Hence

    R = |P0| = cos chi - alpha + branch sqrt(beta^2 - sin^2 chi)     p = 4 R sin^2(tau/2) / tau cos chi,  q = -p tan chi
    vn + i vt = (2 R sin(tau/2) / tau) i exp(i (chi + tau/2))        S = 1 - 2 pi j / (N tau),  j vertices on

and what is left is the law of impact, for p and for q.
"""

from collections import namedtuple

from mpmath import mp, mpf

from dynamics import Scene, impulse
from section import CLOSED, difference, follow, section_point

Steady = namedtuple("Steady", "psi chi v p slip_after")  # all but the spin


def steady(scene, tau, chi, branch, spin, m):
    """What the formulas above say; m is the arithmetic, mp (50 digits) or fp (double)."""
    root = m.sqrt(scene.beta ** 2 - m.sin(chi) ** 2)
    radius = m.cos(chi) - scene.alpha + branch * root
    turned = -m.asin(m.sin(chi) / scene.beta)  # psi + chi
    psi = (turned if branch > 0 else m.pi - turned) - chi
    v = 2 * radius * m.sin(tau / 2) / tau * 1j * m.expj(chi + tau / 2)
    p = 4 * radius * m.sin(tau / 2) ** 2 / tau * m.cos(chi)
    slip = v + 1j * spin * scene.alpha * m.expj(chi) - 1j * scene.beta * m.expj(-psi)
    return Steady(psi, chi, v, p, slip)


def sticking_spin(scene, tau, chi, branch, m):
    """The spin with which the contact sticks: u_t = 0 after the impact."""
    without = steady(scene, tau, chi, branch, 0, m).slip_after
    return -without.imag / (scene.alpha * m.cos(chi))


def spin_of(scene, tau, j, m):
    return 1 - 2 * m.pi * j / (scene.sides * tau)


def law_defect(scene, tau, chi, branch, spin, m):
    """By how much the law's impulse p exceeds the p that a steady mode needs; None where there is no such impact."""
    if abs(m.sin(chi)) > scene.beta:
        return None
    mode = steady(scene, tau, chi, branch, spin, m)
    if mode.p <= 0:
        return None
    rn, rt = scene.alpha * m.cos(chi), scene.alpha * m.sin(chi)
    b1, b2, b3 = 1 + rn ** 2 / scene.inertia, 1 + rt ** 2 / scene.inertia, rn * rt / scene.inertia
    q = -mode.p * m.tan(chi)
    c0 = -mode.slip_after.real - b2 * mode.p - b3 * q
    if c0 >= 0:
        return None
    return impulse(scene, b1, b2, b3, c0, mode.slip_after.imag - b3 * mode.p - b1 * q)[0] - mode.p


def section_point_of(scene, tau, chi, branch, j):
    spin = spin_of(scene, tau, j, mp)
    mode = steady(scene, tau, chi, branch, spin, mp)
    psi = mode.psi - 2 * mp.pi if mode.psi > mp.pi else mode.psi
    return [psi, chi, mode.v.real, mode.v.imag, spin]


def confirmed(scene, z, j):
    """The one impact of z if F(z) = z with j vertices on (no other vertex strikes earlier), or None."""
    impact = follow(scene, z, 1)[0]
    closes = max(abs(d) for d in difference(section_point(impact), z)) < CLOSED
    return impact if closes and (impact.vertex - j) % scene.sides == 0 else None


def elastic_time(scene, tau, branch, j):
    """The flight time near tau at e = 1: chi = 0 and S = (branch beta - R sin(tau)/tau) / alpha for every mu > 0."""
    radius = 1 - scene.alpha + branch * scene.beta

    def defect(t):
        return (branch * scene.beta - radius * mp.sin(t) / t) / scene.alpha - spin_of(scene, t, j, mp)

    return mp.findroot(defect, (tau, tau * (1 + mpf(10) ** -12)), tol=mpf(10) ** -90)


def in_double(scene):
    return Scene(*(value if isinstance(value, (int, str)) else float(value) for value in scene))
