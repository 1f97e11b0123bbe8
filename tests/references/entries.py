"""The entries of the reference files, each recomputed from its own scene and start: orbits, also in contact,
cycles and steady modes."""

from mpmath import mp, mpc, mpf

import corners
import dragged
import dragged_contact
import dry
import dry_contact
import dry_wall
import tangential
from contact_motion import contact_orbit
from dynamics import State, next_impact, same_impact, scene_of
from fixed_points import all_fixed_points, solved
from section import closed_cycle, difference, multipliers, section_point, wrapped
from steady import confirmed, elastic_time, section_point_of

NAMES = ("psi", "chi", "vn", "vt", "S")
ORBIT_DIGITS, CYCLE_DIGITS, FIXED_POINT_DIGITS, CONTACT_DIGITS = 25, 18, 25, 18
NUDGE = mpf(10) ** -34  # of a start; times the growth it stays small, and 1e-50 beside it smaller than a double's eps


def text(value, digits):
    return mp.nstr(value, digits)


def digits_of(entry):
    """Significant digits of the decimal strings of an entry."""
    if "floor_friction" in entry:
        return dry.DIGITS
    if "collisions" in entry:
        return ORBIT_DIGITS
    if "event" in entry:
        return dragged_contact.DIGITS
    if "samples" in entry:
        return CONTACT_DIGITS
    return FIXED_POINT_DIGITS if "branch" in entry else CYCLE_DIGITS


def state_row(state):
    return [state.t, state.x.real, state.x.imag, state.v.real, state.v.imag, state.angle, state.spin]


def nudged(state):
    """Six neighbours, each ahead in one of x, y, vx, vy, angle, spin."""
    return [state._replace(x=state.x + NUDGE), state._replace(x=state.x + 1j * NUDGE),
            state._replace(v=state.v + NUDGE), state._replace(v=state.v + 1j * NUDGE),
            state._replace(angle=state.angle + NUDGE), state._replace(spin=state.spin + NUDGE)]


def growth(state, neighbours):
    """The largest growth of an error of the start: the spectral norm of d(t, x, y, vx, vy, angle, spin) / d(start)."""
    here = state_row(state)
    columns = [[(b - a) / NUDGE for a, b in zip(here, state_row(there))] for there in neighbours]
    return float(max(mp.svd_r(mp.matrix(columns), compute_uv=False)))


def orbit(entry):
    """An entry of trajectories.json, of dragged_, tangential_ or corner_trajectories.json."""
    following, again = next_impact, same_impact
    if "drag" in entry:
        floor = dragged.floor_of(entry)
        following = lambda scene, *rest: dragged.next_impact(scene, floor, *rest)
        again = lambda scene, *rest: dragged.same_impact(scene, floor, *rest)
    returns = "tangential_restitution" in entry
    if returns:
        returned = tangential.returned_of(entry)
        following = lambda scene, *rest: tangential.next_impact(scene, returned, *rest)
        again = lambda scene, *rest: tangential.same_impact(scene, returned, *rest)
    scene = scene_of(entry)
    if "corner" in entry:
        corner = corners.corner_of(entry)
        scene = corners.with_moment(scene, corner)
        following = lambda scene, *rest: corners.next_impact(scene, corner, *rest)
        again = lambda scene, *rest: corners.same_impact(scene, corner, *rest)
    start = {key: mpf(value) for key, value in entry["initial"].items()}
    state = State(mpf(0), mpc(start["x"], start["y"]), mpc(start["vx"], start["vy"]), start["angle"], start["spin"])
    neighbours, rows, struck = nudged(state), [], None
    for _ in entry["collisions"]:
        impact = following(scene, state, struck)
        neighbours = [again(scene, neighbour, impact).after for neighbour in neighbours]
        state, struck = impact.after, impact.vertex
        values = dict(zip(("t", "x", "y", "vx", "vy", "angle", "spin"), state_row(state)),
                      psi=wrapped(mp.arg(impact.normal) - state.t), normal_impulse=impact.p,
                      tangential_impulse=impact.q)
        row = {key: text(value, ORBIT_DIGITS) for key, value in values.items()}
        extra = {"slides": bool(tangential.slides(scene, impact))} if returns else {}
        rows.append({**row, "vertex": impact.vertex, **extra, "amplification": growth(state, neighbours)})
    return {**entry, "collisions": rows}


def with_point(entry, scene, z, itinerary, digits):
    """An entry with the point, return time and multipliers of a cycle."""
    values = multipliers(scene, z, itinerary)
    computed = {"return_time": text(itinerary[-1].after.t, digits),
                "point": {name: text(value, digits) for name, value in zip(NAMES, z)},
                "multipliers": [[float(m.real), float(m.imag)] for m in values]}
    if "stable" in entry:
        computed["stable"] = bool(abs(values[0]) < 1)
    if "residual" in entry:
        computed["residual"] = float(max(abs(d) for d in difference(section_point(itinerary[-1]), z)))
    return {**entry, **computed}


def cycle(entry):
    """An entry of cycles.json: the cycle near its point."""
    scene = scene_of(entry)
    z, itinerary = closed_cycle(scene, [mpf(entry["point"][name]) for name in NAMES], entry["period"])
    return with_point(entry, scene, z, itinerary, CYCLE_DIGITS)


def confirmed_entry(entry, scene, z, digits):
    impact = confirmed(scene, z, entry["j"])
    if impact is None:
        raise ArithmeticError(f"F does not return to the steady mode j = {entry['j']}, tau = {entry['return_time']}")
    return with_point(entry, scene, z, [impact], digits)


def elastic_mode(entry):
    """An entry of steady_e1.json: the steady mode with its j and a flight time near its own, from the closed form."""
    scene, branch = scene_of(entry), 1 if abs(mpf(entry["point"]["psi"])) < 1 else -1
    tau = elastic_time(scene, mpf(entry["return_time"]), branch, entry["j"])
    return confirmed_entry(entry, scene, section_point_of(scene, tau, mpf(0), branch, entry["j"]), CYCLE_DIGITS)


def fixed_point(entry):
    """An entry of fixed_points.json: the solution of the two equations near its tau and chi."""
    scene, branch, j = scene_of(entry), entry["branch"], entry["j"]
    solution = solved(scene, branch, mpf(entry["return_time"]), mpf(entry["point"]["chi"]), j)
    if solution is None:
        raise ArithmeticError(f"no steady mode j = {j} near tau = {entry['return_time']}")
    return confirmed_entry(entry, scene, section_point_of(scene, *solution, branch, j), FIXED_POINT_DIGITS)


def searched_fixed_points(scene_fields, longest):
    """All entries of fixed_points.json, found without it: the + branch, then the - branch, by rising flight time."""
    scene = scene_of(scene_fields)
    return [confirmed_entry({**scene_fields, "period": 1, "branch": branch, "j": j, "return_time": text(tau, 9),
                             "stable": None}, scene, z, FIXED_POINT_DIGITS)
            for branch in (1, -1) for j, tau, z in all_fixed_points(scene, longest, branch)]


def recomputed(entry):
    if "floor_friction" in entry and "support" in entry:
        return dry_wall.polygon_contact_over_dry_floor(entry, text)
    if "floor_friction" in entry and "event" in entry:
        return dry_contact.contact_motion_over_dry_floor(entry, text)
    if "floor_friction" in entry:
        return dry.orbit(entry, text, wrapped)
    if "collisions" in entry:
        return orbit(entry)
    if "event" in entry:
        return dragged_contact.contact_motion_over_floor(entry)
    if "samples" in entry:
        return contact_orbit(entry, CONTACT_DIGITS)
    if "branch" in entry:
        return fixed_point(entry)
    return elastic_mode(entry) if "j" in entry else cycle(entry)
