"""Colours that colour-blind eyes tell apart (Okabe and Ito 2008), and the settings that every figure shares."""

import functools

import matplotlib
from matplotlib.collections import LineCollection, PathCollection
from matplotlib.colors import LinearSegmentedColormap
from matplotlib.lines import Line2D

BLUE, ORANGE, GREEN, VERMILION = "#0072B2", "#E69F00", "#009E73", "#D55E00"
PURPLE, SKY, YELLOW, BLACK, GREY = "#CC79A7", "#56B4E9", "#F0E442", "#222222", "#9A9A9A"

#: For what is told apart by colour alone, the most different first.
CYCLE = (BLUE, VERMILION, GREEN, PURPLE, ORANGE, SKY, BLACK, "#7A5C00", "#332288", "#882255", "#44AA99", "#999933")

#: In grey, too, they are apart: lightness L* of 26, 40, 90, 54, 76.
MODE_COLOURS = {"steady": "#00406B", "riding": "#6A51A3", "quasi-steady": YELLOW, "chaotic": VERMILION, "undecided": "#BDBDBD"}

#: Of pixels, also of images within vector files.
DOTS_PER_INCH = 160

#: What tells time; it reads in grey, and without its palest end on white.
TIMES = LinearSegmentedColormap.from_list("times", matplotlib.colormaps["cividis_r"](range(30, 256)))

#: Marks beyond which a vector file would be slow to open, in all panels of a figure together. A corner of a line takes a
#: fifth of a mark's bytes.
MANY_POINTS = 20_000
_CORNER = 0.2


def _marks(artist):
    if artist.get_rasterized():
        return 0
    if isinstance(artist, PathCollection):
        return len(artist.get_offsets())
    if isinstance(artist, LineCollection):
        return sum(1 + _CORNER * len(path.vertices) for path in artist.get_paths())
    if isinstance(artist, Line2D):
        return len(artist.get_xdata()) * (1 if artist.get_marker() not in ("None", None, "", " ") else _CORNER)
    return 0


def rasterise_what_exceeds(figure):
    """Of a figure with more marks the dots and lines that have most become images inside a vector file, until the rest is
    few; of panels with equally many all or none."""
    artists = [artist for axes in figure.axes for artist in (*axes.collections, *axes.lines)]
    marks = [_marks(artist) for artist in artists]
    left = sum(marks)
    for count in sorted(set(marks), reverse=True):
        if left <= MANY_POINTS:
            return
        for artist, own in zip(artists, marks):
            if own == count:
                artist.set_rasterized(True)
                left -= count


def settings(font_size):
    """Everything else follows from the size of the letters, in points."""
    return {
        "font.size": font_size,
        "axes.titlesize": font_size,
        "axes.labelsize": font_size,
        "figure.titlesize": font_size * 10 / 9,
        "legend.fontsize": font_size * 8 / 9,
        "xtick.labelsize": font_size * 8 / 9,
        "ytick.labelsize": font_size * 8 / 9,
        "axes.spines.top": False,
        "axes.spines.right": False,
        "axes.linewidth": 0.7,
        "mathtext.fontset": "dejavusans",
        "legend.frameon": False,
        "savefig.dpi": DOTS_PER_INCH,
        "figure.dpi": 100,
        "pdf.fonttype": 42,
        "svg.hashsalt": "swirl",  # equal records give equal files
    }


def styled_with(font_size):
    return matplotlib.rc_context({**matplotlib.rcParamsDefault, **settings(font_size)})


def styled(draw):
    """Drawn with these settings, whatever those of the notebook are."""
    @functools.wraps(draw)
    def drawn(*arguments, **options):
        with styled_with(9):
            return draw(*arguments, **options)
    return drawn
