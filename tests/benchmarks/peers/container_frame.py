"""The dish's physics as other solvers take it, in Python: see container_frame.hpp, whose formulas these are.

A start is the list (psi_x, psi_y, chi_x, chi_y, v_n, v_t, S) just after an impact; vectors are complex numbers here.
"""

import cmath
import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Scene:
    """A disk has 0 sides."""

    sides: int
    alpha: float
    beta: float
    mu: float
    restitution: float

    @property
    def inertia(self):
        """I = kappa alpha^2 of the uniform body."""
        kappa = 0.5 if self.sides == 0 else (2 + math.cos(2 * math.pi / self.sides)) / 6
        return kappa * self.alpha**2

    @property
    def points(self):
        return max(1, self.sides)


# Where all laws of impact are one, and where they differ: README.md, "Polygons with friction".
SCENES = {"disk": Scene(0, 0.3, 0.5, 0.5, 1.0), "hexagon": Scene(6, 0.3, 0.5, 0.0, 1.0)}
WHERE_LAWS_DIFFER = {"rough-hexagon": Scene(6, 0.3, 0.5, 0.5, 0.95),
                     "elastic-rough-hexagon": Scene(6, 0.3, 0.5, 0.5, 1.0)}


@dataclass(frozen=True)
class Impact:
    found: bool
    time: float = math.nan
    vertex: int = 0
    after: tuple = ()


def container_state(scene, start):
    """X, X', the direction of the vertex that has just struck, and S, at t = 0 in the container's frame."""
    normal, chi = complex(*start[0:2]), complex(*start[2:4])
    arm = scene.alpha * normal * chi
    return normal - arm, normal * complex(*start[4:6]) - 1j * scene.beta, cmath.phase(arm), start[6]


def arm_of(scene, centre, angle, vertex):
    if scene.sides == 0:
        return scene.alpha * centre / abs(centre)
    return cmath.rect(scene.alpha, angle + 2 * math.pi * vertex / scene.sides)


def section_state(scene, t, centre, velocity, arm, spin):
    swirl = cmath.exp(1j * t)
    normal = (centre + arm) / abs(centre + arm)
    psi, chi = normal / swirl, arm / normal / scene.alpha
    seen = (velocity + 1j * scene.beta * swirl) / normal
    return psi.real, psi.imag, chi.real, chi.imag, seen.real, seen.imag, spin


def after_impact(scene, state):
    psi_x, psi_y, chi_x, chi_y, vn, vt, spin = state
    mu, rn, rt = scene.mu, scene.alpha * chi_x, scene.alpha * chi_y
    un, ut = vn - spin * rt - scene.beta * psi_y, vt + spin * rn - scene.beta * psi_x
    b1, b2, b3 = 1 + rn * rn / scene.inertia, 1 + rt * rt / scene.inertia, rn * rt / scene.inertia
    s = math.copysign(1, ut)
    c, d = b2 - s * mu * b3, mu * b1 - s * b3
    kink = abs(ut) / d if d > 0 else math.inf
    r = -b3 / b1 if abs(b3) <= mu * b1 else s * mu
    compression = un / c if c * kink >= un else kink + (un - c * kink) / (b2 + r * b3)
    p = (1 + scene.restitution) * compression
    q = -s * mu * min(p, kink) + r * max(0.0, p - kink)
    return psi_x, psi_y, chi_x, chi_y, vn - p, vt + q, spin + (rn * q + rt * p) / scene.inertia


def jacobi(scene, state):
    """J of map/README.md, "Energy in the swirling frame": kept by flights, and by impacts without friction at e = 1."""
    psi_x, psi_y, chi_x, chi_y, vn, vt, spin = state
    x, y = 1 - scene.alpha * chi_x + scene.beta * psi_x, -scene.alpha * chi_y - scene.beta * psi_y
    return 0.5 * (vn * vn + vt * vt) - (x * vt - y * vn) + scene.inertia * spin * (0.5 * spin - 1)


def follow(peer, start, count):
    """`count` impacts in a row, or fewer where none is found."""
    impacts = []
    while len(impacts) < count:
        impact = peer.next(start)
        if not impact.found:
            break
        impacts.append(impact)
        start = impact.after
    return impacts
