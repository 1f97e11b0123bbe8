"""Swirl beside SUNDIALS over a floor with dry friction, in one run: dry_floor.py PEERS [--flights N] [--rounds N]

The same flights from the same starts: how far the impacts of CVODE are from Swirl's at each tolerance, and what an impact
costs, in turns, as medians. Both have the means of friction from map/dry."""

import argparse
import statistics
import subprocess

SCENES = ("dry-disk", "dry-hexagon")
TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)


class Peers:
    def __init__(self, program):
        self.process = subprocess.Popen([program], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)

    def lines(self, count, *request):
        self.process.stdin.write(" ".join(map(str, request)) + "\n")
        self.process.stdin.flush()
        return [self.process.stdout.readline().split() for _ in range(count)]


def impacts(lines):
    return [[float(value) for value in line[1:]] if line[0] == "1" else None for line in lines]


def apart(a, b):
    """The largest difference of the time and the state after; none where either found nothing or another vertex struck."""
    if a is None or b is None or a[1] != b[1]:
        return None
    return max(abs(x - y) for x, y in zip(a[:1] + a[2:], b[:1] + b[2:]))


def seconds(peers, name, tolerance, flights):
    return float(peers.lines(1, "follow", name, tolerance, 0, 0, flights, 0.2)[0][0])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("peers", help="the program of the compiled peers")
    parser.add_argument("--flights", type=int, default=64)
    parser.add_argument("--rounds", type=int, default=9)
    options = parser.parse_args()
    peers = Peers(options.peers)
    for scene in SCENES:
        peers.lines(options.flights, "scene", scene, 1, options.flights)
        own = impacts(peers.lines(options.flights, "next", "double", 0, 0, options.flights))
        print(f"{scene}: {options.flights} flights")
        for tolerance in TOLERANCES:
            theirs = impacts(peers.lines(options.flights, "next", "sundials", tolerance, 0, options.flights))
            off = [apart(a, b) for a, b in zip(own, theirs)]
            known = [value for value in off if value is not None]
            pairs = [(seconds(peers, "double", 0, 16), seconds(peers, "sundials", tolerance, 16)) for _ in range(options.rounds)]
            ratios = sorted(b / a for a, b in pairs)
            print(f"  CVODE {tolerance:.0e}: off by {statistics.median(known):.1e} in the median, {max(known):.1e} at most; "
                  f"{len(off) - len(known)} found otherwise; {statistics.median(b for _, b in pairs) * 1e6:.0f} us an impact, "
                  f"Swirl {statistics.median(a for a, _ in pairs) * 1e6:.0f} us: "
                  f"{statistics.median(ratios):.2f} times ({ratios[0]:.2f} to {ratios[-1]:.2f})", flush=True)


if __name__ == "__main__":
    main()
