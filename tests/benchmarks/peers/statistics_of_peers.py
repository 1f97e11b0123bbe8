"""Polygons with friction, where laws of impact differ: statistics_of_peers.py PEERS [--orbits N] [--seed N]

PEERS is the program built with -DSWIRL_PEERS=ON. A chaotic hexagon is followed by each peer from random starts;
printed are means over orbits with their standard errors, and how far these are from Swirl's under its three laws. Then,
at e = 1, how J goes on. README.md, "Polygons with friction".
"""

import argparse
import math
import statistics
import sys
from dataclasses import dataclass

from compiled_peers import CompiledPeers
from container_frame import WHERE_LAWS_DIFFER, follow, jacobi
from scipy_peer import ScipyPeer

try:
    from siconos_peer import SiconosPeer
except ImportError:
    SiconosPeer = None

SKIPPED = 100  # impacts until the start is forgotten: means over the next 50 and over those after 500 are the same
KEPT = 300
DRAWN = 8  # starts that the program draws from one orbit; one of them is taken
# The largest of four differences in standard errors is beyond this in 5 % of comparisons of equals.
AGREES = 2.5
QUANTITIES = ("S over time", "S over impacts", "impacts / time", "J over time")
LAWS = {"Poisson": "double", "Newton": "newton", "Stronge": "stronge"}


@dataclass(frozen=True)
class Follower:
    name: str
    peer: str        # the compiled peer, or scipy, siconos
    law: str         # of its impacts
    tolerance: float = 0.0
    step: float = 0.0
    share: float = 2.0  # of --orbits: less of what is slow


def followers():
    for law, peer in LAWS.items():
        yield Follower(f"swirl, {law}", peer, law)
    for name in ("brent", "paper"):
        yield Follower(name, name, "Poisson")
    yield Follower("fixed-step 0.01", "fixed-step", "Poisson", step=0.01)
    yield Follower("SUNDIALS 1e-09", "sundials", "Poisson", 1e-9, share=1)
    yield Follower("SciPy 1e-09", "scipy", "Poisson", 1e-9, share=0.1)
    yield Follower("Box2D 0.01", "box2d", "Newton", step=0.01, share=0.5)
    yield Follower("Box2D 0.001", "box2d", "Newton", step=0.001, share=0.1)
    if SiconosPeer is not None:
        yield Follower("Siconos 0.01", "siconos", "Newton", step=0.01, share=0.06)


def rows_of(one, scene, compiled, starts, orbits, impacts):
    for orbit in range(orbits):
        first = DRAWN * orbit
        if one.peer == "scipy":
            yield follow(ScipyPeer(scene, one.tolerance), starts[first], impacts)
        elif one.peer == "siconos":
            yield SiconosPeer(scene, one.step).row(starts[first], impacts)
        else:
            yield compiled.row(one.peer, one.tolerance, one.step, first, impacts)


def sums_of(scene, row):
    """Impacts, time, and the sums of S dt, S and J dt of an orbit: S and J are constant in flight."""
    flights = list(zip(row[SKIPPED - 1:], row[SKIPPED:]))
    return (len(flights), sum(after.time for _, after in flights),
            sum(before.after[6] * after.time for before, after in flights), sum(after.after[6] for _, after in flights),
            sum(jacobi(scene, before.after) * after.time for before, after in flights))


def ratio_and_error(numerators, denominators):
    """Sum over sum, with its standard error from what the orbits differ by."""
    count, whole = len(numerators), sum(denominators)
    ratio = sum(numerators) / whole
    rests = sum((a - ratio * b)**2 for a, b in zip(numerators, denominators))
    return ratio, math.sqrt(count / (count - 1) * rests) / whole


def means_of(sums):
    impacts, times, spins_by_time, spins, jacobis = zip(*sums)
    return (ratio_and_error(spins_by_time, times), ratio_and_error(spins, impacts), ratio_and_error(impacts, times),
            ratio_and_error(jacobis, times))


def distances(means, others):
    """The differences of the quantities in standard errors."""
    return [abs(a - b) / math.hypot(ea, eb) for (a, ea), (b, eb) in zip(means, others)]


def verdict(means, others, law):
    far = {name: value for name, value in zip(QUANTITIES, distances(means, others)) if value > AGREES}
    differs = ", ".join(f"{name} by {value:.1f}" for name, value in far.items())
    return f"differs from {law}: {differs}" if far else f"agrees with {law}"


def print_means(scene, compiled, starts, orbits):
    print(f"means over impacts {SKIPPED + 1} to {SKIPPED + KEPT}, and the largest of their four differences from Swirl's "
          f"under each law, in standard errors")
    columns = " ".join(f"{name:>19}" for name in QUANTITIES)
    print(f"{'':16} {'orbits':>6} {'lost':>4} {columns}  {'from':>7} {' '.join(f'{law:>7}' for law in LAWS)}")
    of_laws = {}  # of Swirl, which comes first
    for one in followers():
        count = max(20, int(one.share * orbits))
        rows = list(rows_of(one, scene, compiled, starts, count, SKIPPED + KEPT))
        whole = [sums_of(scene, row) for row in rows if len(row) == SKIPPED + KEPT]
        lost = count - len(whole)
        if 2 * lost > count:
            half = statistics.median(len(row) for row in rows)
            print(f"{one.name:16} {count:6} {lost:4} half of its orbits find no contact after {half:.0f} impacts")
            continue
        means = means_of(whole)
        of_laws.setdefault(one.law, means)
        cells = " ".join(f"{mean:10.4f} ± {error:.4f}" for mean, error in means)
        far = " ".join(f"{max(distances(means, of_laws[law])):7.1f}" if law in of_laws else 7 * " " for law in LAWS)
        own = "" if one.peer in LAWS.values() else verdict(means, of_laws[one.law], one.law)
        print(f"{one.name:16} {count:6} {lost:4} {cells} {'':9}{far}  {own}", flush=True)


def print_growth(scene, compiled, starts, orbits):
    """Newton's law makes energy where slip stops: at e = 1 more than friction takes away."""
    moments = (50, 100, 200, 300)
    print(f"{'mean J after impacts':22} " + " ".join(f"{moment:>16}" for moment in moments))
    for one in followers():
        if one.peer in LAWS.values() or one.law == "Newton" and one.step == 0.01:
            rows = [row for row in rows_of(one, scene, compiled, starts, max(20, int(one.share * orbits)), max(moments))
                    if len(row) == max(moments)]
            values = [ratio_and_error([jacobi(scene, row[moment - 1].after) for row in rows], [1] * len(rows))
                      for moment in moments]
            print(f"{one.name:22} " + " ".join(f"{mean:8.3f} ± {error:.3f}" for mean, error in values), flush=True)


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("peers", help="the program built with -DSWIRL_PEERS=ON")
    parser.add_argument("--orbits", type=int, default=600, help="of SUNDIALS; others by their shares")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    if options.orbits < 100:
        parser.error("--orbits must be at least 100")
    if SiconosPeer is None:
        print("Siconos is left out: no python3-siconos")
    with CompiledPeers(options.peers) as compiled:
        for name, scene in WHERE_LAWS_DIFFER.items():
            print(f"\n{name}: alpha {scene.alpha}, beta {scene.beta}, mu {scene.mu}, e {scene.restitution}; "
                  f"seed {options.seed}")
            starts, _ = compiled.draw(name, options.seed, 2 * DRAWN * options.orbits)
            shown = print_growth if scene.restitution == 1 else print_means
            shown(scene, compiled, starts, options.orbits)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
