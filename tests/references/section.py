"""The collision map F of a polygon, in 50-digit arithmetic, on the Poincare section just after an impact:

    z = (psi, chi, vn, vt, S)   psi = arg n - t,  chi = arg r - arg n,  (vn, vt) the centre's velocity along n and t.

Rotating with the swirl removes time, so the impact that z describes is put at t = 0; the vertex that struck is number
0. Derivatives are central differences: a step h leaves an error of order h times the second derivative, which jumps
where slip ends, and a rounding of 1e-50 / h; h = 1e-25 makes both small beside a double's last digit.
"""

from mpmath import mp, mpc, mpf

from dynamics import State, next_impact, same_impact, swirl

STEP = mpf(10) ** -25
CLOSED = mpf(10) ** -40  # an iterate this near has closed; Newton's method converges quadratically, so it is far below


def wrapped(angle):
    """In (-pi, pi]."""
    return angle - 2 * mp.pi * mp.ceil((angle - mp.pi) / (2 * mp.pi))


def state_of(scene, z):
    """The laboratory's state at t = 0 whose vertex 0 has just struck."""
    psi, chi, vn, vt, spin = z
    n = mp.expj(psi)
    return State(mpf(0), swirl(scene, mpf(0)) + n - scene.alpha * mp.expj(psi + chi), n * mpc(vn, vt), psi + chi, spin)


def section_point(impact):
    v = impact.after.v * mp.conj(impact.normal)
    psi = wrapped(mp.arg(impact.normal) - impact.after.t)
    return [psi, mp.arg(impact.arm * mp.conj(impact.normal)), v.real, v.imag, impact.after.spin]


def follow(scene, z, count):
    """The impacts of the first `count` steps from z."""
    impacts, state, struck = [], state_of(scene, z), 0
    for _ in range(count):
        impacts.append(next_impact(scene, state, struck))
        state, struck = impacts[-1].after, impacts[-1].vertex
    return impacts


def returned(scene, z, itinerary):
    """F^k(z) for a neighbour of the orbit whose impacts are given."""
    state = state_of(scene, z)
    for known in itinerary:
        impact = same_impact(scene, state, known)
        state = impact.after
    return section_point(impact)


def difference(a, b):
    return [wrapped(p - q) if i < 2 else p - q for i, (p, q) in enumerate(zip(a, b))]


def derivative(scene, z, itinerary):
    """DF^k."""
    columns = []
    for i in range(5):
        ahead, behind = list(z), list(z)
        ahead[i] += STEP
        behind[i] -= STEP
        change = difference(returned(scene, ahead, itinerary), returned(scene, behind, itinerary))
        columns.append([c / (2 * STEP) for c in change])
    return mp.matrix(columns).T


def closed_cycle(scene, z, period):
    """(z, itinerary) of the k-cycle near z, by Newton's method for F^k(z) = z."""
    z = list(z)
    for _ in range(12):
        itinerary = follow(scene, z, period)
        residual = difference(section_point(itinerary[-1]), z)
        if max(abs(r) for r in residual) < CLOSED:
            return z, itinerary
        step = mp.lu_solve(derivative(scene, z, itinerary) - mp.eye(5), -mp.matrix(residual))
        z = [value + change for value, change in zip(z, step)]
    raise ArithmeticError("Newton's method for the cycle does not converge")


def multipliers(scene, z, itinerary):
    """The eigenvalues of DF^k, by falling modulus."""
    values, _ = mp.eig(derivative(scene, z, itinerary))
    return sorted((mpc(value) for value in values), key=lambda m: (-abs(m), -m.imag))
