"""The peers solve the same equations as Swirl: same_physics_test.py [PEERS | --without-peers] [--write]

The first five impacts of an orbit, each from where the exact map has put the body (a chaotic orbit would
enlarge errors at each), against the map in quad: first_impacts.json holds both. SciPy alone by default; with the
program PEERS that map itself, SUNDIALS, Box2D and Siconos, too. --write makes the file anew. Exit code 77: a package is
missing, and the test skipped. On the hexagon with friction SciPy and SUNDIALS have Poisson's law, Box2D and Siconos
Newton's.
"""

import json
import statistics
import sys
from dataclasses import replace
from pathlib import Path

try:
    from scipy_peer import ScipyPeer
except ImportError:
    print("skipped: python3-scipy is not installed (packages.txt)")
    sys.exit(77)
try:
    from siconos_peer import SiconosPeer
except ImportError:
    SiconosPeer = None

from compiled_peers import CompiledPeers
from container_frame import SCENES, WHERE_LAWS_DIFFER, Impact
from judgement import state_error

sys.path.insert(0, str(Path(__file__).parents[2] / "references"))
from row_lines import row_lines  # noqa: E402

FILE = Path(__file__).with_name("first_impacts.json")
SEED = 1
IMPACTS = 5
TOLERANCE = 3e-14
SAME = 1e-10  # of times and states of order 1: the tolerance, times the steps and what one impact enlarges
STEP = 1e-3
ENLARGED = 1e-8  # last bits of the map or of a libm, many times larger after each impact of the orbit
ROUGH = "rough-hexagon"
OF_A_STEP = 100 * STEP  # first order, times that factor; Box2D's slop is half a step
SHORT = 0.05  # the integrators' longest step; what they miss with longer ones compare.py counts


def difference(impacts, truths):
    """The largest of times and states; infinite if a vertex differs or an impact is missing."""
    if not all(a.found and a.vertex == b.vertex for a, b in zip(impacts, truths)):
        return float("inf")
    return max(max(abs(a.time - b.time), state_error(a, b)) for a, b in zip(impacts, truths))


def read_file():
    entries = json.loads(FILE.read_text(encoding="utf-8"))
    return {name: ([tuple(one["start"]) for one in flights],
                   [Impact(True, one["time"], one["vertex"], tuple(one["after"])) for one in flights])
            for name, flights in entries.items()}


def write_file(program):
    entries = {}
    with CompiledPeers(program) as compiled:
        for name in (*SCENES, ROUGH):
            entries[name] = [{"start": start, "time": impact.time, "vertex": impact.vertex, "after": impact.after}
                             for start, impact in zip(*compiled.draw(name, SEED, IMPACTS))]
    FILE.write_text(row_lines(entries) + "\n", encoding="utf-8")


class Checks:
    def __init__(self):
        self.failed = 0

    def below(self, what, value, limit):
        self._say(what, value, value <= limit, f"at most {limit:.1e}")

    def above(self, what, value, limit):
        self._say(what, value, value >= limit, f"at least {limit:.1e}")

    def _say(self, what, value, good, wanted):
        self.failed += not good
        print(f"{'ok  ' if good else 'FAIL'} {what}: {value:.2e}, {wanted}")


def check_scipy(checks, name, starts, truths):
    def largest(scene):
        peer = ScipyPeer(scene, TOLERANCE, SHORT)
        return difference([peer.next(start) for start in starts], truths)

    scene = (SCENES | WHERE_LAWS_DIFFER)[name]
    checks.below(f"{name}, SciPy", largest(scene), SAME)
    wider = replace(scene, beta=scene.beta * (1 + 1e-6))
    checks.above(f"{name}, SciPy with a swirl wider by 1e-6 (so that this test can fail)", largest(wider), 100 * SAME)


def check_compiled(checks, name, starts, truths, compiled):
    drawn, exact = compiled.draw(name, SEED, IMPACTS)
    apart = max(abs(a - b) for one, other in zip(drawn, starts) for a, b in zip(one, other))
    checks.below(f"{name}, first_impacts.json, its starts against those drawn", apart, ENLARGED)
    first = difference(exact[:1], truths[:1])
    checks.below(f"{name}, first_impacts.json, its first impact against the map in quad", first, SAME)
    alone, abreast = (compiled.next(peer, 0, 0, IMPACTS) for peer in ("double", "abreast"))
    checks.below(f"{name}, abreast, against double", difference(abreast, alone), 0)
    for peer in ("double", "brent", "sundials"):
        checks.below(f"{name}, {peer}", difference(compiled.next(peer, TOLERANCE, SHORT, IMPACTS), exact), SAME)
    if name in SCENES:
        first = compiled.next("box2d", 0, STEP, 1)
        checks.below(f"{name}, Box2D, first impact", difference(first, exact[:1]), OF_A_STEP)


def check_law(checks, name, impacts, compiled):
    """Newton's, not Poisson's, in the median: where r_t is small the two are nearly one."""
    errors = [statistics.median(state_error(a, b) for a, b in zip(impacts, compiled.next(law, 0, 0, len(impacts))))
              for law in ("newton", "double")]
    checks.below(f"{ROUGH}, {name}, its error under Newton's law over that under Poisson's", errors[0] / errors[1], 0.5)


def check_laws(checks, compiled):
    starts, _ = compiled.draw(ROUGH, SEED, 24)
    check_law(checks, "Box2D", compiled.next("box2d", 0, STEP, len(starts)), compiled)
    if SiconosPeer is not None:
        peer = SiconosPeer(WHERE_LAWS_DIFFER[ROUGH], STEP)
        check_law(checks, "Siconos", [peer.next(start) for start in starts], compiled)


def check_siconos(checks, name, starts, truths):
    errors = [difference([SiconosPeer(SCENES[name], h).next(starts[0])], truths[:1]) for h in (10 * STEP, STEP)]
    checks.below(f"{name}, Siconos, first impact", errors[1], OF_A_STEP)
    checks.below(f"{name}, Siconos, its error over that with ten times the step", errors[1] / errors[0], 0.5)


def main(arguments):
    if "--without-peers" in arguments:
        print("skipped: SUNDIALS, Box2D and Siconos need -DSWIRL_PEERS=ON and packages.txt")
        return 77
    program = next((argument for argument in arguments if argument != "--write"), None)
    if "--write" in arguments:
        write_file(program)
    checks = Checks()
    for name, (starts, truths) in read_file().items():
        check_scipy(checks, name, starts, truths)
        if program is None:
            continue
        with CompiledPeers(program) as compiled:
            check_compiled(checks, name, starts, truths, compiled)
            if name == ROUGH:
                check_laws(checks, compiled)
        if SiconosPeer is not None and name in SCENES:
            check_siconos(checks, name, starts, truths)
    if program is not None and SiconosPeer is None:
        print("skipped: Siconos, python3-siconos is not installed (packages.txt)")
        return checks.failed or 77
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
