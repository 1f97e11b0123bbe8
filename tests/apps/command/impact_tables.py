"""Tables of impacts with a known truth, for `swirl fit`: Routh's diagram followed piece by piece, in plain Python.

The wall lies along x, y points from it to the body; velocities are (v_x, v_y, S), r is the offset from the centre to the
contact, k = I/m."""

import math
import random

HEADER = "vx_before,vy_before,spin_before,vx_after,vy_after,spin_after,rx,ry"


def _pieces(u, r, k, mu):
    """Straight pieces of the path of the contact's velocity over p: (p where it begins, C there, dC/dp, dq/dp), C = u_y."""
    b1, b2, b3 = 1 + r[1] ** 2 / k, 1 + r[0] ** 2 / k, -r[0] * r[1] / k  # u_x = b1 q + b3 p, u_y = b3 q + b2 p
    held = abs(b3) <= mu * b1
    sign = math.copysign(1, u[0]) if u[0] else 0
    first = -mu * sign
    towards_rest = sign * (b1 * first + b3)  # d|u_x|/dp
    pieces = [(0.0, u[1], b3 * first + b2, first)]
    if towards_rest < 0:
        kink = -abs(u[0]) / towards_rest
        after = -b3 / b1 if held else mu * sign
        pieces.append((kink, u[1] + kink * pieces[0][2], b3 * after + b2, after))
    return pieces


def _c_at(pieces, p):
    begin, c, slope, _ = [piece for piece in pieces if piece[0] <= p][-1]
    return c + slope * (p - begin)


def _q_at(pieces, p):
    q = 0.0
    for piece, following in zip(pieces, pieces[1:] + [(math.inf,)]):
        if p > piece[0]:
            q += piece[3] * (min(p, following[0]) - piece[0])
    return q


def _work(pieces, begin, end):
    """∫ C dp, C being straight between the kinks."""
    places = sorted({begin, end, *(piece[0] for piece in pieces if begin < piece[0] < end)})
    return sum(0.5 * (_c_at(pieces, a) + _c_at(pieces, b)) * (b - a) for a, b in zip(places, places[1:]))


def _root(function, low):
    """The p at which a function that is negative at `low` turns positive, by doubling and bisection."""
    high = low + 1.0
    while function(high) < 0:
        high = low + 2 * (high - low)
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return 0.5 * (low + high)


def after(before, r, k, e, mu, law="poisson"):
    """The velocity after the impact."""
    u = (before[0] - r[1] * before[2], before[1] + r[0] * before[2])
    pieces = _pieces(u, r, k, mu)
    compressed = _root(lambda p: _c_at(pieces, p), 0.0)
    if law == "poisson":
        p = (1 + e) * compressed
    elif law == "newton":
        p = _root(lambda p: _c_at(pieces, p) + e * u[1], compressed) if e > 0 else compressed
    else:
        work = _work(pieces, 0.0, compressed)
        p = _root(lambda p: _work(pieces, compressed, p) + e * e * work, compressed) if e > 0 else compressed
    q = _q_at(pieces, p)
    return (before[0] + q, before[1] + p, before[2] + (r[0] * p - r[1] * q) / k)


def impacts(count, k=0.4, e=0.7, mu=0.3, law="poisson", seed=1, slip=0.8, spin=1.0, reach=0.6, noise=0.0, spin_noise=None):
    """Rows of a table, those of a body of unit radius: contacts up to `reach` radians beside the centre, speeds about 1,
    noise of each velocity and (noise/√k unless said otherwise) of each spin."""
    draw, rows = random.Random(seed), []
    if spin_noise is None:
        spin_noise = noise / math.sqrt(k)
    while len(rows) < count:
        chi = draw.uniform(-reach, reach)
        r = (math.sin(chi), -math.cos(chi))
        before = (slip * draw.gauss(0, 1), -1 + 0.4 * draw.gauss(0, 1), spin * draw.gauss(0, 1))
        if before[1] + r[0] * before[2] > -0.2:
            continue
        velocities = before + after(before, r, k, e, mu, law)
        errors = (noise, noise, spin_noise) * 2
        rows.append(tuple(v + error * draw.gauss(0, 1) for v, error in zip(velocities, errors)) + r)
    return rows


def table(rows, header=HEADER):
    return header + "\n" + "".join(",".join(f"{value:.9g}" for value in row) + "\n" for row in rows)
