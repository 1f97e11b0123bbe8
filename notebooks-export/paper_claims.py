#!/usr/bin/python3
"""The paper's claims, run again with error bars: paper_claims.py SWIRL -o FOLDER [--runs R] [--drag G [--floor dish|table]]

Prints a verdict for each claim and body, and writes claims.json and a figure for each claim into FOLDER. With the paper's
50 runs of 4,000 impacts it takes about a minute on two cores. With --drag the floor of the dish drags (its rate in units of omega_s):
what is left of the claims on a bench."""

import argparse
import json
import shutil
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent))

from script import fail
from swirl_claims import claims, drawn
from swirl_claims.sampling import LEAST_RUNS
from swirl_figures.output import save, write_whole

MOST_RUNS = 100_000

#: The program's own range of --drag, above 0.
LEAST_DRAG, MOST_DRAG = 1e-75, 1000


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("swirl", help="the program")
    parser.add_argument("-o", "--output", type=Path, required=True, help="the folder for claims.json and the figures")
    parser.add_argument("--runs", type=int, default=50, help=f"random starts of each scene, {LEAST_RUNS} or more (default 50, the paper's)")
    parser.add_argument("--drag", type=float, help="a floor that drags with gamma = G omega_s on velocity and spin (default: none)")
    parser.add_argument("--floor", choices=("dish", "table"), help="whose floor it is, with --drag (default dish)")
    options = parser.parse_args()
    if options.drag is not None and not LEAST_DRAG <= options.drag <= MOST_DRAG:
        fail(2, f"drag = {options.drag:g}: allowed are {LEAST_DRAG:g} to {MOST_DRAG:g}")
    if options.floor and options.drag is None:
        fail(2, "--floor asks for --drag")
    if not LEAST_RUNS <= options.runs <= MOST_RUNS:
        fail(2, f"runs = {options.runs}: allowed are {LEAST_RUNS} to {MOST_RUNS}")
    if shutil.which(options.swirl) is None:
        fail(2, f"'{options.swirl}' is no program")
    if options.output.exists() and not options.output.is_dir():
        fail(2, f"'{options.output}' is no folder")
    return options


def checked(swirl, runs, floor):
    """One claim after another: (name, sentence, {body: (verdict, numbers)}, figure)."""
    dragged = f", γ = {floor['drag']:g} ({floor['floor']})" if floor else ""
    for name, sentence, mu, sign in (
            ("without-friction", "Without friction the mean rotation is positive", 0, +1),
            ("with-friction", "With friction the mean rotation is negative", claims.FRICTION, -1)):
        points = {body: claims.points_over_alpha(swirl, runs, mu, body, floor) for body in claims.BODIES}
        verdicts = {body: claims.verdict_on_sign(points[body], sign) for body in claims.BODIES}
        yield name, sentence, verdicts, drawn.of_sign({body: (points[body], verdicts[body][0]) for body in claims.BODIES},
                                                      f"{sentence}: μ = {mu}, β = {claims.BETA}, e = 1{dragged}, {runs} runs")
        if mu == 0:
            yield ("ergodic", "Without friction it is 1, if the orbit visits evenly all that J allows",
                   {body: claims.verdict_on_one(points[body]) for body in claims.BODIES}, None)
    grid = claims.friction_grid(swirl, runs, floor)
    size, proportion = claims.verdict_on_size(grid), claims.verdict_on_proportion(grid)
    sentence = "The size of μ hardly matters"
    yield "size-of-friction", sentence, {"6": size}, drawn.of_size(grid, f"{sentence} (hexagon, α = 0.3, β = {claims.BETA}{dragged}): {size[0]}")
    yield "proportion", "The mean rotation is proportional to the swirl's", {"6": proportion}, None
    found = claims.recurrence_by_mode(swirl, runs, floor)
    verdict = claims.verdict_on_recurrence(found)
    sentence = "RC is below 10⁻⁴ in chaos, 1/k on k values, 1 in the steady mode"
    yield "recurrence", sentence, {"6": verdict}, drawn.of_recurrence(found, f"{sentence}:\n{verdict[0]}, without the diagonal{dragged}")


def main():
    options = arguments()
    try:
        options.output.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        fail(2, f"cannot create '{options.output}': {error.strerror}")
    told = {}
    floor = {} if options.drag is None else {"drag": options.drag, "floor": options.floor or "dish"}
    for name, sentence, verdicts, figure in checked(options.swirl, options.runs, floor):
        print(f"{sentence}:")
        for body, (verdict, numbers) in verdicts.items():
            print(f"  {'disk' if body == 'disk' else f'N = {body}'}: {verdict}; {numbers}", flush=True)
        told[name] = {"claim": sentence, "verdicts": {body: {"verdict": verdict, "numbers": numbers}
                                                      for body, (verdict, numbers) in verdicts.items()}}
        if figure is not None:
            save(figure, options.output / f"{name}.png")
    document = json.dumps({"runs": options.runs, **floor, "claims": told}, indent=2) + "\n"
    write_whole(document.encode(), options.output / "claims.json")


if __name__ == "__main__":
    try:
        main()
    except RuntimeError as error:  # of the program
        fail(2, error)
