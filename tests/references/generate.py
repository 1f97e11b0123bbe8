"""Recomputes the reference files of this folder in 50-digit arithmetic, from the equations of motion and without Swirl.

    generate.py FILE --check [--sample K --seed S]    compare all of FILE's entries, or K of them
    generate.py FILE -o OUT                           write FILE as it should be

FILE gives the scenes and the starts. fixed_points.json as a whole is searched for from its scene alone. Printed is the
largest difference in units of what is allowed: one unit of the last decimal digit of a number, one epsilon of a double.
Exit: 0 they agree, 1 they do not, 2 the input is wrong.
"""

import argparse
import json
import random
import sys
from pathlib import Path

from mpmath import mp, mpf

from entries import digits_of, recomputed, searched_fixed_points
from row_lines import row_lines

SCENE = ("sides", "alpha", "beta", "mu", "restitution", "law")
# An `amplification` that is listed belongs to one error of the start, which is not known; ours is the largest of all
# errors. One error's growth is at most that (sqrt(6) times it, if it was measured by its largest component). The lower
# end is what a direction may lose by chance.
AMPLIFICATION_RANGE = (1e-2, 6 ** 0.5)


def excess_of_decimal(listed, computed, digits):
    """|difference| in units of the last of so many significant digits; infinite for a number that should be 0."""
    a, b = mpf(listed), mpf(computed)
    if a == b:
        return 0.0
    return float(abs(a - b) / mpf(10) ** (mp.floor(mp.log10(abs(b))) + 1 - digits)) if b else float("inf")


def excess_of_multipliers(listed, computed):
    """Each with the nearest one left, in epsilons of max(1, modulus)."""
    if len(listed) != len(computed):
        return float("inf")
    left, worst = [complex(*m) for m in listed], 0.0
    for m in (complex(*pair) for pair in computed):
        nearest = min(left, key=lambda other: abs(other - m))
        left.remove(nearest)
        worst = max(worst, abs(nearest - m) / (sys.float_info.epsilon * max(1, abs(m))))
    return worst


def excess(listed, computed, digits, key=""):
    """The largest difference of two entries, in units of what is allowed."""
    if key == "residual":  # of the arithmetic that made the file: no property of the cycle
        return 0.0
    if key == "amplification":
        return 0.0 if AMPLIFICATION_RANGE[0] <= listed / computed <= AMPLIFICATION_RANGE[1] else float("inf")
    if key == "multipliers":
        return excess_of_multipliers(listed, computed)
    if isinstance(computed, dict):
        if listed.keys() != computed.keys():
            return float("inf")
        return max(excess(listed[name], computed[name], digits, name) for name in computed)
    if isinstance(computed, list):
        if len(listed) != len(computed):
            return float("inf")
        return max(excess(a, b, digits) for a, b in zip(listed, computed))
    if isinstance(computed, str) and key not in ("law", "floor", "regime", "event", "support"):
        return excess_of_decimal(listed, computed, digits)
    return 0.0 if listed == computed else float("inf")


def recomputed_all(entries, longest_flight):
    """Every entry; the fixed points by a search that knows of the file only the scene and the longest flight."""
    if longest_flight is None:
        return [recomputed(entry) for entry in entries]
    return searched_fixed_points({name: entries[0][name] for name in SCENE}, mpf(longest_flight))


def check(document, key, sample, seed):
    entries = document[key]
    chosen = range(len(entries)) if sample is None else sorted(random.Random(seed).sample(range(len(entries)), sample))
    if sample is None:
        computed = recomputed_all(entries, document.get("longest_flight"))
    else:
        computed = [recomputed(entries[i]) for i in chosen]
    if len(computed) != len(chosen):
        print(f"{len(entries)} entries, but there are {len(computed)}")
        return 1
    worst = [excess(entries[i], new, digits_of(new)) for i, new in zip(chosen, computed)]
    for i, value in zip(chosen, worst):
        if value > 1:
            print(f"entry {i}: {value:.3g} of what is allowed")
    print(f"{len(worst)} of {len(entries)} entries compared, largest difference {max(worst):.3f} of what is allowed")
    return 0 if max(worst) <= 1 else 1


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", type=Path, metavar="FILE", help="a reference file in JSON")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true", help="compare")
    what.add_argument("-o", dest="out", type=Path, metavar="OUT", help="write")
    parser.add_argument("--sample", type=int, metavar="K", help="so many entries, drawn at random (default: all)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="of the sample (default 1)")
    given = parser.parse_args()
    try:
        document = json.loads(given.file.read_text())
    except (OSError, ValueError) as error:
        parser.error(f"{given.file}: {error}")
    key = next((name for name in ("cases", "cycles") if name in document), None)
    if key is None or not document[key]:
        parser.error(f"{given.file}: holds neither cases nor cycles")
    if given.sample is not None and not 1 <= given.sample <= len(document[key]):
        parser.error(f"--sample {given.sample}: must be 1 to {len(document[key])}")
    return given, document, key


def main():
    given, document, key = arguments()
    if given.check:
        return check(document, key, given.sample, given.seed)
    document[key] = recomputed_all(document[key], document.get("longest_flight"))
    given.out.write_text(row_lines(document) + "\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())
