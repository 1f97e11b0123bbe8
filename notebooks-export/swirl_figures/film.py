"""A film: the body in the swirled container, in one of the frames of reference, with S(t) running beside it."""

import numpy
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.patches import Circle, Polygon

from .look import blank_figure
from .motion import motion_of
from .outline import outline
from .path import FRAMES, MOST_CORNERS
from .physical import in_si
from .record import RecordError
from .style import BLACK, BLUE, GREY, SKY, VERMILION, styled
from .symbols import SPIN, TIME, scene_title

#: --frame: the frame's name in figures.
FRAME_NAMES = {"container": "Container (not turning)", "laboratory": "Laboratory",
               "co-rotating": "Co-rotating with the swirl"}

#: So much of the centre's path is drawn behind it, in time: two turns of the swirl.
TRAIL = 4 * numpy.pi

#: A film without --to shows so much.
SHOWN = 40.0

_SIZE, _DOTS = (8.0, 4.0), 100     # inches, per inch: 800 × 400 pictures; mp4 wants even numbers
_PATH_POINTS = 20_000


def span_of(motion, begin, end, second=1.0):
    """(from, to) of the film, in 1/ω_s. RecordError where they are not within the record's times.
    @param second  1/ω_s in the unit of `begin` and `end`"""
    begin_at = motion.first if begin is None else begin / second
    end_at = min(begin_at + SHOWN, motion.last) if end is None else end / second
    slack = 1e-9 * (1 + abs(motion.last))
    for name, value in (("from", begin_at), ("to", end_at)):
        if not motion.first - slack <= value <= motion.last + slack:
            raise RecordError(f"{name} = {second * value:g}: the record's times run from {second * motion.first:.6g} to "
                              f"{second * motion.last:.6g}")
    if end_at <= begin_at:
        raise RecordError(f"to = {second * end_at:g}: must be after from = {second * begin_at:g}")
    return begin_at, end_at


class Film:
    """pictures() gives one array of RGBA after another."""

    @styled
    def __init__(self, record, frame, orbit, begin, end, count, units=None):
        """@param units  R_c, 1/ω_s and m (physical.units_of): axes, clock, `begin` and `end` are in SI"""
        self._scene, self._into = record.scene(), FRAMES[FRAME_NAMES[frame]]
        self._frame, self._motion = frame, motion_of(record, orbit)
        self._units = units
        self._begin, self._end = span_of(self._motion, begin, end, units[1] if units else 1.0)
        self._times = numpy.linspace(self._begin, self._end, count)
        self._fine = numpy.linspace(self._begin, self._end, _PATH_POINTS)
        self._track = self._place(*self._motion.at(self._fine)[:2], self._fine)
        self._figure = blank_figure(*_SIZE)
        self._figure.set_dpi(_DOTS)
        self._canvas = FigureCanvasAgg(self._figure)
        self._build()
        if units:
            in_si(self._figure, units)

    def _place(self, x, y, t):
        return self._into(x, y, t, self._scene["beta"])

    def _build(self):
        self._figure.suptitle("\n".join(filter(None, (scene_title(self._scene), self._motion.what))))
        self._room, self._curve = self._figure.subplots(1, 2)
        self._build_room()
        self._build_curve()

    def _limits(self):
        """Centre and reach of what is seen."""
        beta = self._scene["beta"]
        return {"laboratory": (0, 1.05 + beta), "container": (0, max(1.05, beta + 0.05)),
                "co-rotating": (beta, max(1.05, beta + 0.05))}[self._frame]

    def _build_room(self):
        axes, beta = self._room, self._scene["beta"]
        centre, reach = self._limits()
        axes.set(xlim=(centre - reach, centre + reach), ylim=(-reach, reach), aspect="equal", xlabel=r"$x/R_c$",
                 ylabel=r"$y/R_c$", title=FRAME_NAMES[self._frame])
        if self._frame == "laboratory":
            axes.add_patch(Circle((0, 0), beta, fill=False, ec=GREY, lw=0.8, ls=(0, (4, 3))))
        self._wall = axes.add_patch(Circle((0, 0), 1, fill=False, ec=BLACK, lw=1.6, animated=True))
        self._arm, = axes.plot([], [], color=GREY, lw=1, animated=True)
        self._swirl, = axes.plot([], [], "+", color=BLACK, ms=8, mew=1.3, animated=True)
        self._trail, = axes.plot([], [], color=SKY, lw=0.9, animated=True)
        alpha, sides = self._scene["alpha"], self._scene["sides"]
        self._round = sides == "disk" or sides > MOST_CORNERS
        style = {"fc": "#D55E0055", "ec": VERMILION, "lw": 1.4, "animated": True}
        self._body = axes.add_patch(Circle((0, 0), alpha, **style) if self._round else Polygon([[0, 0]], **style))
        self._mark, = axes.plot([], [], color=VERMILION, lw=1.4, animated=True)
        self._clock = axes.text(0.02, 0.98, "", transform=axes.transAxes, va="top", fontsize="small", animated=True)

    def _build_curve(self):
        axes = self._curve
        spin = self._motion.at(self._fine)[3]
        shown = spin[numpy.isfinite(spin)]
        if len(shown) == 0:
            raise RecordError("the record tells nothing between these times: all is left out (--every), or on the wall "
                              "without samples (simulate --sample)")
        axes.plot(self._fine, spin, color="0.75", lw=1, zorder=1)
        axes.axhline(0, color="0.85", lw=0.7, zorder=0)
        margin = 0.1 * (numpy.ptp(shown) or 1)
        axes.set(xlim=(self._begin, self._end), ylim=(shown.min() - margin, shown.max() + margin), xlabel=f"time {TIME}", ylabel=SPIN)
        axes.ticklabel_format(useOffset=False)
        self._spin_values = spin
        self._so_far, = axes.plot([], [], color=BLUE, lw=1.5, animated=True)
        self._now, = axes.plot([], [], "o", color=VERMILION, ms=5, animated=True)

    def _set(self, t):
        beta, alpha = self._scene["beta"], self._scene["alpha"]
        centre = self._place(beta * numpy.cos(t), beta * numpy.sin(t), t)
        swirl = self._place(numpy.zeros(()), numpy.zeros(()), t)
        self._wall.center = centre
        self._arm.set_data([swirl[0], centre[0]], [swirl[1], centre[1]])
        self._swirl.set_data([swirl[0]], [swirl[1]])
        x, y, angle, spin = (float(value[0]) for value in self._motion.at(numpy.array([t])))
        known = numpy.isfinite(x)
        for artist in (self._body, self._mark, self._now):
            artist.set_visible(known)
        first, last = numpy.searchsorted(self._fine, [t - TRAIL, t])
        self._trail.set_data(self._track[0][first:last], self._track[1][first:last])
        self._so_far.set_data(self._fine[:last], self._spin_values[:last])
        clock = f"$t$ = {self._units[1] * t:.3g} s" if self._units else f"{TIME} = {t:.2f}"
        self._clock.set_text(clock + ("" if known else ": not in the record"))
        if not known:
            return
        place = self._place(x, y, t)
        corner = self._place(x + alpha * numpy.cos(angle), y + alpha * numpy.sin(angle), t)
        self._mark.set_data([place[0], corner[0]], [place[1], corner[1]])
        self._now.set_data([t], [spin])
        if self._round:
            self._body.center = place
            return
        edge = outline(self._scene, angle)
        self._body.set_xy(numpy.column_stack(self._place(x + edge.real, y + edge.imag, t)))

    def pictures(self):
        self._canvas.draw()
        still = self._canvas.copy_from_bbox(self._figure.bbox)
        moving = [(self._room, artist) for artist in (self._trail, self._arm, self._swirl, self._wall, self._body,
                                                      self._mark, self._clock)]
        moving += [(self._curve, artist) for artist in (self._so_far, self._now)]
        for t in self._times:
            self._canvas.restore_region(still)
            self._set(t)
            for axes, artist in moving:
                axes.draw_artist(artist)
            yield numpy.asarray(self._canvas.buffer_rgba())
