"""A plane of two parameters in cells with a proven number of fixed points, coloured by how many of them attract; what is
not proven, a cover of the curves, is black."""

import matplotlib
import numpy
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_hex
from matplotlib.patches import Patch

from .legends import LegendBelow
from .mode_map import NO_VALUE
from .style import BLACK
from .symbols import axis_label, scene_title


class Cells:
    """The cells of a record: their corners, what is proven of them, and why the others are not."""

    def __init__(self, record):
        settings = record.attributes("settings")
        self.axes = [str(settings[name]).replace("-", "_") for name in ("first", "second")]
        self.limits = [(float(settings[f"{name}_low"]), float(settings[f"{name}_high"])) for name in ("first", "second")]
        self.scene = record.scene()
        self.max_time = float(settings["max_time"])
        self.proven_area = float(record.attribute("result", "proven_area"))
        edges = {name: record.column("cells", name) for name in ("first_low", "first_high", "second_low", "second_high")}
        self.corners = numpy.stack([numpy.stack([edges[f"first_{a}"], edges[f"second_{b}"]], axis=-1)
                                    for a, b in (("low", "low"), ("high", "low"), ("high", "high"), ("low", "high"))], axis=1)
        self.proven = record.column("cells", "proven") != 0
        self.attracting = record.column("cells", "attracting")
        self.looked_at = numpy.array(record.names("cells", "doubt")) != "not-looked-at"


def is_of_cells(record):
    return "cells" in record and record.has("cells", "attracting")


def _colours(counts):
    """From pale to dark by the number of attracting modes, none of them near the cover's black."""
    shades = matplotlib.colormaps["YlGnBu"](numpy.linspace(0.08, 0.85, max(2, len(counts))))
    return {count: to_hex(shade) for count, shade in zip(counts, shades)}


def size(_record, look):
    width = look.width or 7.0
    return width, 0.85 * width


def draw_into(figure, record, look):
    cells = record.derived(Cells)
    look.title(figure, f"{scene_title(cells.scene, leave_out=cells.axes)}\n{100 * cells.proven_area:.3g} % of the plane proven, "
                       f"fixed points with τ ≤ {cells.max_time:g}")
    colours = _colours(sorted(set(cells.attracting[cells.proven])))
    faces = numpy.where(cells.looked_at, BLACK, NO_VALUE).astype(object)
    for count, colour in colours.items():
        faces[cells.proven & (cells.attracting == count)] = colour
    handles = [Patch(fc=colour, ec="0.3", lw=0.5, label=f"{count} attracting") for count, colour in colours.items()]
    handles.append(Patch(fc=BLACK, ec="0.3", lw=0.5, label="not proven: holds all curves"))
    if not cells.looked_at.all():
        handles.append(Patch(fc=NO_VALUE, ec="0.3", lw=0.5, label="interrupted: not looked at"))
    parts = LegendBelow(figure)
    parts.fill(handles, look)
    axes = parts.above.subplots()
    # Within a vector file they are an image: the white beneath would shine through between cells side by side.
    axes.add_collection(PolyCollection(cells.corners, facecolors=list(faces), edgecolors="none", antialiased=False,
                                       rasterized=True))
    axes.set(xlim=cells.limits[0], ylim=cells.limits[1], xlabel=axis_label(cells.axes[0]), ylabel=axis_label(cells.axes[1]))
    for spine in axes.spines.values():
        spine.set_visible(True)
    return [axes]
