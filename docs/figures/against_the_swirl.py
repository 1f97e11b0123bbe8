"""The figure of docs/against-the-swirl.md: limits of S over alpha, growth of J, and the balance with a little loss.

    against_the_swirl.py SWIRL -o FIGURE [--numbers]

Theory is what `describe` says of the chords of a scene, the points are orbits of `simulate` and `sweep`; --numbers prints them.
Some four minutes of one core."""

import argparse
import json
import math
import subprocess
import sys
from pathlib import Path

import numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "notebooks-export"))
from matplotlib.figure import Figure
from swirl_figures.style import BLACK, BLUE, GREEN, VERMILION, styled

MU = 0.5


class Swirl:
    def __init__(self, program):
        self._program = program

    def __call__(self, words):
        return json.loads(subprocess.run([self._program, *words.split(), "--json"], check=True, capture_output=True, text=True).stdout)

    def chords(self, scene):
        return [chord for chord in self(f"describe {scene} --max-time 1")["chords"] if chord["attracts"]]

    def tail(self, scene, start, impacts, kept=2000):
        """(mean S, mean J in the container's frame, the words) of the last impacts."""
        found = self(f"simulate {scene} {start} --collisions {impacts} --skip {impacts - kept}")
        rows, of = found["collisions"], found["scene"]
        vertices = [row["vertex"] for row in rows]
        steps = {(after - before) % of["sides"] for before, after in zip(vertices, vertices[1:])}
        sticks = all(row["contact_mode"].endswith("sticking") for row in rows)
        return (numpy.mean([row["spin"] for row in rows]), numpy.mean([energy(row, of) for row in rows]), steps if sticks else None)


def scene_of(sides, alpha, beta, restitution=1):
    return f"--sides {sides} --alpha {alpha!r} --beta {beta!r} --mu {MU} --restitution {restitution!r}"


def start_on(a, v, alpha, beta):
    return f"--point=0,0,{-v * math.cos(a)!r},{v * math.sin(a) + beta!r},{-v * math.sin(a) / alpha!r}"


def energy(row, scene):
    beta = scene["beta"]
    wn, wt = row["vn"] - beta * math.sin(row["psi"]), row["vt"] - beta * math.cos(row["psi"])
    return 0.5 * (wn * wn + wt * wt + scene["inertia_factor"] * (scene["alpha"] * row["spin"])**2)


def limits(swirl, sides, alphas, fast):
    """(alpha, S*) of the chords of j = N/2 with a limit; of those against the swirl if `fast`, else with it."""
    found = [(alpha, chord["limit_S"]) for alpha in alphas for chord in swirl.chords(scene_of(sides, float(alpha), 0.1))
             if 2 * chord["j"] == sides and chord["limit_S"] is not None and (chord["a"] > 0) == fast]
    return numpy.array(found).reshape(-1, 2)


def driven_to(swirl, sides, alpha, beta, fast, impacts):
    """S of orbits from 4 % below and 4 % above the speed of the limit, and the limit."""
    chord = next(c for c in swirl.chords(scene_of(sides, alpha, beta)) if 2 * c["j"] == sides and (c["a"] > 0) == fast)
    starts = [start_on(chord["a"], factor * chord["limit_speed"], alpha, beta) for factor in (0.96, 1.04)]
    return [swirl.tail(scene_of(sides, alpha, beta), start, impacts)[0] for start in starts], chord["limit_S"]


def draw_limits(axes, swirl, say):
    alphas = numpy.arange(0.405, 0.5, 0.0025)
    for sides, colour in ((4, VERMILION), (6, BLUE), (8, GREEN)):
        places = limits(swirl, sides, alphas, True)
        axes.plot(*places.T, color=colour, label=f"$S^*$, N = {sides}, against the swirl")
        slow = limits(swirl, sides, alphas, False)
        if sides == 6:
            axes.plot(*slow.T, color=colour, ls=":", label="$S^*$, N = 6, slow, with the swirl")
        for alpha in (0.44, 0.46, 0.48):
            orbits, limit = driven_to(swirl, sides, alpha, 0.3, True, 2_000_000)
            say(f"N {sides} alpha {alpha} beta 0.3: S {orbits[0]:.4f} {orbits[1]:.4f}, limit {limit:.4f}")
            axes.plot([alpha] * 2, orbits, "o", ms=4, mfc="white", mec=colour)
    for alpha in (0.44, 0.46, 0.48):
        for beta in (0.01, 0.03, 0.1, 0.2):
            orbits, limit = driven_to(swirl, 6, alpha, beta, False, 300_000)
            say(f"N 6 alpha {alpha} beta {beta}, slow: S {orbits[0]:.4f} {orbits[1]:.4f}, limit {limit:.4f}")
            if beta == 0.03:
                axes.plot([alpha] * 2, orbits, "s", ms=4, mfc="white", mec=BLUE)
    axes.plot([], [], "o", ms=4, mfc="white", mec=BLACK, label=r"orbits, $\beta$ = 0.3 (slow: squares, 0.03)")
    runs = [run | cell["parameters"] for cell in swirl(f"sweep --sides 6 --beta 0.1 --mu {MU} --restitution 1 --grid alpha=0.405:0.7:60 --runs 6")["cells"]
            for run in cell["runs"] if run["mean_S"] is not None and run["kind"] not in ("chord", "accelerated")]
    axes.plot([run["alpha"] for run in runs], [run["mean_S"] for run in runs], ".", ms=3, color="0.6", zorder=0,
              label=r"N = 6, other orbits of 6 starts, $\beta$ = 0.1")
    axes.plot([0.5, 0.7], [0, 0], color=BLACK, lw=1.5)
    axes.annotate("diameters: accelerated,\n$S\\to0$", (0.6, 0), xytext=(0.6, -2.2), ha="center", fontsize="small",
                  arrowprops={"arrowstyle": "-", "lw": 0.6})
    axes.set_yscale("symlog", linthresh=1)
    axes.set(xlim=(0.4, 0.7), ylim=(-40, 3), xlabel=r"$\alpha$", ylabel="mean $S$", title="What it comes to")
    axes.set_yticks([-30, -10, -3, -1, 0, 1], ["−30", "−10", "−3", "−1", "0", "1"])
    axes.minorticks_off()
    axes.legend(fontsize="x-small", loc="lower right")


def energies(swirl, scene, start, impacts):
    """(n, J), even in ln n."""
    n, found = [], []
    for last in [10**k for k in range(2, round(math.log10(impacts)) + 1)]:
        answer = swirl(f"simulate {scene} {start} --collisions {last} --every {max(last // 1000, 1)}")
        rows = [row for row in answer["collisions"] if row["number"] > last // 10]
        edges = numpy.geomspace(last / 10, last, 11)
        place = numpy.digitize([row["number"] for row in rows], edges) - 1
        values = numpy.array([energy(row, answer["scene"]) for row in rows])
        for k in range(10):
            if (place == k).any():
                n.append(math.sqrt(edges[k] * edges[k + 1]))
                found.append(values[place == k].mean())
    return numpy.array(n), numpy.array(found)


def draw_growth(axes, swirl, say):
    cases = ((0.56, 0.1, BLUE, "0.56: a diameter"), (0.56, 0.4, GREEN, "0.56, $\\beta$ = 0.4"), (0.46, 0.1, VERMILION, "0.46: a chord, to its limit"),
             (0.3, 0.1, "0.5", "0.3: chaos"))
    for alpha, beta, colour, label in cases:
        scene = scene_of(6, alpha, beta)
        n, found = energies(swirl, scene, "--seed 1", 10_000_000)
        axes.plot(n, found, color=colour, label=f"$\\alpha$ = {label}")
        for decade in range(2, 7):
            part = (n >= 10.0**decade) & (n < 10.0**(decade + 1))
            slope = numpy.polyfit(numpy.log(n[part]), numpy.log(found[part]), 1)[0]
            say(f"alpha {alpha} beta {beta}: exponent {slope:.4f} over 10^{decade} to 10^{decade + 1}, J = {found[part][-1]:.5g}")
        growth = next((chord["growth"] for chord in swirl.chords(scene) if chord["growth"] is not None), None)
        if growth is not None:
            axes.plot(n, numpy.cbrt(0.75 * growth * beta**2 * n), color=colour, ls=":", lw=1)
    axes.plot([], [], color=BLACK, ls=":", lw=1, label=r"$(\frac{3}{4}K\beta^2n)^{1/3}$")
    axes.set(xscale="log", yscale="log", xlabel="impacts $n$", ylabel="energy $J$ in the container's frame", title="How fast")
    axes.legend(fontsize="x-small")


def draw_balance(axes, swirl, say):
    alpha, beta = 0.56, 0.1
    losses = numpy.geomspace(1e-6, 0.2, 40)
    chords = [next((c for c in swirl.chords(scene_of(6, alpha, beta, float(1 - x))) if c["a"] == 0), None) for x in losses]
    growth = next(c["growth"] for c in swirl.chords(scene_of(6, alpha, beta)) if c["a"] == 0)
    axes.plot(losses, 0.5 * numpy.cbrt(2 * growth * beta**2 / (losses * (2 - losses))), color=BLACK, ls=":", lw=1,
              label=r"$\frac{1}{2}(2K\beta^2/(1-e^2))^{1/3}$")
    axes.plot(losses, [math.nan if c is None or c["balance_J"] is None else c["balance_J"] for c in chords], color=BLUE, label="$J^*$ by the whole of $G$")
    for loss in (1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 2e-2, 3e-2, 4e-2, 5e-2, 6e-2, 7e-2, 1e-1, 2e-1):
        scene = scene_of(6, alpha, beta, 1 - loss)
        chord = next(c for c in swirl.chords(scene) if c["a"] == 0)
        v = math.sqrt(2 * (chord["balance_J"] or 0.1))
        spin, found, steps = swirl.tail(scene, start_on(0, 0.95 * v, alpha, beta), int(20_000 + min(5 / loss, 4e6)))
        stays = steps == {3}
        say(f"1 - e {loss:g}: J {found:.5g}, J* {chord['balance_J']}, S {spin:.4f}, on the diameter: {stays}")
        axes.plot([loss], [found], "o", ms=5, mec=BLUE if stays else VERMILION, mfc="white")
    axes.plot([], [], "o", ms=5, mec=BLUE, mfc="white", label="orbits that stay on the diameter")
    axes.plot([], [], "o", ms=5, mec=VERMILION, mfc="white", label="orbits that leave it")
    axes.set(xscale="log", yscale="log", xlabel="$1-e$", ylabel="energy $J$ at last", title=rf"With a little loss ($\alpha$ = {alpha}, $\beta$ = {beta})")
    axes.legend(fontsize="x-small")


@styled
def draw_all(swirl, say, output):
    figure = Figure(figsize=(13, 4.6), layout="constrained")
    for axes, draw in zip(figure.subplots(1, 3), (draw_limits, draw_growth, draw_balance)):
        draw(axes, swirl, say)
    figure.savefig(output, dpi=85)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("swirl")
    parser.add_argument("-o", dest="output", required=True)
    parser.add_argument("--numbers", action="store_true", help="print what the points show")
    options = parser.parse_args()
    say = (lambda line: print(line, flush=True)) if options.numbers else (lambda line: None)
    draw_all(Swirl(options.swirl), say, options.output)


if __name__ == "__main__":
    main()
