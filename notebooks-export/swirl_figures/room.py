"""Whether a figure has room for its words: of numbers along an axis that touch, fewer are shown; a label that is wider than
its panel is broken into lines; and a figure that would cut words off, print them on one another, or leave a panel no room, is
refused."""

import itertools
import re
import warnings

from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.ticker import MaxNLocator

from .look import width_of
from .record import RecordError
from .words import broken, letters_in

#: A figure whose width is given is for a page, of A4 or US letter: it is no higher, in inches.
PAGE = 11.0

#: Letters that a panel is wide and high at least.
_LEAST_PANEL = 5.0, 3.5

#: Points by which words may seem to reach over the edge: boxes of letters are wider than the letters.
_SLACK = 2.0


class _NoRoom(Exception):
    """A panel whose shape is given has no side left that is longer than zero."""


def _lay_out(figure):
    """False where matplotlib says that it cannot."""
    with warnings.catch_warnings(record=True) as told:
        warnings.simplefilter("always")
        try:
            figure.draw_without_rendering()
        except ValueError as error:
            if "aspect" not in str(error):
                raise
            raise _NoRoom from error
    return not told


def labels_along(axis):
    """The labels of its ticks that are shown, in order, once the figure has been laid out."""
    if not axis.get_visible():
        return []
    shown = axis.get_transform().transform  # of a logarithmic axis the logarithm
    begin, end = sorted(shown(axis.get_view_interval()))
    slack = 1e-10 * (end - begin)
    ticks = [tick for tick in (*axis.get_major_ticks(), *axis.get_minor_ticks())
             if begin - slack <= shown(tick.get_loc()) <= end + slack]
    labels = [tick.label1 for tick in ticks]
    return [label for label in labels if label.get_visible() and label.get_text().strip()]


#: A number, as axes write them; words are not thinned.
_NUMBER = re.compile(r"[\d.,\N{MINUS SIGN}+e-]+|\$\\mathdefault\{.*\}\$")


def _are_numbers(axis):
    return all(_NUMBER.fullmatch(label.get_text().strip()) for label in labels_along(axis))


def _touch(axis, renderer, gap):
    ends = [label.get_window_extent(renderer).get_points()[:, 0 if axis.axis_name == "x" else 1]
            for label in labels_along(axis)]
    ends.sort(key=lambda pair: pair[0])
    return any(behind[0] - before[1] < gap for before, behind in itertools.pairwise(ends))


def _show_fewer(axis):
    locator = axis.get_major_locator()
    if isinstance(locator, MaxNLocator):
        locator.set_params(nbins=max(1, len(labels_along(axis)) - 2))
    else:  # every second, of ticks at places of their own and of powers of ten; one beyond the axis would lengthen it
        begin, end = sorted(axis.get_view_interval())
        places = axis.get_majorticklocs()
        axis.set_ticks(places[(places >= begin) & (places <= end)][::2])


#: Between neighbouring numbers, in heights of a letter.
_GAP = 0.4


def _thin_numbers(figure, renderer, letters):
    """Until none touch, or two are left."""
    for _ in range(6):
        crowded = [axis for axes in figure.axes if axes.get_visible() and axes.axison for axis in (axes.xaxis, axes.yaxis)
                   if len(labels_along(axis)) > 2 and _are_numbers(axis) and _touch(axis, renderer, _GAP * letters * figure.dpi / 72)]
        if not crowded:
            return
        for axis in crowded:
            _show_fewer(axis)
        _lay_out(figure)


def _spare(panel, panels, figure, axis):
    """How long a label in the middle of a panel's side may be: half-way to the next panels, or to the edges."""
    low, high = panel.bbox.get_points()[:, axis]
    first, last = panel.bbox.get_points()[:, 1 - axis]
    beside = [other.bbox.get_points()[:, axis] for other in panels if other is not panel
              and other.bbox.get_points()[0, 1 - axis] < last and other.bbox.get_points()[1, 1 - axis] > first]
    before = min([low, *((low - end) / 2 for _, end in beside if end <= low)])
    behind = min([figure.bbox.get_points()[1, axis] - high, *((begin - high) / 2 for begin, _ in beside if begin >= high)])
    return high - low + 2 * min(before, behind)


def _break_labels(figure, renderer):
    """True if there was a label to break."""
    changed = False
    panels = [axes for axes in figure.axes if axes.get_visible()]
    for axes in panels:
        for axis, labels in ((0, (axes.title, axes.xaxis.label)), (1, (axes.yaxis.label,))):
            for label in labels:
                box = label.get_window_extent(renderer)
                length, spare = (box.width, box.height)[axis], _spare(axes, panels, figure, axis)
                if label.get_text() and length > spare:
                    longest = max(map(letters_in, label.get_text().split("\n"))) * spare / length
                    label.set_text(broken(label.get_text().replace("\n", " "), longest))
                    changed = True
    return changed


def _words_outside_panels(figure):
    """Titles, and the legends below."""
    own = [*figure.texts, *(words for legend in figure.legends for words in legend.get_texts())]
    return own + [words for part in figure.subfigs for words in _words_outside_panels(part)]


def _is_cut(figure, renderer):
    boxes = [axes.get_tightbbox(renderer) for axes in figure.axes if axes.get_visible()]
    boxes += [words.get_window_extent(renderer) for words in _words_outside_panels(figure)]
    edge, slack = figure.bbox, _SLACK * figure.dpi / 72
    return any(box.x0 < edge.x0 - slack or box.y0 < edge.y0 - slack or box.x1 > edge.x1 + slack or box.y1 > edge.y1 + slack
               for box in boxes if box is not None)


def _has_words_on_words(figure, renderer):
    """Words within a panel, and those of its legend; or those along an axis."""
    slack = _SLACK * figure.dpi / 72
    for axes in figure.axes:
        if axes.axison and any(not _are_numbers(axis) and _touch(axis, renderer, 0) for axis in (axes.xaxis, axes.yaxis)):
            return True
        legend = axes.get_legend()
        words = [text for text in axes.texts if text.get_visible() and text.get_text().strip()]
        boxes = [text.get_window_extent(renderer) for text in words + ([legend] if legend else [])]
        for one, other in itertools.combinations(boxes, 2):
            if (min(one.x1, other.x1) - max(one.x0, other.x0) > slack
                    and min(one.y1, other.y1) - max(one.y0, other.y0) > slack):
                return True
    return False


def _has_slivers(figure, letters):
    """Panels of a few letters' size; a colour bar is one by nature, words alone are no panel."""
    least = [count * letters * figure.dpi / 72 for count in _LEAST_PANEL]
    return any(axes.bbox.width < least[0] or axes.bbox.height < least[1] for axes in figure.axes
               if axes.axison and axes.get_label() != "<colorbar>")


def _has_room(figure, look):
    renderer = FigureCanvasAgg(figure).get_renderer()
    done = _lay_out(figure)
    _thin_numbers(figure, renderer, look.letters)
    if look.width is None and look.font_size is None:
        return True
    if _break_labels(figure, renderer):
        done = _lay_out(figure)
        _thin_numbers(figure, renderer, look.letters)
    return (done and not _is_cut(figure, renderer) and not _has_words_on_words(figure, renderer)
            and not _has_slivers(figure, look.letters))


def make_room(figure, look, what):
    """Numbers of any figure are thinned out; one that is as wide, or has letters as large, as was asked for may be refused."""
    figure.swirl_letters = look.letters
    try:
        fits = _has_room(figure, look)
    except _NoRoom:
        fits = False
    if not fits:
        page = " on a page" if figure.get_size_inches()[1] >= PAGE else ""
        raise RecordError(f"width = {25.4 * width_of(figure):.4g} mm with letters of {look.letters:g} points: {what} would have "
                          f"words cut off or on one another, or panels too small to read{page}")
