"""A figure for each claim."""

import numpy
from matplotlib import colormaps

from swirl_figures.look import blank_figure
from swirl_figures.style import BLUE, GREY, VERMILION, styled
from swirl_figures.symbols import SPIN

from .claims import MU, OMEGA
from .sampling import NO_ATTRACTOR

_WAYS = (("time", "o", BLUE, "time mean"), ("impact", "s", VERMILION, "mean over the impacts"))


def _name(body):
    return "disk" if body == "disk" else f"N = {body}"


@styled
def of_sign(by_body, title):
    """Means of S over alpha, a panel for each body."""
    figure = blank_figure(10, 3.2)
    figure.get_layout_engine().set(rect=(0, 0.08, 1, 0.92))  # above the legend
    panels = figure.subplots(1, len(by_body), sharex=True)
    for axes, (body, (points, verdict)) in zip(panels, by_body.items()):
        for way, marker, colour, label in _WAYS:
            mean = numpy.array([point.mean[way] for point in points])
            ends = numpy.array([point.shown[way] for point in points]).T
            bars = numpy.where(numpy.isfinite(ends), abs(ends - mean), 0)
            axes.errorbar([point.place for point in points], mean, bars, fmt=marker, ms=4, mfc="none" if way == "impact" else colour,
                          color=colour, lw=1, capsize=2, label=label)
        for point in (point for point in points if point.kind in NO_ATTRACTOR):
            axes.axvspan(point.place - 0.03, point.place + 0.03, color=GREY, alpha=0.25, lw=0, label="still transient: not judged")
        axes.axhline(0, color=GREY, lw=0.8)
        axes.set(xlabel=r"$\alpha$", title=f"{_name(body)}: {verdict}")
    panels[0].set_ylabel(SPIN)
    listed = {label: handle for axes in panels for handle, label in zip(*axes.get_legend_handles_labels())}
    figure.legend(listed.values(), listed.keys(), loc="lower center", ncol=len(listed))
    figure.suptitle(title)
    return figure


@styled
def of_size(grid, title):
    """As the paper's Figure 7, and beside it S over mu."""
    figure = blank_figure(9, 3.8)
    left, right = figure.subplots(1, 2)
    colours = colormaps["cividis"]
    for mu, groups in grid.items():
        left.plot(OMEGA, [omega * group.by_time.mean() for omega, group in groups], "o-", ms=3, lw=0.9,
                  color=VERMILION if mu == 0 else colours(mu), label=rf"$\mu$ = {mu:g}")
    left.axhline(0, color=GREY, lw=0.8)
    left.set(xlabel=r"$\omega_s$", ylabel=r"mean $\omega_p$, by time", title="As Figure 7: mean rotation against swirl")
    left.legend(fontsize="x-small", ncols=2)
    for way, marker, colour, label in _WAYS:
        values = [[group.spins(way).mean() for _, group in grid[mu]] for mu in MU if mu > 0]
        right.errorbar([mu for mu in MU if mu > 0], numpy.mean(values, axis=1),
                       numpy.std(values, axis=1, ddof=1) / numpy.sqrt(len(OMEGA)) * 1.96, fmt=marker, ms=4, color=colour,
                       mfc="none" if way == "impact" else colour, lw=1, capsize=2, label=label)
    right.axhline(0, color=GREY, lw=0.8)
    right.set(xlabel=r"$\mu$", ylabel=SPIN, title=r"With friction: $S$, all $\omega_s$ together")
    right.legend()
    figure.suptitle(title)
    return figure


@styled
def of_recurrence(found, title):
    figure = blank_figure(5, 3.4)
    axes = figure.subplots()
    for place, (mode, (values, expected)) in enumerate(found.items()):
        axes.plot(numpy.full(len(values), place), numpy.maximum(values, 1e-8), "o", ms=4, color=BLUE,
                  label="runs, without the diagonal" if place == 0 else None)
        axes.plot([place - 0.25, place + 0.25], [expected or 1e-4] * 2, color=VERMILION, lw=1.2,
                  label="paper: < 10⁻⁴, 1/k, 1" if place == 0 else None)
    axes.set(yscale="log", ylabel="RC", xlim=(-0.6, len(found) - 0.4))
    axes.set_xticks(range(len(found)), list(found))
    axes.legend()
    figure.suptitle(title)
    return figure
