#!/usr/bin/env python3
"""Puts small faults into the sources of the map, one at a time, and says which of them no test of the map notices.

    mutants.py --list                   what would be drawn
    mutants.py                          60 mutants that compile; goes on where it was interrupted
    mutants.py --only 17                the 17th of the draw
    mutants.py --again                  those that survived, once more: after a test was added
    mutants.py --record                 the same, and writes the verdicts to recorded.json
    mutants.py --recorded 5             5 of those that recorded.json calls killed: exit 1 if one of them survives

README.md beside this says what is drawn and what came of it.
"""

import argparse
import itertools
import json
import queue
import sys
import tempfile
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from scratch import Scratch
from sites import drawn

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
RECORDED = HERE / "recorded.json"


class Results:
    """Verdicts by mutant, in a file that is written after each."""

    def __init__(self, file):
        self.file = file
        self.found = json.loads(file.read_text(encoding="utf-8")) if file.exists() else {}

    def put(self, mutant, verdict, reason, seconds):
        self.found[mutant.key] = {"verdict": verdict, "by": reason, "seconds": round(seconds, 1), "kind": mutant.kind}
        self.file.write_text(json.dumps(self.found, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")

    def verdict(self, mutant):
        return self.found.get(mutant.key, {}).get("verdict")


def judge_all(mutants, scratches, results, count):
    """Judges mutants in turn, one in each scratch at a time, until `count` of them compile."""
    free = queue.SimpleQueue()
    for scratch in scratches:
        free.put(scratch)

    def judge(mutant):
        scratch, began = free.get(), time.monotonic()
        try:
            return mutant, *scratch.judge(mutant), time.monotonic() - began
        finally:
            free.put(scratch)

    valid = []
    mutants = iter(mutants)
    with ThreadPoolExecutor(len(scratches)) as pool:
        while len(valid) < count:
            batch = list(itertools.islice(mutants, count - len(valid)))
            if not batch:
                break
            known = [mutant for mutant in batch if results.verdict(mutant)]
            for mutant, verdict, reason, seconds in pool.map(judge, [m for m in batch if m not in known]):
                results.put(mutant, verdict, reason, seconds)
                print(f"{verdict} by {reason} ({seconds:.0f} s)\n  {shown(mutant)}", flush=True)
            valid += [mutant for mutant in batch if results.verdict(mutant) != "invalid"]
    return valid


def shown(mutant):
    return f"{mutant.file}:{mutant.line}: {mutant.kind}\n    {mutant.before.strip()}\n    {mutant.after.strip()}"


def summary(mutants, results):
    survivors = [mutant for mutant in mutants if results.verdict(mutant) == "survived"]
    killed = len(mutants) - len(survivors)
    lines = [f"{killed} of {len(mutants)} mutants killed ({100 * killed / max(1, len(mutants)):.1f} %)"]
    return "\n".join(lines + [f"survived: {shown(mutant)}" for mutant in survivors])


def arguments_of(words):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--count", type=int, default=60, help="mutants that compile (60)")
    parser.add_argument("--jobs", type=int, default=1, help="mutants at a time, each in a copy of its own")
    parser.add_argument("--list", action="store_true", help="print the draw and end")
    parser.add_argument("--only", type=int, metavar="N", help="the Nth of the draw, from 1")
    parser.add_argument("--again", action="store_true", help="judge survivors again")
    parser.add_argument("--record", action="store_true", help="write the verdicts to recorded.json")
    parser.add_argument("--recorded", type=int, metavar="N", help="N of the recorded killed ones must be killed")
    parser.add_argument("--work", type=Path, default=Path(tempfile.gettempdir()) / "swirl-mutants",
                        help="folder of copies, objects and results.json")
    return parser.parse_args(words)


def record(mutants, results):
    """Keeps the verdicts beside this; a reason that a survivor has been given stays."""
    known = json.loads(RECORDED.read_text(encoding="utf-8")) if RECORDED.exists() else {}
    lines = {}
    for mutant in mutants:
        one = {name: results.found[mutant.key][name] for name in ("verdict", "by")}
        reason = known.get(mutant.key, {}).get("reason")
        lines[mutant.key] = {**one, "reason": reason} if reason and one["verdict"] == "survived" else one
    RECORDED.write_text(json.dumps(lines, indent=1, ensure_ascii=False) + "\n", encoding="utf-8")


def recorded_killed(seed, count):
    """The first of the draw that are recorded as killed and whose line still stands."""
    recorded = json.loads(RECORDED.read_text(encoding="utf-8"))
    known = (mutant for mutant in drawn(ROOT, seed) if recorded.get(mutant.key, {}).get("verdict") == "killed")
    return list(itertools.islice(known, count))


def main(words):
    options = arguments_of(words)
    mutants = drawn(ROOT, options.seed)
    if options.recorded:
        mutants = recorded_killed(options.seed, options.recorded)
        if len(mutants) < options.recorded:
            print(f"only {len(mutants)} of the recorded mutants still stand in the sources: draw anew", file=sys.stderr)
            return 2
        options.count = options.recorded
    elif options.only:
        mutants = itertools.islice(mutants, options.only - 1, options.only)
    if options.list:
        for number, mutant in enumerate(itertools.islice(mutants, options.count), 1):
            print(f"{number}. {shown(mutant)}")
        return 0
    scratches = []
    for number in range(options.jobs):
        scratches.append(Scratch(ROOT, options.work / str(number)))
        scratches[-1].prepare()
    fresh = options.recorded or options.only
    results = Results(options.work / ("checked.json" if fresh else "results.json"))
    if fresh:
        results.found = {}
    elif options.again:
        results.found = {key: one for key, one in results.found.items() if one["verdict"] != "survived"}
    judged = judge_all(mutants, scratches, results, options.count)
    print(summary(judged, results))
    if options.record:
        record(judged, results)
    return 1 if options.recorded and any(results.verdict(mutant) != "killed" for mutant in judged) else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
