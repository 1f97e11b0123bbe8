"""Chaos, proven: where on the section the sets are that F carries over one another, and, in the coordinates of the one
that most are carried over, how they cross it."""

import numpy
from matplotlib.colors import to_rgba
from matplotlib.patches import Polygon, Rectangle

from .look import NARROW, width_of
from .style import BLACK, CYCLE, GREY, VERMILION
from .symbols import observable_label, scene_title

#: How much beyond the set is shown, in its half edges.
_ACROSS, _UPRIGHT = 1.6, 1.25
_COORDINATES = "psi", "chi", "vn", "vt", "S"
_ARROW = {"arrowstyle": "-|>", "color": GREY, "lw": 0.4, "mutation_scale": 5, "shrinkA": 1, "shrinkB": 2}


def is_of_sets(record):
    return record.has("carried", "carried_q") and len(record.column("coverings", "from")) > 0


def _together(angles):
    """Within a turn that begins in the widest gap between them."""
    sorted_angles = numpy.sort(angles)
    gaps = numpy.diff(sorted_angles, append=sorted_angles[0] + 2 * numpy.pi)
    begin = sorted_angles[(gaps.argmax() + 1) % len(angles)]
    return numpy.where(angles < begin, angles + 2 * numpy.pi, angles)


class Sets:
    """Their centres in two coordinates, which is carried over which, and the set that most are carried over."""

    def __init__(self, record):
        names = [name for name in _COORDINATES if record.has("sets", f"centre_{name}")]
        self.coordinates, self.dimension = (names[0], names[-1]), len(names)
        self.centres = numpy.stack([record.column("sets", f"centre_{name}") for name in self.coordinates], axis=-1)
        self.centres[:, 0] = _together(self.centres[:, 0])
        self.ends = [record.column("coverings", end).astype(int) - 1 for end in ("from", "to")]
        self.middle = int(numpy.bincount(self.ends[1]).argmax())
        self.carried = {name: record.column("carried", name) for name in ("covering", "q", "side", "carried_q", "carried_side")}

    def outline(self, covering):
        """The set that is carried, in the other's coordinates: along one side and back along the other."""
        ways = []
        for side in (-1, 1):
            on_it = (self.carried["covering"] == covering + 1) & (self.carried["side"] == side)
            way = numpy.stack([self.carried[name][on_it] for name in ("carried_q", "carried_side")], axis=-1)
            ways.append(way[numpy.argsort(side * self.carried["q"][on_it])])
        return numpy.concatenate(ways)


def size(_record, look):
    width = look.width or 8.0
    return width, (0.5 if width >= NARROW else 1.5) * width


def _draw_section(axes, sets):
    start, end = (sets.centres[ends] for ends in sets.ends)
    for a, b in zip(start, end):
        turn = round((b[0] - a[0]) / (2 * numpy.pi)) * 2 * numpy.pi
        if turn == 0:
            axes.annotate("", b, a, arrowprops=_ARROW)
        for shift in (0, turn) if turn else ():  # from one edge of the figure to the other: psi is an angle
            axes.plot([a[0] + shift, b[0] - turn + shift], [a[1], b[1]], "-", color=GREY, lw=0.4, zorder=0)
    axes.plot(*sets.centres.T, "o", color=BLACK, ms=2.5)
    axes.plot(*sets.centres[sets.middle], "s", color=VERMILION, ms=6)
    axes.set(xlabel=observable_label(sets.coordinates[0]), ylabel=observable_label(sets.coordinates[1]))
    axes.ticklabel_format(useOffset=False)
    low, high = sets.centres[:, 0].min(), sets.centres[:, 0].max()
    axes.set_xlim(low - 0.06 * (high - low), high + 0.06 * (high - low))
    axes.set_title(f"{len(sets.centres):,} sets, {len(sets.ends[0]):,} carried over another")


def _draw_crossings(axes, sets):
    into = numpy.flatnonzero(sets.ends[1] == sets.middle)
    is_plane = sets.dimension == 2
    for number, covering in enumerate(into):
        colour = CYCLE[number % len(CYCLE)]
        axes.add_patch(Polygon(sets.outline(covering), fc=to_rgba(colour, 0.7 if is_plane else 0.25), ec=colour, lw=0.8))
    axes.add_patch(Rectangle((-1, -1), 2, 2, fc="none", ec=VERMILION, lw=1.2))
    axes.set(xlim=(-_ACROSS, _ACROSS), ylim=(-_UPRIGHT, _UPRIGHT), xlabel="$q$, along the edge that $F$ stretches",
             ylabel="along the second edge")
    axes.set_title(f"{len(into)} sets as $F$ carries them over one" + ("" if is_plane else f", 2 of {sets.dimension} edges"))


def draw_into(figure, record, look):
    sets, chaos = record.derived(Sets), record.attributes("chaos")
    said = f"entropy ≥ {chaos['entropy']:.4g} per impact, proven" if chaos["proven"] else "no chaos proven"
    look.title(figure, f"{scene_title(record.scene())}\n{said}")
    shape = (1, 2) if width_of(figure) >= NARROW else (2, 1)
    section, crossings = figure.subplots(*shape)
    _draw_section(section, sets)
    _draw_crossings(crossings, sets)
    return [section]
