"""What a reader would see wrong in how a figure is laid out: words cut off or on one another, legends wider than their
panels, panels that are slivers."""

import itertools
import warnings

from matplotlib.backends.backend_agg import FigureCanvasAgg

from swirl_figures.room import labels_along

#: Points by which boxes of words may overlap: they are larger than the letters.
SLACK = 2.0

#: Inches that a panel is wide and high at least.
LEAST_PANEL = 0.6, 0.4


def _ticks(axis):
    """The labels of its ticks that are shown."""
    return labels_along(axis) if axis.axes.axison else []


def _words_of(figure):
    """(what they belong to, words) of all that is written outside the panels."""
    words = [(figure, text) for text in figure.texts]
    words += [(legend, text) for legend in figure.legends for text in legend.get_texts()]
    return words + [pair for part in figure.subfigs for pair in _words_of(part)]


def _words_in(axes):
    words = [(axes, text) for text in (axes.title, axes._left_title, axes._right_title, axes.xaxis.label, axes.yaxis.label)]
    words += [(axis, label) for axis in (axes.xaxis, axes.yaxis) for label in _ticks(axis)]
    words += [(text, text) for text in axes.texts]
    return words + [(axes.get_legend(), text) for text in (axes.get_legend().get_texts() if axes.get_legend() else [])]


def _named(text):
    return " / ".join(text.get_text().split("\n"))[:60]


def _overlap(one, other, slack):
    return (min(one.x1, other.x1) - max(one.x0, other.x0) > slack) and (min(one.y1, other.y1) - max(one.y0, other.y0) > slack)


def _crowded(figure, renderer, point):
    """Numbers along an axis that touch: of a few they are as one."""
    found = []
    for axis in (axis for axes in figure.axes if axes.get_visible() for axis in (axes.xaxis, axes.yaxis)):
        along = 0 if axis.axis_name == "x" else 1
        ends = sorted(((tuple(label.get_window_extent(renderer).get_points()[:, along]), label) for label in _ticks(axis)),
                      key=lambda pair: pair[0])
        if len(ends) > 2:
            found += [f"numbers that touch: {_named(one)} | {_named(other)}"
                      for ((_, end), one), ((begin, _), other) in itertools.pairwise(ends) if begin - end < point]
    return found


def _of_words(figure, renderer, point):
    """Words of one tick, legend or text belong together, and are not compared."""
    words = _words_of(figure) + [pair for axes in figure.axes if axes.get_visible() for pair in _words_in(axes)]
    boxes = [(owner, text, text.get_window_extent(renderer)) for owner, text in words
             if text.get_visible() and text.get_text().strip()]
    edge = figure.bbox
    found = [f"cut off: {_named(text)}" for _, text, box in boxes
             if min(box.x0, box.y0, edge.x1 - box.x1, edge.y1 - box.y1) < -SLACK * point]
    return found + [f"on one another: {_named(text)} | {_named(second)}"
                    for (owner, text, box), (other, second, behind) in itertools.combinations(boxes, 2)
                    if _overlap(box, behind, SLACK * point) and not (owner is other and owner in figure.legends)]


def _of_panels(figure, renderer, point):
    found = []
    for axes in figure.axes:
        width, height = axes.bbox.width / figure.dpi, axes.bbox.height / figure.dpi
        if axes.axison and axes.get_label() != "<colorbar>" and (width < LEAST_PANEL[0] or height < LEAST_PANEL[1]):
            found.append(f"a sliver: {width:.2f} x {height:.2f} inches, {_named(axes.title)}")
        if axes.get_legend():
            legend = axes.get_legend().get_window_extent(renderer)
            if legend.width > axes.bbox.width + 3 * SLACK * point:
                found.append(f"a legend wider than its panel, {_named(axes.title)}")
    return found


def faults(figure):
    """In words, of a figure that has been drawn."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        figure.draw_without_rendering()
    renderer, point = FigureCanvasAgg(figure).get_renderer(), figure.dpi / 72
    return ([str(warning.message) for warning in told] + _of_words(figure, renderer, point)
            + _crowded(figure, renderer, point) + _of_panels(figure, renderer, point))
