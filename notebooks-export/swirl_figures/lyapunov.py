"""Lyapunov exponents with their errors, and the running means that they come from."""

import numpy
from matplotlib.ticker import MaxNLocator

from .look import side_by_side
from .style import CYCLE
from .symbols import number, scene_title

#: The last half of the running means sets the ordinates: the first ones are as far off as they like.
_SETTLED = 0.5


def size(record, look):
    width = look.width or 7.5
    return width, 4.0 if width >= 5 else 5.6


def _ordinates(exponents, errors, means):
    """(least, most) that show what the means settle on."""
    kept = means[int(_SETTLED * len(means)):]
    values = numpy.concatenate([exponents, exponents + 3 * errors, exponents - 3 * errors, kept.ravel(), [0]])
    values = values[numpy.isfinite(values)]
    margin = 0.12 * (numpy.ptp(values) or 1)
    return values.min() - margin, values.max() + margin


def _draw_convergence(axes, record, exponents):
    counted, means = record.column("lyapunov", "checkpoint"), record.column("lyapunov", "convergence")
    for index, colour in zip(range(means.shape[1]), CYCLE):
        axes.semilogx(counted, numpy.where(numpy.isfinite(means[:, index]), means[:, index], numpy.nan), color=colour, lw=1.1)
        if numpy.isfinite(exponents[index]):
            axes.axhline(exponents[index], color=colour, lw=0.6, ls=(0, (2, 2)), zorder=0)
    axes.set(xlabel="impacts counted", ylabel="running mean, per impact", title="Convergence (dotted: the result)")


def _draw_exponents(axes, exponents, errors, low):
    for index, colour in zip(range(len(exponents)), CYCLE):
        if numpy.isfinite(exponents[index]):
            error = 3 * errors[index] if numpy.isfinite(errors[index]) else 0
            axes.errorbar(index + 1, exponents[index], yerr=error, fmt="o", ms=4.5, color=colour, capsize=2.5)
            axes.annotate(number(exponents[index]), (index + 1, exponents[index]), xytext=(6, 0),
                          textcoords="offset points", va="center", fontsize="small", rotation=90)
        else:
            axes.plot(index + 1, low, marker="v", ms=6, color=colour, clip_on=False)
            axes.annotate("\N{MINUS SIGN}\N{INFINITY}", (index + 1, low), xytext=(0, 7), textcoords="offset points",
                          ha="center", fontsize="small")
    axes.xaxis.set_major_locator(MaxNLocator(integer=True))
    axes.set(xlabel="number of the exponent", ylabel="exponent, per impact", xlim=(0.5, len(exponents) + 0.8),
             title="The spectrum (bars: 3 standard errors)")


def draw_into(figure, record, look):
    exponents, errors = record.column("lyapunov", "exponents"), record.column("lyapunov", "standard_errors")
    convergence, spectrum = side_by_side(figure, 2, 2.6)
    _draw_convergence(convergence, record, exponents)
    low, high = _ordinates(exponents, errors, record.column("lyapunov", "convergence"))
    _draw_exponents(spectrum, exponents, errors, low)
    for axes in (convergence, spectrum):
        axes.axhline(0, color="0.6", lw=0.8, zorder=0)
        axes.set_ylim(low, high)
    steps = record.attributes("result").get("steps")
    count = f"\n{int(steps):,} impacts" if steps is not None else ""
    look.title(figure, scene_title(record.scene()) + count)
    return [convergence]
