"""The modes of the built-in scenes: their mean spin and largest exponent."""

import numpy
from matplotlib.patches import Patch

from .legends import LegendBelow
from .look import is_narrow
from .style import MODE_COLOURS
from .symbols import MEAN_SPIN


def is_tour(record):
    return record.command == "tour" and bool(_scenes(record))


def _scenes(record):
    return sorted(name for name in record.groups if "mode" in record.attributes(name))


def size(record, look):
    rows = 1.3 + 0.42 * len(_scenes(record))
    width = look.width or 8
    return width, rows if width >= 5 else 1.6 * rows + 0.6


def _label(attributes, name):
    kind, period = str(attributes.get("kind", "")), attributes.get("period", 0)
    return f"{name.replace('-', ' ')}\n{kind}{f', period {int(period)}' if period > 1 else ''}"


def draw_into(figure, record, look):
    scenes = _scenes(record)
    attributes = [record.attributes(name) for name in scenes]
    modes = [str(values["mode"]) for values in attributes]
    colours = [MODE_COLOURS.get(mode, "0.5") for mode in modes]
    parts = LegendBelow(figure)
    narrow = is_narrow(figure)
    spins, exponents = parts.above.subplots(*((2, 1) if narrow else (1, 2)), sharey=not narrow)
    rows = numpy.arange(len(scenes))
    for axes, name, label in ((spins, "mean_S", f"mean spin {MEAN_SPIN}"),
                              (exponents, "largest_exponent", "largest exponent, per impact")):
        lengths = numpy.array([float(values.get(name, numpy.nan)) for values in attributes])
        axes.barh(rows, lengths, color=colours, ec="0.3", lw=0.5, height=0.65)
        for row in rows[~numpy.isfinite(lengths)]:
            axes.annotate("does not apply", (0, row), xytext=(4, 0), textcoords="offset points", va="center",
                          fontsize="small", color="0.4")
        axes.axvline(0, color="0.4", lw=0.8)
        axes.set(yticks=rows, yticklabels=[_label(values, scene) for values, scene in zip(attributes, scenes)], xlabel=label,
                 ylim=(len(scenes) - 0.4, -0.6))  # the first above; also a row without a bar is whole
        axes.margins(x=0.06)
    parts.fill([Patch(fc=MODE_COLOURS[name], ec="0.3", lw=0.5, label=name) for name in MODE_COLOURS if name in modes], look)
    look.title(figure, "The built-in scenes")
    return []
