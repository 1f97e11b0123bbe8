"""Axes in metres, seconds and kilograms: a figure that was drawn where R_c = ω_s = m = 1 gets ticks and labels in SI."""

import re

from matplotlib.ticker import FuncFormatter, Locator, MaxNLocator, ScalarFormatter

from .record import RecordError

#: What stands in a label for a quantity over its unit: what it is called, its powers of R_c, 1/ω_s and m, and its SI unit.
_LABELS = (
    (r"$\omega_s t$", "$t$", (0, 1, 0), "s"),
    (r"frequency $f/f_s$, $f_s = \omega_s/2\pi$", "angular frequency", (0, -1, 0), "rad/s"),
    (r"flight time $\omega_s\tau$", r"flight time $\tau$", (0, 1, 0), "s"),
    (r"$J/(m R_c^2 \omega_s^2)$", "$J$", (2, -2, 1), "J"),
    (r"$E_p/(m R_c^2 \omega_s^2)$", "$E_p$", (2, -2, 1), "J"),
    (r"$\Delta J$", r"$\Delta J$", (2, -2, 1), "J"),
    (r"force$/(m R_c \omega_s^2)$", "force", (1, -2, 1), "N"),
    (r"slip $u_t/(R_c\omega_s)$", "slip $u_t$", (1, -1, 0), "m/s"),
    (r"$V$  (speed of the starts, in $R_c\omega_s$)", "$V$  (speed of the starts)", (1, -1, 0), "m/s"),
    (r"$S$ at the start", r"$\omega_p$ at the start", (0, -1, 0), "rad/s"),
)
_QUOTIENTS = ((r"/(R_c\omega_s)$", (1, -1, 0), "m/s"), ("/R_c$", (1, 0, 0), "m"))


def units_of(record):
    """R_c, 1/ω_s and m in SI units, of a scene that was given in them."""
    if "units" not in record:
        raise RecordError(f"record '{record.path}' has no units: its scene was given without --container-radius, "
                          "--swirl-rate ...")
    return tuple(float(record.attribute("units", name)) for name in ("length", "time", "mass"))


def shared_units(records):
    """The units of all of them."""
    units = {units_of(record) for record in records}
    if len(units) > 1:
        raise RecordError("the records have different units: draw them one by one, or without --units physical")
    return units.pop()


def _in_si(label):
    """(label, powers) of an axis that has a unit, else None."""
    for text, name, powers, unit in _LABELS:
        if text in label:
            return f"{label.replace(text, name)}  [{unit}]", powers
    for text, powers, unit in _QUOTIENTS:
        if text in label:
            return f"{label.replace(text, '$')}  [{unit}]", powers
    return None


class _Scaled(Locator):
    """Ticks at round numbers of what is shown, not of what is drawn."""

    def __init__(self, scale, bins):
        self._scale, self._ticks = scale, MaxNLocator(nbins=bins, steps=[1, 2, 2.5, 5, 10])

    def __call__(self):
        return self.tick_values(*self.axis.get_view_interval())

    def tick_values(self, low, high):
        return self._ticks.tick_values(self._scale * low, self._scale * high) / self._scale


def _scale(units, powers):
    scale = 1.0
    for unit, power in zip(units, powers):
        scale *= unit**power
    return scale


def limits_drawn(limited, look, units):
    """{"xlim": ..., "ylim": ..., "scales": ...}: the ranges of a look, which are in SI, as ranges of what is drawn.
    @param limited  the axes that they are for, Look.limited of a figure that was drawn without them"""
    drawn = {"scales": {}}
    for letter in "xy":
        limits = getattr(look, f"{letter}lim")
        found = filter(None, (_in_si(getattr(axes, f"get_{letter}label")()) for axes in limited))
        scale = next((_scale(units, powers) for _, powers in found), 1.0)
        drawn[f"{letter}lim"] = limits and tuple(end / scale for end in limits)
        drawn["scales"][f"{letter}lim"] = scale
    return drawn


def _show(axis, scale, bins):
    numbers = ScalarFormatter(useOffset=False)
    numbers.create_dummy_axis()

    def text(value, _):
        low, high = sorted(scale * end for end in axis.get_view_interval())
        ticks = [scale * tick for tick in axis.get_majorticklocs()]
        numbers.axis.set_view_interval(low, high)
        numbers.axis.set_data_interval(low, high)
        return next((word for tick, word in zip(ticks, numbers.format_ticks(ticks)) if tick == scale * value), "")

    axis.set_major_locator(_Scaled(scale, bins))
    axis.set_major_formatter(FuncFormatter(text))


def in_si(figure, units):
    """Every axis of the figure whose quantity has a unit is labelled in SI; the others stay as they are.
    @param units  R_c, 1/ω_s and m, see units_of()
    @return how many axes were changed"""
    changed = 0
    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            found = _in_si(axis.get_label_text())
            if found is None or axis.get_scale() != "linear":  # a density over f/f_s stays one
                axis.set_label_text(axis.get_label_text().replace("per unit of frequency", "per unit of $f/f_s$"))
                continue
            label, powers = found
            scale = _scale(units, powers)
            shared = axes.get_shared_x_axes() if axis is axes.xaxis else axes.get_shared_y_axes()
            for other in shared.get_siblings(axes):
                _show(other.xaxis if axis is axes.xaxis else other.yaxis, scale, max(3, len(axis.get_majorticklocs())))
            axis.set_label_text(re.sub("  +", " ", label))
            changed += 1
            if axis is axes.xaxis and axes.get_aspect() == 1 and not axes.get_ylabel():  # a map whose label is beside it
                _show(axes.yaxis, scale, max(3, len(axes.yaxis.get_majorticklocs())))
    return changed
