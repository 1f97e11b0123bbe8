"""The verdict of `classify` and what it rests on: the orbit on the section, S impact by impact, the spectrum of that (of a
measured series its values, see verdict_panels), and the evidence in words, which is all there is of an orbit that ended."""

import textwrap

import numpy
from matplotlib import rcParams
from matplotlib.patches import Rectangle

from . import verdict_panels
from .look import rows_of, side_by_side, width_of
from .riding import RIDING
from .style import BLACK, MODE_COLOURS
from .symbols import number, scene_title, with_error


def has_verdict(record):
    return "mode" in record and "runs" not in record


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
        for index, line in enumerate(textwrap.wrap(f"{name}: {number(value)}{limit}: {says}", longest,
                                                   subsequent_indent="    ")):
            lines.append((line, index == 0))
    return lines


def _letters_across(width):
    return max(30, int(72 * (width - 0.4) / (0.52 * 8 / 9 * rcParams["font.size"])))


def _height_of_text(record, width):
    return 0.45 + len(_lines_of(record, _letters_across(width))) * 1.35 * 8 / 9 * rcParams["font.size"] / 72


#: Inches that a panel needs.
_LEAST_PANEL = 2.2


def _height_of_panels(width):
    rows = rows_of(width, verdict_panels.PANELS, _LEAST_PANEL)
    return 2.9 if rows == 1 else 2.2 * rows


def size(record, look):
    width = look.width or 9
    panels = _height_of_panels(width) if verdict_panels.seen_of(record) else 0
    return width, 0.75 + panels + _height_of_text(record, width)


def _mean_in_words(attributes):
    """As the command says it: with its error, or that a run of chaos was too short for one."""
    mean, error = attributes["mean_S"], attributes.get("mean_S_error", numpy.nan)
    if str(attributes.get("mean_S_kind", "")) == "too-short":
        return f"about {mean:.1g} (too short a run for an error)".replace("-", "\N{MINUS SIGN}")
    return with_error(mean, error)


def _headline(record):
    attributes = record.attributes("mode")
    kind, period = (attributes.get(name) for name in ("kind", "period"))
    words = [str(attributes["mode"])]
    if kind is not None and str(kind) not in ("", "none", words[0]):
        words.append(f"{kind} of period {int(period)}" if period is not None and period > 1 else str(kind))
    text = ": ".join(words)
    mean = attributes.get("mean_S", numpy.nan)
    if numpy.isfinite(mean):
        text += f"; mean {verdict_panels.name_of_mean(record)} {_mean_in_words(attributes)}"
    for name, counted in (("largest_exponent", "impact"), ("largest_exponent_per_time", "unit of time")):
        exponent = attributes.get(name)
        if exponent is not None and numpy.isfinite(exponent):
            text += f"; largest exponent {with_error(exponent, attributes[name + '_error'])} per {counted}"
    return text


def _write_evidence(figure, record):
    axes = figure.subplots()
    axes.axis("off")
    attributes = record.attributes("mode")
    mode = str(attributes["kind" if str(attributes.get("kind", "")) == RIDING else "mode"])
    axes.add_patch(Rectangle((0, 0), 0.006, 1, transform=axes.transAxes, color=MODE_COLOURS.get(mode, "0.5"), lw=0))
    lines = [("Evidence", True)] + _lines_of(record, _letters_across(width_of(figure)))
    for index, (line, begins) in enumerate(lines):
        axes.text(0.015, 1 - (index + 0.5) / len(lines), line, va="center", fontsize="small", transform=axes.transAxes,
                  color=BLACK if begins else "0.3", weight="bold" if index == 0 else "normal")


def draw_into(figure, record, look):
    look.title(figure, "\n".join(filter(None, (scene_title(record.scene()), _headline(record)))))
    seen = verdict_panels.seen_of(record)
    if not seen:
        _write_evidence(figure.subfigures(1, 1), record)
        return []
    width = width_of(figure)
    above, below = figure.subfigures(2, 1, height_ratios=(_height_of_panels(width), _height_of_text(record, width)))
    verdict_panels.draw(side_by_side(above, verdict_panels.PANELS, _LEAST_PANEL), seen)
    _write_evidence(below, record)
    return []
