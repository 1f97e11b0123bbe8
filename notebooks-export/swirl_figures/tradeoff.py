"""A tradeoff record: what accuracy costs, how a verdict settles, and what each piece of the model adds."""

import numpy
from matplotlib.lines import Line2D
from matplotlib.patches import Patch

from .look import ROUNDING, is_narrow, width_of
from .record import RecordError
from .style import BLUE, GREY, MODE_COLOURS, VERMILION
from .symbols import MEAN_SPIN, scene_title

#: Inches of width in which the panels of evidence and model stand beside that of the arithmetic; in less, below it.
_BESIDE = 8.0

#: Inches of width in which the legend below the arithmetic's panel has two columns; in less, one.
_TWO_COLUMNS = 5.4


def _time(seconds):
    """231 ns, 62 µs."""
    for unit, name in ((1e-6, "ns"), (1e-3, "µs"), (1.0, "ms")):
        if abs(seconds) < unit:
            return f"{seconds / (unit * 1e-3):.3g} {name}"
    return f"{seconds:.3g} s"


def _missed(missed, misordered, flights, most, compact):
    """A second line of a rung's label; where there is little room, only of one that is wrong."""
    if compact:
        return f"\nwrong contacts: {100 * (missed + misordered) / flights:.2g} %" if missed + misordered > 0 else ""
    if missed + misordered == 0:
        return f"\nmissed or out of order: 0 of {flights:,.0f} (95 %: below {most:.1g})"
    return f"\nmissed {missed:.0f}, out of order {misordered:.0f} of {flights:,.0f}"


def _lowered(seconds, error, kept, decades, compact):
    """By how many points the label of each rung stands below its marker. Of rungs with like errors the slowest has its
    own at its side, the fastest below, and those between above."""
    below, line = (13, 20) if compact else (22, 26)
    lowered = numpy.zeros(len(error))
    for i in numpy.flatnonzero(kept):
        like = kept & (abs(numpy.log10(numpy.where(kept, error, 1) / error[i])) < 0.08 * decades)
        slower, faster = (like & (seconds > seconds[i])).sum(), (like & (seconds < seconds[i])).sum()
        if slower > 0:
            lowered[i] = below if faster == 0 else -line * slower
    return lowered


def _label_rung(axes, x, y, words, chosen, lowered=0):
    axes.annotate(words, (x, y), xytext=(9, -lowered), textcoords="offset points", fontsize="small", va="center",
                  color=VERMILION if chosen else "0.2", weight="bold" if chosen else "normal", clip_on=False,
                  bbox={"fc": "white", "ec": "none", "pad": 0.4, "alpha": 0.85}, zorder=3)


def _knee_in_words(record, compact):
    most = record.attributes("settings").get("roundings_at_knee", 50)
    return f"knee: right to {most:g} roundings" if compact else f"knee: the cheapest within {most:g} roundings of a double"


def _mark_knee(axes, x, y):
    axes.plot(x, y, "o", ms=16, mfc="none", mec="0.15", mew=1.4, clip_on=False, zorder=4)


def _list_marks(axes, record, knee, compact):
    """The legend of work against precision: beside the rungs, or below where there is little room."""
    handles = [Line2D([], [], marker="o", ls="", color=BLUE, label="median (across: quartiles of the time)"),
               Line2D([], [], marker="_", ls="", ms=9, color="0.35", label="99 % are below"),
               Line2D([], [], color="0.55", label="up to the largest")]
    if knee:
        handles.append(Line2D([], [], marker="o", ls="", ms=10, mfc="none", mec="0.15", mew=1.2,
                              label=_knee_in_words(record, compact)))
    below = {"loc": "upper center", "bbox_to_anchor": (0.45, -0.2), "ncols": 2 if width_of(axes.figure) > _TWO_COLUMNS else 1}
    axes.legend(handles=handles, **(below if compact else {"loc": "upper left"}))


def _draw_precision(axes, record, recommended, knee):
    """Seconds per collision against the error of one step. The last rung has none: it stands on the axis below."""
    compact = width_of(axes.figure.figure) < _BESIDE
    column = lambda name: record.column("rungs", name)
    missed = column("missed_contacts")
    misordered = column("misordered_contacts") if record.has("rungs", "misordered_contacts") else 0 * missed
    names, seconds, error = record.names("rungs", "name"), column("seconds_per_collision"), column("error")
    kept = (error > 0) & (seconds > 0)
    floor = 1e-3 * error[kept].min() if kept.any() else 1e-20
    decades = numpy.log10(max(1e3, 30 * column("error_largest")[kept].max() / floor)) if kept.any() else 1
    lowered = _lowered(seconds, error, kept, decades, compact)
    for i, name in enumerate(names):
        if not seconds[i] > 0:
            continue
        chosen = name == recommended
        marks = ["recommended"] * chosen + ["knee"] * (name == knee)
        marked = ", ".join(marks) + ": " * bool(marks)
        width = {"xerr": [[seconds[i] - column("seconds_per_collision_lower")[i]],
                          [column("seconds_per_collision_upper")[i] - seconds[i]]]}
        if kept[i]:
            axes.errorbar(seconds[i], error[i], yerr=[[0], [column("error_largest")[i] - error[i]]], fmt="o",
                          ms=9 if chosen else 6, color=VERMILION if chosen else BLUE, ecolor="0.55", lw=1.2, **width)
            axes.plot(seconds[i], column("error_99")[i], "_", ms=9, color="0.35")
            words = f"{name}, {_time(seconds[i])}"
            words += _missed(missed[i], misordered[i], column("flights")[i], column("missed_rate_most")[i], compact)
            _label_rung(axes, seconds[i], error[i], marked + words, chosen, lowered[i])
        elif i == len(names) - 1:
            axes.plot(seconds[i], floor, "v", ms=7, color=GREY, clip_on=False)
            words = f"{name}, {_time(seconds[i])}" + "\nthe others are compared with it" * (not compact)
            _label_rung(axes, seconds[i], 3 * floor, marked + words, chosen)
        if name == knee:
            _mark_knee(axes, seconds[i], error[i] if kept[i] else floor)
    axes.set(xscale="log", yscale="log", xlabel="seconds per collision", ylabel="error of one collision, against quad",
             title="Arithmetic: what digits cost")
    if kept.any():  # with room above for the legend
        axes.set_ylim(floor, max(1e3 * floor, column("error_largest")[kept].max() * 10 ** (0.2 * decades)))
    shown = seconds[seconds > 0]
    if len(shown):
        axes.set_xlim(0.5 * shown.min(), 40 * shown.max())
    _list_marks(axes, record, knee, compact)


def _draw_evidence(axes, record):
    """Mean S and its sampling error by the number of impacts, coloured by mode."""
    column = lambda name: record.column("evidence", name)
    impacts, spin, modes = column("collisions"), column("mean_S"), record.names("evidence", "mode")
    error = numpy.nan_to_num(column("mean_S_error"))
    axes.errorbar(impacts, spin, yerr=error, fmt="none", ecolor="0.4", lw=1, capsize=3)
    for mode in dict.fromkeys(modes):
        of = modes == mode
        axes.plot(impacts[of], spin[of], "o", ms=7, mec="0.3", mew=0.6, color=MODE_COLOURS[mode])
    changed, runs = column("changed"), column("runs")
    ends = numpy.nanmin(spin - error), numpy.nanmax(spin + error)
    room = ends[1] - ends[0] if ends[1] - ends[0] > ROUNDING else 0.1
    for x, count, of in zip(impacts, changed, runs):
        axes.text(x, ends[1] + 0.12 * room, f"{count:.0f} of {of:.0f}", ha="center", va="bottom", fontsize="small")
    of_what = "\n" if is_narrow(axes.figure) else " "
    axes.text(0.02, 0.985, f"starts with another mode{of_what}on the most impacts:", transform=axes.transAxes, fontsize="small", va="top")
    axes.set(xscale="log", xlabel="impacts judged" + ", after as many that are left out" * (not is_narrow(axes.figure)),
             ylabel=f"mean spin {MEAN_SPIN}", title="Evidence: how the verdict settles",
             ylim=(ends[0] - 0.4 * room, ends[1] + (1.1 if is_narrow(axes.figure) else 0.55) * room))
    axes.set_xlim(0.6 * impacts.min(), 1.7 * impacts.max())
    axes.legend(handles=[Patch(fc=MODE_COLOURS[mode], ec="0.3", lw=0.5, label=mode) for mode in dict.fromkeys(modes)],
                loc="lower right", ncols=2)


def _draw_model(axes, record):
    """The time of a collision without and with each piece."""
    column = lambda name: record.column("model", name)
    names, paid = record.names("model", "name"), record.names("model", "paid_by")
    with_it, without = 1e9 * column("seconds_per_collision"), 1e9 * column("seconds_without")
    for y, (name, by) in enumerate(zip(names, paid)):
        unpaid = by.startswith("nothing")
        base = without[y] if without[y] > 0 else with_it[y]
        axes.barh(y, min(base, with_it[y]), color="#9FC5E8", height=0.6)
        if with_it[y] > base:
            axes.barh(y, with_it[y] - base, left=base, height=0.6, color="white" if unpaid else VERMILION,
                      ec=GREY if unpaid else VERMILION, hatch="////" if unpaid else None, lw=0.8)
        more = f"{'+' if with_it[y] >= base else '−'}{_time(1e-9 * abs(with_it[y] - base))}"
        why = "" if is_narrow(axes.figure) else by.removeprefix("nothing")
        words = f"not paid for{why}" if unpaid else more if without[y] > 0 else ""
        axes.text(max(base, with_it[y]), y, f"  {words}", va="center", fontsize="small")
    axes.set_yticks(range(len(names)), names)
    axes.invert_yaxis()
    axes.set(xlabel="nanoseconds per collision", title="Model: what each piece adds",
             xlim=(0, 1.55 * numpy.nanmax([with_it, without])))
    axes.legend(handles=[Patch(fc="#9FC5E8", label="without it"), Patch(fc=VERMILION, label="what it adds"),
                         Patch(fc="white", ec=GREY, hatch="////", label="this scene does without")],
                loc="upper center", **({"bbox_to_anchor": (0.3, -0.25)} if width_of(axes.figure.figure) < _BESIDE
                                       else {"bbox_to_anchor": (0.35, -0.17), "ncols": 3}))


def size(record, look):
    if look.width is None:
        return 12, 6.6
    return look.width, max(0.55 * look.width, 5.2) if look.width >= _BESIDE else min(2.6 * look.width, 9.5)


def draw_into(figure, record, look):
    """Work against precision, and beside it (in a column: below it) the evidence and the model: three abscissas, none of
    which --xlim limits."""
    if "model" not in record:
        raise RecordError(f"record '{record.path}' holds no times ({record.attributes('result').get('reason', '')}): "
                          "there is nothing to draw")
    recommended, knee = (str(record.attributes("result").get(name, "")) for name in ("recommended", "knee"))
    if width_of(figure) < _BESIDE:
        left, right = figure.subfigures(2, 1, height_ratios=(1.2, 1.5))
    else:
        left, right = figure.subfigures(1, 2, width_ratios=(1.05, 1))
    axes = left.subplots()
    _draw_precision(axes, record, recommended, knee)
    panels = right.subplots(2, 1, height_ratios=(1, 1.15)) if "evidence" in record else [None, right.subplots()]
    if panels[0] is not None:
        _draw_evidence(panels[0], record)
    _draw_model(panels[1], record)
    look.title(figure, scene_title(record.scene()))
    return []
