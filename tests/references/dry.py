"""Flight over a floor with dry friction under uniform pressure, from the equations of motion in the laboratory:

    V' = -a <u/|u|>    I S' = -a <rho x u/|u|>    u = V + i S rho - V_floor    a = M G    V_floor = O'(t) of a dish, 0 of a table.

The means over the body are taken in polar coordinates about the point that does not slide, by quadrature over the
angle; the equations are solved by extrapolation (Gragg, Bulirsch, Stoer). The impact is that of dynamics.py.
"""

import math
from functools import cache

import numpy
from mpmath import mp, mpc, mpf

from dynamics import Impact, State, impact_at, scene_of

DIGITS = 13  # of the 18 of numpy's long double that the integration and the search for the contact leave
MACRO = 1 / 16
ORDER = 8  # columns of the extrapolation
NAMES = ("t", "x", "y", "vx", "vy", "angle", "spin")


def number(x):
    return numpy.longdouble(mp.nstr(x, 25))


PI = numpy.longdouble("3.14159265358979323846264338327950288")


def in_numbers(scene):
    return scene._replace(alpha=number(scene.alpha), beta=number(scene.beta), inertia=number(scene.inertia))


def swirl(scene, t):
    return scene.beta * numpy.exp(1j * t)


def corners_of(scene, angle):
    return [scene.alpha * numpy.exp(1j * (angle + 2 * PI * k / scene.sides)) for k in range(scene.sides)]


@cache
def gauss(count):
    """Nodes and weights on [-1, 1]."""
    with mp.workdps(30):
        nodes, weights = [], []
        for k in range(count):
            x = mp.cos(mp.pi * (k + mpf(3) / 4) / (count + mpf(1) / 2))
            for _ in range(9):
                p0, p1 = mpf(1), x
                for n in range(2, count + 1):
                    p0, p1 = p1, ((2 * n - 1) * x * p1 - (n - 1) * p0) / n
                slope = count * (x * p1 - p0) / (x * x - 1)
                x -= p1 / slope
            nodes.append(number(x))
            weights.append(number(2 / ((1 - x * x) * slope * slope)))
    return numpy.array(nodes), numpy.array(weights)


def nodes_between(low, high, count):
    x, weight = gauss(count)
    return (low + high) / 2 + x * (high - low) / 2, weight * (high - low) / 2


def over_triangle(a, b):
    """The integrals of xi/|xi| and |xi| over the triangle 0, a, b, with the sign of its turn: in polar coordinates, the
    angle from the side's normal as arctan(sinh w), in which |xi| = d cosh w on the side."""
    length = abs(b - a)
    normal = -1j * (b - a) / length
    distance, tangent = (normal.conjugate() * a).real, 1j * normal
    if abs(distance) < 1e-17:
        return 0, 0
    w0, w1 = (numpy.arcsinh((tangent.conjugate() * end).real / abs(distance)) for end in (a, b))
    pieces = max(1, math.ceil(abs(w1 - w0)))
    mean, radius = 0, 0
    for piece in range(pieces):
        w, weight = nodes_between(w0 + (w1 - w0) * piece / pieces, w0 + (w1 - w0) * (piece + 1) / pieces, 20)
        reach = abs(distance) * numpy.cosh(w)
        direction = (normal * distance + tangent * abs(distance) * numpy.sinh(w)) / reach
        turn = weight / numpy.cosh(w)
        mean += (direction * reach ** 2 / 2 * turn).sum()
        radius += (reach ** 3 / 3 * turn).sum()
    return (mean, radius) if distance > 0 else (-mean, -radius)


def means_of_polygon(scene, corners, pivot):
    parts = [over_triangle(a - pivot, b - pivot) for a, b in zip(corners, corners[1:] + corners[:1])]
    area = scene.sides * scene.alpha ** 2 * numpy.sin(2 * PI / scene.sides) / 2
    return sum(part[0] for part in parts) / area, sum(part[1] for part in parts) / area


def means_of_disk(scene, pivot):
    """By sectors about the pivot, over the rim's angle; its nodes crowd where the rim is nearest to the pivot."""
    middle, pieces = numpy.angle(pivot) if pivot else number(0), 8
    mean, radius = 0, 0
    for piece in range(-pieces, pieces):
        s, weight = nodes_between(number(piece) / pieces, number(piece + 1) / pieces, 30)
        rim = scene.alpha * numpy.exp(1j * (middle + PI * s ** 3))
        xi = rim - pivot
        reach = abs(xi)
        turn = (xi.conjugate() * 1j * rim).imag / reach ** 2 * 3 * PI * s ** 2 * weight
        mean += (xi / reach * reach ** 2 / 2 * turn).sum()
        radius += (reach ** 3 / 3 * turn).sum()
    area = PI * scene.alpha ** 2
    return mean / area, radius / area


def means_by_area(scene, slip, spin, angle):
    """Where the point that does not slide is far, and its polar coordinates would cancel: by quadrature over the area."""
    part, part_weight = nodes_between(number(0), number(1), 24)
    if scene.sides:
        corners = corners_of(scene, angle)
        sides = [(a + part * (b - a), part_weight / scene.sides) for a, b in zip(corners, corners[1:] + corners[:1])]
        rim, weight = (numpy.concatenate(both) for both in zip(*sides))
    else:
        rim = scene.alpha * numpy.exp(2j * PI * numpy.arange(64, dtype=numpy.longdouble) / 64)
        weight = numpy.full(64, number(1) / 64)
    rho = part[:, None] * rim
    weights = 2 * (part * part_weight)[:, None] * weight
    u = slip + 1j * spin * rho
    direction = u / abs(u)
    return (weights * direction).sum(), (weights * (rho.conjugate() * direction).imag).sum()


def means(scene, slip, spin, angle):
    """<u/|u|> and <rho x u/|u|>."""
    if abs(slip) > 3 * scene.alpha * abs(spin):
        return means_by_area(scene, slip, spin, angle)
    pivot = 1j * slip / spin
    if scene.sides:
        mean, radius = means_of_polygon(scene, corners_of(scene, angle), pivot)
    else:
        mean, radius = means_of_disk(scene, pivot)
    sign = 1 if spin > 0 else -1
    direction = 1j * sign * mean
    return direction, sign * radius + (pivot.conjugate() * direction).imag


class Floor:
    def __init__(self, entry):
        self.a = number(mpf(entry["floor_friction"]) * mpf(entry["gravity_ratio"]))
        self.carries = entry["floor"] == "dish"


def rates(scene, floor, t, y):
    _, v, angle, spin = y
    slip = v - 1j * swirl(scene, t) if floor.carries else v
    direction, moment = means(scene, slip, spin.real, angle.real)
    return numpy.array([v, -floor.a * direction, spin, -floor.a * moment / scene.inertia])


def extrapolated_with_error(rates, t, y, h):
    """And how far the last two columns are apart."""
    rows = []
    for k in range(1, ORDER + 1):
        n = 2 * k
        step = h / n
        before, here = y, y + step * rates(t, y)
        for i in range(1, n):
            before, here = here, before + 2 * step * rates(t + i * step, here)
        row = [(here + before + step * rates(t + h, here)) / 2]
        for m in range(1, k):
            row.append(row[m - 1] + (row[m - 1] - rows[-1][m - 1]) / ((number(k) / (k - m)) ** 2 - 1))
        rows.append(row)
    return rows[-1][-1], max(abs(rows[-1][-1] - rows[-1][-2]))


def extrapolated(rates, t, y, h):
    return extrapolated_with_error(rates, t, y, h)[0]


def zero_between(value, low, high):
    """Of a function of other signs at both ends, or zero at the first: the regula falsi of Illinois."""
    left, right = value(low), value(high)
    for halvings in range(1, 12):
        if left * right < 0:
            break
        low = high / 2 ** (12 - halvings)  # it begins at zero
        left = value(low)
    for _ in range(60):
        middle = (low * right - high * left) / (right - left)
        here = value(middle)
        if abs(here) < 1e-18:
            break
        if (here > 0) == (right > 0):
            high, right, left = middle, here, left / 2
        else:
            low, left, right = middle, here, right / 2
    return middle


def gaps(scene, t, y):
    centre = y[0] - swirl(scene, t)
    if not scene.sides:
        return [abs(centre) - (1 - scene.alpha)]
    return [abs(centre + arm) - 1 for arm in corners_of(scene, y[2].real)]


def impact_after(scene, floor, state, struck):
    """The flight's end, and the vertex that strikes; of steps of MACRO, on none of which one touches and leaves again."""
    exact, scene = scene, in_numbers(scene)
    t = begin = number(state.t)
    y = numpy.array([number(state.x.real) + 1j * number(state.x.imag), number(state.v.real) + 1j * number(state.v.imag),
                     number(state.angle), number(state.spin)], dtype=numpy.clongdouble)
    at = lambda h: extrapolated(lambda when, place: rates(scene, floor, when, place), t, y, number(h)) if h else y
    while max(gaps(scene, t + MACRO, after := at(MACRO))) <= 0:
        t, y = t + MACRO, after
        if t - begin > 12:
            raise ValueError("no impact")
    vertex = int(numpy.argmax(gaps(scene, t + MACRO, after)))
    low = number(MACRO) / 4 if t == begin and vertex == struck else number(0)  # it leaves the wall first
    h = zero_between(lambda h: gaps(scene, t + h, at(h))[vertex], low, number(MACRO))
    x, v, angle, spin = at(h)
    in_digits = lambda z: mpc(*(mpf(numpy.format_float_scientific(part, 25)) for part in (z.real, z.imag)))
    moved = State(in_digits(t + h).real, in_digits(x), in_digits(v), in_digits(angle).real, in_digits(spin).real)
    return Impact(moved.t - state.t, *impact_at(exact, moved, mpf(0), vertex)[1:])


def orbit(entry, text, wrapped):
    """An entry of dry_trajectories.json."""
    scene, floor = scene_of(entry), Floor(entry)
    start = {key: mpf(value) for key, value in entry["initial"].items()}
    state = State(mpf(0), mpc(start["x"], start["y"]), mpc(start["vx"], start["vy"]), start["angle"], start["spin"])
    rows, struck = [], None
    for _ in entry["collisions"]:
        impact = impact_after(scene, floor, state, struck)
        state, struck = impact.after, impact.vertex
        values = dict(zip(NAMES, (state.t, state.x.real, state.x.imag, state.v.real, state.v.imag, state.angle,
                                  state.spin)),
                      psi=wrapped(mp.arg(impact.normal) - state.t), normal_impulse=impact.p,
                      tangential_impulse=impact.q)
        rows.append({**{key: text(value, DIGITS) for key, value in values.items()}, "vertex": impact.vertex})
    return {**entry, "collisions": rows}


__all__ = ["DIGITS", "Floor", "MACRO", "PI", "extrapolated", "extrapolated_with_error", "in_numbers", "means", "number", "orbit", "swirl", "zero_between"]
