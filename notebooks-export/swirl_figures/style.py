"""Colours that colour-blind eyes tell apart (Okabe and Ito 2008), and the settings that every figure shares."""

import functools

import matplotlib

BLUE, ORANGE, GREEN, VERMILION = "#0072B2", "#E69F00", "#009E73", "#D55E00"
PURPLE, SKY, YELLOW, BLACK, GREY = "#CC79A7", "#56B4E9", "#F0E442", "#222222", "#9A9A9A"

#: For what is told apart by colour alone, the most different first.
CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK, "#7A5C00", "#332288", "#882255", "#44AA99", "#999933")

MODE_COLOURS = {"steady": BLUE, "quasi-steady": YELLOW, "chaotic": VERMILION, "undecided": "#BDBDBD"}

#: Points beyond which a vector file would be slow to open: they are drawn as an image inside it.
MANY_POINTS = 20_000

SETTINGS = {
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "figure.titlesize": 10,
    "legend.fontsize": 8,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.linewidth": 0.7,
    "mathtext.fontset": "dejavusans",
    "legend.frameon": False,
    "savefig.dpi": 160,
    "figure.dpi": 100,
    "pdf.fonttype": 42,
    "svg.hashsalt": "swirl",  # equal records give equal files
}


def styled(draw):
    """A figure drawn with these settings, whatever those of the notebook are."""
    @functools.wraps(draw)
    def drawn(*arguments, **options):
        with matplotlib.rc_context({**matplotlib.rcParamsDefault, **SETTINGS}):
            return draw(*arguments, **options)
    return drawn
