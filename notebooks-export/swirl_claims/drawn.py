"""A figure for each claim."""

import numpy
from matplotlib import colormaps

from swirl_figures.look import blank_figure
from swirl_figures.style import BLUE, GREY, VERMILION, styled
from swirl_figures.symbols import SPIN

from .claims import MU, OMEGA, expected_recurrence, mean_of
from .sampling import NO_ATTRACTOR, RIDING

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
            there = [point for point in points if numpy.isfinite(point.mean[way])]  # by impact none where it rides
            if not there:
                continue
            mean = numpy.array([point.mean[way] for point in there])
            ends = numpy.array([point.shown[way] for point in there]).T
            bars = numpy.where(numpy.isfinite(ends), abs(ends - mean), 0)
            axes.errorbar([point.place for point in there], mean, bars, fmt=marker, ms=4, mfc="none" if way == "impact" else colour,
                          color=colour, lw=1, capsize=2, label=label)
        for kinds, shade, label in ((NO_ATTRACTOR, 0.25, "still transient: not judged"), ((RIDING,), 0.1, "rides with the floor: S = 0")):
            for point in (point for point in points if point.kind in kinds):
                axes.axvspan(point.place - 0.03, point.place + 0.03, color=GREY, alpha=shade, lw=0, label=label)
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
        values = {mu: [mean for mean in (mean_of(group.spins(way)) for _, group in grid[mu]) if numpy.isfinite(mean)] for mu in MU if mu > 0}
        values = {mu: means for mu, means in values.items() if len(means) > 1}  # by impact none where it rides
        if not values:
            continue
        right.errorbar(list(values), [numpy.mean(means) for means in values.values()],
                       [numpy.std(means, ddof=1) / numpy.sqrt(len(means)) * 1.96 for means in values.values()], fmt=marker, ms=4, color=colour,
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
    for place, attractor in enumerate(found.values()):
        expected, values = expected_recurrence(attractor), attractor.recurrence
        axes.plot(numpy.full(len(values), place), numpy.maximum(values, 1e-8), "o", ms=4, color=BLUE,
                  label="runs, without the diagonal" if place == 0 else None)
        axes.plot([place - 0.25, place + 0.25], [expected or 1e-4] * 2, color=VERMILION, lw=1.2,
                  label="paper: < 10⁻⁴, 1/k, 1" if place == 0 else None)
    axes.set(yscale="log", ylabel="RC", xlim=(-0.6, len(found) - 0.4), ylim=(5e-9, 3))
    axes.set_xticks(range(len(found)), [mode + (f"\n(now {attractor.kind})" if attractor.kind == RIDING else "")
                                        for mode, attractor in found.items()])
    axes.legend()
    figure.suptitle(title)
    return figure
