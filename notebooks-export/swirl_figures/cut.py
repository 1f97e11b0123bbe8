"""Of an orbit with a long rest a panel shows what comes before and the rest's beginning, and says so: in its own title, which
is there also where a figure has none (--no-title), and in the caption."""

from matplotlib import rcParams

from .legends import fits_across
from .symbols import TIME


def tell_cut(axes, look, title, shown_until, end):
    """On a line of its own where the panel is too narrow for both."""
    words = f"shown until {TIME} = {shown_until:.4g} of {end:.6g}"
    both = f"{title}; {words}"
    axes.set_title(both if fits_across(axes, both, rcParams["font.size"]) else f"{title}\n{words}")
    look.notes.append(f"{both}, the rest on the wall.")
