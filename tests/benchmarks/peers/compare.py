"""Swirl beside other solvers on one scene, in one run: compare.py PEERS [--flights N] [--rounds N] [--seed N]

PEERS is the program built with -DSWIRL_PEERS=ON. Prints for a disk with friction and a hexagon without what each
misses, then what an impact costs, in turns and at equal error, as ratios to Swirl's double and to `brent`. README.md
says how it is measured.
"""

import argparse
import statistics
import sys
import time
from dataclasses import dataclass

from compiled_peers import CompiledPeers
from container_frame import SCENES, follow
from judgement import clopper_pearson, judge, quantile, time_at_error
from scipy_peer import ScipyPeer

try:
    from siconos_peer import SiconosPeer
except ImportError:
    SiconosPeer = None

# How far from the true time a contact may be found and still be that contact: wide, in the peers' favour.
SLACK_OF_STEPS = 0.02  # two of the longest steps; Box2D's slop costs it some 0.005, too
SLACK_OF_TOLERANCE = 1000  # tolerances, and 1e-6 at least: near grazing an error of the gap makes its root's larger

EQUAL_ERRORS = (1e-3, 1e-6, 1e-9, 1e-12)  # and Swirl's own, or
AS_ACCURATE = 4  # times that: what is within is rounding, and its median differs from sample to sample


@dataclass(frozen=True)
class Contestant:
    name: str       # as it is printed
    peer: str       # the compiled peer, or scipy, siconos
    tolerance: float = 0.0
    step: float = 0.0
    share: float = 1.0  # of the flights
    steps: bool = False
    batch: int = 1000   # impacts in a row in a round

    @property
    def ladder(self):
        """The name that it has in common with those that differ from it by their tolerance or step alone."""
        return f"{self.name.split()[0]} h<{self.step:g}" if self.tolerance and self.step else self.name.split()[0]

    @property
    def slack(self):
        return SLACK_OF_STEPS if self.steps else max(1e-6, SLACK_OF_TOLERANCE * self.tolerance)


def contestants():
    yield Contestant("swirl double", "double")
    yield Contestant("abreast", "abreast")
    yield Contestant("brent", "brent")
    yield Contestant("paper", "paper")
    yield Contestant("fixed-step 0.01", "fixed-step", step=0.01, steps=True)
    for tolerance in (1e-6, 1e-9, 1e-12, 1e-14):
        yield Contestant(f"SUNDIALS {tolerance:.0e}", "sundials", tolerance, share=0.1, batch=200)
    yield Contestant("SUNDIALS 1e-12 h<0.05", "sundials", 1e-12, 0.05, share=0.1, batch=100)
    for tolerance in (1e-6, 1e-9, 1e-12, 3e-14):  # it takes no less than 2.2e-14
        yield Contestant(f"SciPy {tolerance:.0e}", "scipy", tolerance, share=0.01, batch=8)
    yield Contestant("SciPy 1e-12 h<0.05", "scipy", 1e-12, 0.05, share=0.005, batch=4)
    yield Contestant("Box2D 0.01", "box2d", step=0.01, share=0.05, steps=True, batch=10)
    yield Contestant("Box2D 0.001", "box2d", step=0.001, share=0.005, steps=True, batch=4)
    if SiconosPeer is not None:
        yield Contestant("Siconos 0.01", "siconos", step=0.01, share=0.01, steps=True, batch=4)
        yield Contestant("Siconos 0.001", "siconos", step=0.001, share=0.001, steps=True, batch=1)


def python_peer(one, scene):
    if one.peer == "scipy":
        return ScipyPeer(scene, one.tolerance, one.step if one.step > 0 else float("inf"))
    return SiconosPeer(scene, one.step) if one.peer == "siconos" else None


def impacts_of(one, scene, compiled, starts):
    peer = python_peer(one, scene)
    if peer is None:
        return compiled.next(one.peer, one.tolerance, one.step, len(starts))
    return [peer.next(start) for start in starts]


def seconds_of(one, scene, compiled, starts, first):
    """Of the processor, per impact, over a batch in a row from start `first`; where one is lost, on from the next."""
    peer = python_peer(one, scene)
    if peer is None:
        return compiled.seconds_per_impact(one.peer, one.tolerance, one.step, first, one.batch, 0.01)
    begin, found = time.process_time(), 0
    while found < one.batch:
        found += len(follow(peer, starts[first], one.batch - found))
        first += 1
    return (time.process_time() - begin) / found


def rate(hits, count):
    low, high = clopper_pearson(hits, count)
    return f"{hits:5d} [{low:.1e}, {high:.1e}]"


def print_misses(scene, compiled, starts, truths):
    judged = {}
    print(f"{'':22} {'flights':>7}  {'missed [95 %]':26} {'misordered [95 %]':26} {'late':>9} {'error':>8} "
          f"{'its 95 %':>8} {'J gained':>9}")
    for one in contestants():
        count = max(20, int(one.share * len(starts)))
        seen = judge(scene, impacts_of(one, scene, compiled, starts[:count]), truths[:count], one.slack)
        judged[one.name] = seen
        print(f"{one.name:22} {seen.count:7}  {rate(seen.missed, count):26} {rate(seen.misordered, count):26} "
              f"{seen.late:9.1e} {seen.error:8.1e} {seen.worst:8.1e} {seen.drift:9.1e}", flush=True)
    return judged


def print_times(scene, compiled, starts, judged, rounds):
    seconds = {one.name: [] for one in contestants()}
    for turn in range(rounds):
        for one in contestants():
            seconds[one.name].append(seconds_of(one, scene, compiled, starts, 16 * turn))
    print(f"{'':22} {'us/impact':>10}  {'x swirl double [quartiles]':30} {'x brent':>10}  {'error':>8}")
    ratios = {}
    for name, own in seconds.items():
        to = {base: [a / b for a, b in zip(own, seconds[base])] for base in ("swirl double", "brent")}
        ratios[name] = (statistics.median(to["swirl double"]), statistics.median(to["brent"]))
        spread = f"{quantile(to['swirl double'], 0.25):.3g} … {quantile(to['swirl double'], 0.75):.3g}"
        print(f"{name:22} {1e6 * statistics.median(own):10.3g}  {ratios[name][0]:10.3g} [{spread:17}] "
              f"{ratios[name][1]:10.3g}  {judged[name].error:8.1e}")
    return ratios


def print_equal_errors(judged, ratios):
    ladders, own = {}, AS_ACCURATE * judged["swirl double"].error
    for one in contestants():
        ladders.setdefault(one.ladder, []).append((judged[one.name].error, *ratios[one.name]))
    print("x swirl double (x brent) at equal error of an impact, between tolerances or steps")
    print(f"{'':16}" + "".join(f"{error:18.1e}" for error in (*EQUAL_ERRORS, own)) + f"  ({AS_ACCURATE} x Swirl's)")
    for name, points in ladders.items():
        cells = ""
        for error in (*EQUAL_ERRORS, own):
            times = [time_at_error([(point[0], point[base]) for point in points], error) for base in (1, 2)]
            cells += f"{'never':>18}" if None in times else f"{times[0]:9.3g} {f'({times[1]:.3g})':>8}"
        best = min(points)
        note = "" if best[0] <= own else f"  best {best[0]:.1e} at {best[1]:.3g} ({best[2]:.3g})"
        print(f"{name:16}{cells}{note}")


def print_goals(ratios):
    """To one orbit at a time, and to 64 abreast, in one thread, too."""
    for name, goal in (("SUNDIALS 1e-14", 50), ("SciPy 1e-12", 1000), ("brent", 10), ("paper", 10)):
        for base, ratio in (("double", ratios[name][0]), ("abreast", ratios[name][0] / ratios["abreast"][0])):
            verdict = "reached" if ratio >= goal else "not reached"
            print(f"{name}: {ratio:.3g} x swirl {base}, goal {goal}: {verdict}")


def main(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("peers", help="the program built with -DSWIRL_PEERS=ON")
    parser.add_argument("--flights", type=int, default=20000)
    parser.add_argument("--rounds", type=int, default=9)
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args(arguments)
    if options.flights < 1000 or not 1 <= options.rounds <= 50:
        parser.error("--flights must be at least 1000, --rounds 1 to 50")
    if SiconosPeer is None:
        print("Siconos is left out: no python3-siconos")
    with CompiledPeers(options.peers) as compiled:
        for name, scene in SCENES.items():
            print(f"\n{name}: alpha {scene.alpha}, beta {scene.beta}, mu {scene.mu}, e {scene.restitution}; "
                  f"{options.flights} flights, seed {options.seed}, against quad")
            starts, truths = compiled.draw(name, options.seed, options.flights)
            print("Box2D:", compiled.numbers())
            judged = print_misses(scene, compiled, starts, truths)
            print(f"processor time of an impact, {options.rounds} rounds in turns")
            ratios = print_times(scene, compiled, starts, judged, options.rounds)
            print_equal_errors(judged, ratios)
            print_goals(ratios)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
