"""What axes and titles call the quantities of a scene."""

import math

SPIN = r"spin $S = \omega_p/\omega_s$"
MEAN_SPIN = r"$\langle S \rangle$"
TIME = r"$\omega_s t$"
ENERGY = r"Jacobi integral $J/(m R_c^2 \omega_s^2)$"

_PARAMETERS = {
    "alpha": ("α", r"$\alpha = R_p/R_c$  (size of the body)"),
    "beta": ("β", r"$\beta = r_s/R_c$  (radius of the swirl)"),
    "mu": ("μ", r"$\mu$  (friction)"),
    "restitution": ("e", r"$e$  (restitution)"),
    "inertia_factor": ("κ", r"$\kappa = I/(m R_p^2)$  (inertia)"),
    "drag": ("γ", r"$\gamma/\omega_s$  (drag of the floor)"),
    "floor_friction": ("M", r"$M$  (dry friction of the floor)"),
    "gravity_ratio": ("G", r"$G = g/R_c\omega_s^2$  (gravity)"),
    "spin_drag": ("γ_r", r"$\gamma_r/\omega_s$  (drag of the floor on the spin)"),
    "tangential_restitution": (r"$e_t$", r"$e_t$  (tangential restitution)"),
    "corner": ("r", r"$r/R_c$  (radius of rounded corners)"),
    "sides": ("N", r"$N$  (number of sides)"),
    "law": ("law", "impact law"),
    "speed": ("V", r"$V$  (speed of the starts, in $R_c\omega_s$)"),
    "x": ("x", r"$x/R_c$  (centre at the start)"),
    "y": ("y", r"$y/R_c$  (centre at the start)"),
    "vx": (r"$v_x$", r"$v_x/(R_c\omega_s)$  (velocity at the start)"),
    "vy": (r"$v_y$", r"$v_y/(R_c\omega_s)$  (velocity at the start)"),
    "angle": ("angle", "angle at the start, in radians"),
    "spin": ("S", r"$S$ at the start"),
}

_OBSERVABLES = {"psi": r"angle of the contact $\psi$, in radians", "chi": r"angle about the body $\chi$, in radians",
                "vn": r"normal velocity $v_n/(R_c\omega_s)$", "vt": r"tangential velocity $v_t/(R_c\omega_s)$", "S": SPIN}

_POLYGONS = {2: "rod", 3: "triangle", 4: "square", 5: "pentagon", 6: "hexagon", 7: "heptagon", 8: "octagon"}


def is_parameter(name):
    return name.replace("-", "_") in _PARAMETERS


def symbol(name):
    """α of alpha; what has no symbol keeps its name."""
    return _PARAMETERS.get(name.replace("-", "_"), (name, name))[0]


def axis_label(name):
    return _PARAMETERS.get(name.replace("-", "_"), (name, name))[1]


def observable_label(name):
    """A coordinate of the section."""
    return _OBSERVABLES.get(name, name)


#: Of persons, whose names a record writes like any word.
_PERSONS = (("neimark-sacker", "Neimark–Sacker"), ("chenciner", "Chenciner"))


def kind_label(kind):
    """A kind of special points or curves as documents write it."""
    for in_records, name in _PERSONS:
        kind = kind.replace(in_records, name)
    return kind


def number(value):
    """Four digits and a proper minus sign."""
    return f"{value:.4g}".replace("-", "\N{MINUS SIGN}")


def with_error(value, error):
    """"−0.05 ± 0.02": the error with one digit, two where the first is 1, the value with as many decimals; the value alone
    of an error that is 0 or none."""
    if not (math.isfinite(error) and error > 0):
        return number(value)
    power = math.floor(math.log10(error))
    decimals = max(0, (1 if error / 10**power < 1.95 else 0) - power)
    if decimals > 9:
        return number(value)
    return f"{value:.{decimals}f} ± {error:.{decimals}f}".replace("-", "\N{MINUS SIGN}")


def _body(sides):
    if sides == "disk":
        return "disk"
    return _POLYGONS.get(int(sides), f"polygon, N = {int(sides):,}")


def _uniform_inertia(sides):
    if str(sides) == "2":
        return 1 / 3
    return 0.5 if sides == "disk" else (2 + math.cos(2 * math.pi / int(sides))) / 6


def scene_title(scene, leave_out=()):
    """One line: "hexagon, α = 0.4, β = 0.5, μ = 0.5, e = 0.9, Poisson's law". A uniform body's κ is left out."""
    left_out = {name.replace("-", "_") for name in leave_out}
    parts = []
    if "sides" in scene and "sides" not in left_out:
        parts.append(_body(scene["sides"]))
    for name in ("alpha", "beta", "mu", "restitution"):
        if name in scene and name not in left_out:
            parts.append(f"{symbol(name)} = {number(scene[name])}")
    if "law" in scene and "law" not in left_out:
        parts.append(f"{str(scene['law']).capitalize()}'s law")
    inertia = scene.get("inertia_factor", "uniform")  # of a sweep over N it is that word, or was given
    if not isinstance(inertia, str) and "inertia_factor" not in left_out:
        known = "sides" in scene and "sides" not in left_out
        if not known or abs(inertia - _uniform_inertia(scene["sides"])) > 1e-9:
            parts.append(f"κ = {number(inertia)}")
    for name in ("drag", "spin_drag", "floor_friction", "gravity_ratio", "tangential_restitution", "corner"):
        if name in scene and name not in left_out:
            parts.append(f"{symbol(name)} = {number(scene[name])}")
    if scene.get("floor") == "table":
        parts.append("on a table")
    return ", ".join(parts)
