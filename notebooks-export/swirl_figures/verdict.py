"""The verdict of `classify` and what it rests on: the orbit on the section, S impact by impact, the spectrum of that, and
the evidence in words. A record without the orbit's end (a series, an orbit that ended) shows the evidence alone."""

import textwrap

import numpy
from matplotlib import rcParams
from matplotlib.colors import Normalize
from matplotlib.patches import Rectangle
from matplotlib.ticker import MaxNLocator

from .look import rows_of, side_by_side, widen, width_of
from .section import dot_size
from .style import BLACK, BLUE, MODE_COLOURS, TIMES
from .symbols import SPIN, number, observable_label, scene_title

#: Impacts whose S is drawn as a line; more are a band.
SHOWN_IMPACTS = 120


def has_verdict(record):
    return "mode" in record and "runs" not in record


def _has_orbit(record):
    return "tail" in record and len(record.column("tail", "points")) > 1


def _evidence(record):
    if not record.has("mode", "evidence"):
        return []
    return list(zip(record.names("mode", "evidence"), record.column("mode", "value"), record.column("mode", "threshold"),
                    record.names("mode", "says")))


def _limit(threshold):
    """With the digits of a threshold just below 1."""
    return f"{threshold:.6g}" if 0.9 < abs(threshold) < 1 else number(threshold)


def _lines_of(record, longest):
    """The evidence as lines: (text, whether it begins an item)."""
    lines = []
    for name, value, threshold, says in _evidence(record):
        limit = f" (threshold {_limit(threshold)})" if numpy.isfinite(threshold) else ""
        for index, line in enumerate(textwrap.wrap(f"{name}: {number(value)}{limit}. {says}", longest,
                                                   subsequent_indent="    ")):
            lines.append((line, index == 0))
    return lines


def _letters_across(width):
    return max(30, int(72 * (width - 0.4) / (0.52 * 8 / 9 * rcParams["font.size"])))


def _height_of_text(record, width):
    return 0.45 + len(_lines_of(record, _letters_across(width))) * 1.35 * 8 / 9 * rcParams["font.size"] / 72


_PANELS = 3

#: Inches that a panel needs.
_LEAST_PANEL = 2.2


def _height_of_panels(width):
    return 2.9 if rows_of(width, _PANELS, _LEAST_PANEL) == 1 else 2.2 * rows_of(width, _PANELS, _LEAST_PANEL)


def size(record, look):
    width = look.width or 9
    panels = _height_of_panels(width) if _has_orbit(record) else 0
    return width, 0.75 + panels + _height_of_text(record, width)


def _draw_section(axes, names, points):
    """psi and S, coloured by their order."""
    x, y = points[:, names.index("psi")], points[:, names.index("S")]
    axes.scatter(x, y, c=numpy.arange(len(x)), cmap=TIMES, norm=Normalize(0, len(x)), s=max(dot_size(x, y), 1.5), lw=0)
    axes.set(xlabel=observable_label("psi"), ylabel=SPIN, title="On the section")
    axes.margins(0.08)
    axes.xaxis.set_major_locator(MaxNLocator(5))
    axes.ticklabel_format(useOffset=False)
    widen(axes)


def _draw_spin(axes, first, spin):
    number_of = first + numpy.arange(len(spin))
    axes.plot(number_of[:SHOWN_IMPACTS], spin[:SHOWN_IMPACTS], "o-", ms=2, lw=0.6, color=BLUE, mec="none")
    axes.set(xlabel="impact", ylabel=SPIN, title=f"S, {min(len(spin), SHOWN_IMPACTS)} impacts")
    axes.xaxis.set_major_locator(MaxNLocator(4, integer=True))
    axes.ticklabel_format(useOffset=False)
    if numpy.ptp(spin) < 1e-9 * max(1, abs(spin).max()):
        axes.set_ylim(spin[0] - 1, spin[0] + 1)


def _draw_spectrum(axes, spin):
    """|DFT|² of S by impact, windowed (Hann): lines of a cycle or torus, a continuum of chaos."""
    wave = (spin - spin.mean()) * numpy.hanning(len(spin))
    power = abs(numpy.fft.rfft(wave)) ** 2 / len(spin)
    frequency = numpy.fft.rfftfreq(len(spin))
    axes.set(xlabel="frequency, in cycles per impact", ylabel="power of S", title="Spectrum of these S")
    if power.max() <= 1e-24 * max(1.0, (spin ** 2).sum()):
        axes.text(0.5, 0.5, "S is constant", ha="center", transform=axes.transAxes)
        axes.set(xticks=[], yticks=[])
        return
    axes.semilogy(frequency, numpy.maximum(power, power.max() * 1e-14), color=BLUE, lw=0.8)


def _headline(record):
    attributes = record.attributes("mode")
    kind, period, exponent = (attributes.get(name) for name in ("kind", "period", "largest_exponent"))
    words = [str(attributes["mode"])]
    if kind is not None and str(kind) not in ("", "none"):
        words.append(f"{kind} of period {int(period)}" if period is not None and period > 1 else str(kind))
    text = ": ".join(words)
    mean = attributes.get("mean_S", numpy.nan)
    if numpy.isfinite(mean):
        text += f"; mean spin {number(mean)}"
    if exponent is not None and numpy.isfinite(exponent):
        text += f"; largest exponent {number(exponent)} ± {number(attributes['largest_exponent_error'])} per impact"
    return text


def _write_evidence(figure, record):
    axes = figure.subplots()
    axes.axis("off")
    mode = str(record.attributes("mode")["mode"])
    axes.add_patch(Rectangle((0, 0), 0.006, 1, transform=axes.transAxes, color=MODE_COLOURS.get(mode, "0.5"), lw=0))
    lines = [("Evidence", True)] + _lines_of(record, _letters_across(width_of(figure)))
    for index, (line, begins) in enumerate(lines):
        axes.text(0.015, 1 - (index + 0.5) / len(lines), line, va="center", fontsize="small", transform=axes.transAxes,
                  color=BLACK if begins else "0.3", weight="bold" if index == 0 else "normal")


def draw_into(figure, record, look):
    look.title(figure, "\n".join(filter(None, (scene_title(record.scene()), _headline(record)))))
    if not _has_orbit(record):
        _write_evidence(figure.subfigures(1, 1), record)
        return []
    width = width_of(figure)
    above, below = figure.subfigures(2, 1, height_ratios=(_height_of_panels(width), _height_of_text(record, width)))
    names, points = [str(name) for name in record.names("tail", "coordinate")], record.column("tail", "points")
    spin = points[:, names.index("S")]
    panels = side_by_side(above, _PANELS, _LEAST_PANEL)
    _draw_section(panels[0], names, points)
    _draw_spin(panels[1], int(record.attributes("tail").get("first", 1)), spin)
    _draw_spectrum(panels[2], spin)
    _write_evidence(below, record)
    return []
