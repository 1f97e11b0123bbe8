"""A power spectrum with its peaks."""

import numpy
from matplotlib import rcParams
from matplotlib.lines import Line2D

from .legends import LegendBelow, fits_across
from .ranges import inside, part, require
from .style import BLUE, GREY, ORANGE, VERMILION
from .symbols import number, scene_title
from .thinning import thinned

#: A peak with less scatter between segments than this is drawn as a line, another as part of a continuum.
LINE_SPREAD = 0.5

#: So many of the strongest peaks have their frequency written, where there is room.
NAMED_PEAKS = 6

#: Power below this share of the greatest is rounding, and would flatten the rest.
_LEAST_POWER = 1e-14


def size(record, look):
    return look.width or 7.5, 4.4


def _frequency_label(record):
    if record.column_attributes("spectrum", "frequency").get("units") == "omega_s":
        return r"frequency $f/f_s$, $f_s = \omega_s/2\pi$"
    return "frequency, in cycles per unit of time"


def _observable(record):
    settings = record.attributes("settings")
    return str(settings.get("observable", "S" if "scene" in record else "the series"))


def _name_peaks(axes, frequency, height, named):
    """Numbers at the strongest peaks, the stronger first, left out where they would lie on one another."""
    begin, end = axes.get_xlim()
    done = []
    for f, top in zip(frequency[named], height[named]):
        if begin <= f <= end and all(abs(f - other) > 0.035 * (end - begin) for other in done) and len(done) < NAMED_PEAKS:
            axes.annotate(number(f), (f, top), xytext=(0, 5), textcoords="offset points", rotation=90, ha="center",
                          va="bottom", fontsize="small")
            done.append(f)


def _range_of_power(frequency, power):
    """The frequencies that carry all but a thousandth of the power, and a margin; negative ones of a two-sided spectrum."""
    total = numpy.cumsum(power) / power.sum()
    least = frequency[numpy.searchsorted(total, 0.0005)] if frequency[0] < 0 else 0
    most = frequency[min(numpy.searchsorted(total, 0.9995), len(frequency) - 1)]
    margin = 0.15 * (most - least)
    return max(least - margin, frequency[0]), min(most + margin, frequency[-1])


def _is_folded(record, seen):
    """Of a cycle: which peaks are harmonics above the highest frequency, that bins of their own width fold back below it."""
    if not record.has("peaks", "folded"):
        return numpy.zeros(seen.sum(), dtype=bool)
    return record.column("peaks", "folded").astype(bool)[seen]


def _sorts(record, is_line, folded):
    """(which, colour, name) of the peaks: of a cycle its harmonics, and what is folded; else lines, and peaks of a continuum."""
    fundamental = record.attributes("spectrum").get("fundamental", numpy.nan)
    if numpy.isfinite(fundamental):
        return ((~folded, VERMILION, f"harmonic of the cycle's {number(fundamental)}"), (folded, GREY, "harmonic folded by the bins"))
    return ((is_line, VERMILION, "line"), (~is_line, ORANGE, "peak of a continuum"))


def _draw_peaks(axes, record, frequency, power, xlim):
    """Handles of the legend."""
    if "peaks" not in record:
        return []
    seen = inside(record.column("peaks", "frequency"), xlim)
    place, spread, variance = (record.column("peaks", name)[seen] for name in ("frequency", "spread", "power"))
    height = numpy.interp(place, frequency, power)
    height = numpy.maximum(height, power[numpy.clip(numpy.searchsorted(frequency, place), 1, len(power) - 1)])
    height = numpy.maximum(height, power[numpy.clip(numpy.searchsorted(frequency, place) - 1, 0, len(power) - 1)])
    handles, folded = [], _is_folded(record, seen)
    for of, colour, name in _sorts(record, spread < LINE_SPREAD, folded):
        if of.any():
            style = {"ls": "", "marker": "v", "ms": 3.5 if colour != GREY else 2, "mec": "none", "color": colour}
            axes.plot(place[of], height[of] * 1.25, **style)
            handles.append(Line2D([], [], label=f"{name} ({of.sum():,})", **style))
    strongest = numpy.argsort(-variance, kind="stable")
    _name_peaks(axes, place, height * 1.25, strongest[~folded[strongest]])
    return handles


def _verdict(record):
    attributes = record.attributes("spectrum")
    share, entropy = attributes.get("line_fraction", numpy.nan), attributes.get("entropy", numpy.nan)
    verdict = str(attributes.get("verdict", ""))
    parts = [verdict]
    if numpy.isfinite(share) and verdict != "constant":
        parts.append(f"{100 * share:.4g} % of the variance in lines")
    if numpy.isfinite(entropy):
        parts.append(f"spectral entropy {number(entropy)}")
    return "; ".join(filter(None, parts))


def _tell_what_is_left_out(axes, look, frequency, xlim):
    """Frequencies that hardly have power are left out where no range is asked for; in the figure, too, where the words have
    room."""
    if look.xlim or (xlim[0] <= frequency[0] and xlim[1] >= frequency[-1]):
        return
    words = f"99.9 % of the power; frequencies go up to {number(frequency[-1])}"
    if fits_across(axes, words, 8 / 9 * rcParams["font.size"]):
        axes.set_title(words, fontsize="small", color="0.25", loc="right", pad=2)
    begin = f"from {number(xlim[0])} " if xlim[0] < 0 else ""
    whole = f"from {number(frequency[0])} " if frequency[0] < 0 else "up "
    look.notes.append(f"Shown are the frequencies {begin}up to {number(xlim[1])}, in which 99.9 % of the power lies; the record "
                      f"has them {whole}to {number(frequency[-1])}.")


def _draw_power(axes, record, look, frequency, power):
    """Handles of the legend."""
    floor, xlim = power.max() * _LEAST_POWER, look.xlim or _range_of_power(frequency, power)
    shown, seen = part(frequency, xlim), (power > 0) & inside(frequency, xlim)
    require(seen.any(), look, record, "frequency", frequency)
    axes.semilogy(*thinned(frequency[shown], numpy.maximum(power, floor)[shown]), color=BLUE, lw=0.8)
    axes.set_xlim(xlim)
    axes.set_ylim(max(power[seen].min(), floor) * 0.5, power[seen].max() * 300)
    _tell_what_is_left_out(axes, look, frequency, xlim)
    return [Line2D([], [], color=BLUE, lw=0.9, label="power density"),
            *_draw_peaks(axes, record, frequency, power, xlim)]


def draw_into(figure, record, look):
    """Of a constant quantity, which has no power at any frequency, these words alone: no numbers along the axes."""
    frequency, power = record.column("spectrum", "frequency"), record.column("spectrum", "power")
    look.title(figure, "\n".join(filter(None, (scene_title(record.scene()), _verdict(record)))))
    if (power > 0).any():
        parts = LegendBelow(figure)
        axes = parts.above.subplots()
        parts.fill(_draw_power(axes, record, look, frequency, power), look)
    else:
        axes = figure.subplots()
        axes.text(0.5, 0.5, f"{_observable(record)} is constant", ha="center", transform=axes.transAxes)
        axes.set(xticks=[], yticks=[])
    axes.set(xlabel=_frequency_label(record), ylabel=f"power of {_observable(record)} per unit of frequency")
    return [axes]
