"""The steady modes of a scene, known in closed form: S against the flight time, by branch and stability."""

import numpy
from matplotlib.lines import Line2D

from .legends import LegendBelow
from .record import RecordError
from .style import BLUE, VERMILION
from .symbols import SPIN, scene_title

_BRANCHES = {"+": (VERMILION, "^", "+ branch: outer side, ψ near 0"),
             "-": (BLUE, "o", "\N{MINUS SIGN} branch: inner side, ψ near π")}
_FILLS = {"stable": "full", "neutral": "left", "unstable": "none"}


def size(record, look):
    return look.width or 6.5, 4.6


def _draw_modes(axes, record):
    """Branch and stability of what was drawn."""
    if not record.has("steady_modes", "tau"):
        return set(), set()
    tau, spin = record.column("steady_modes", "tau"), record.column("steady_modes", "S")
    branch, stability = record.names("steady_modes", "branch"), record.names("steady_modes", "stability")
    for name, (colour, marker, _) in _BRANCHES.items():
        for state, fill in _FILLS.items():
            of = (branch == name) & (stability == state)
            axes.plot(tau[of], spin[of], ls="", marker=marker, ms=5.5, color=colour, fillstyle=fill,
                      markerfacecoloralt="white")
    return set(branch), set(stability)


def _draw_families(axes, record):
    """A family's range of flight times, at the S of its middle member."""
    if "families" not in record:
        return set(), set()
    begin, end = (record.column("families", f"{which}_return_time") for which in ("shortest", "longest"))
    spin, branch = record.column("families", "midway_S"), record.names("families", "branch")
    stability = record.names("families", "midway_stability")
    for a, b, s, name, state in zip(begin, end, spin, branch, stability):
        colour, marker, _ = _BRANCHES[name]
        axes.plot([a, b], [s, s], color=colour, lw=2, alpha=0.5, solid_capstyle="butt")
        axes.plot((a + b) / 2, s, ls="", marker=marker, ms=6.5, color=colour, fillstyle=_FILLS.get(state, "none"),
                  markerfacecoloralt="white")
    return set(branch), set(stability) & set(_FILLS)


def _handles(branches, states, families, free):
    handles = [Line2D([], [], ls="", marker=marker, ms=5.5, color=colour, label=label)
               for name, (colour, marker, label) in _BRANCHES.items() if name in branches]
    handles += [Line2D([], [], ls="", marker="o", ms=5.5, color="0.3", fillstyle=fill, markerfacecoloralt="white",
                       label=name) for name, fill in _FILLS.items() if name in states]
    if families:
        what = "S is free" if free else "S of its middle"
        handles.append(Line2D([], [], color="0.3", lw=2, alpha=0.5, label=f"a family: its flight times, {what}"))
    return handles


def draw_into(figure, record, look):
    parts = LegendBelow(figure)
    axes = parts.above.subplots()
    modes, families = _draw_modes(axes, record), _draw_families(axes, record)
    if not modes[0] and not families[0]:
        why = str(record.attributes("facts").get("none_exist", ""))
        raise RecordError(f"record '{record.path}' holds no steady modes{f' ({why})' if why else ''}: there is nothing to "
                          "draw")
    axes.axhline(0, color="0.8", lw=0.7, zorder=0)
    axes.set(xlabel=r"flight time $\omega_s\tau$", ylabel=SPIN)
    axes.margins(0.04)
    parts.fill(_handles(modes[0] | families[0], modes[1] | families[1], bool(families[0]),
                        bool(families[0]) and bool(record.column("families", "S_is_free").any())), look)
    facts = record.attributes("facts")
    complete = facts.get("complete_to")
    limit = f"\nall steady modes with $\\omega_s\\tau \\leq$ {complete:g}" if complete is not None else ""
    look.title(figure, scene_title(record.scene()) + limit)
    return [axes]
