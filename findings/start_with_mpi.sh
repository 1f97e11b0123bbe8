#!/usr/bin/env bash
# Open MPI 5.0.7 (Debian 13's libopenmpi40): a program that is linked with it sleeps 0.16 s before main, whether it was started
# by mpirun or not, and whatever it does (--help, --version): constructors of two network libraries that libmpi.so.40 brings along
# wait while they measure the processor's clock, libpsm2.so.2 (PSM2 11.2.185) for 0.1 s and libucs.so.0 (UCX 1.18.1) for 0.06 s,
# on machines with none of their hardware. (UCX 1.23 of Debian's unstable waits for 0.4 s; Open MPI 4.1 of Debian 12 loads both in
# MPI_Init alone.) One would guess that nothing happens before MPI_Init. A program that loads MPI where it was started by a
# launcher, and nowhere else, waits there alone. Least of five loads each, so that a busy machine tells the same.
# As root, with mmdebstrap: a root of these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'umount "$root/trixie/proc" 2>/dev/null || true; rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=python3,libopenmpi40 trixie "$root/trixie"
mount -t proc proc "$root/trixie/proc"
chroot "$root/trixie" dpkg-query --show libopenmpi40 libpsm2-2 libucx0
chroot "$root/trixie" /usr/bin/python3 - <<'END'
import subprocess
import sys

LOAD = """import ctypes, resource, sys, time
used = lambda: sum(resource.getrusage(resource.RUSAGE_SELF)[:2])
begin, work = time.monotonic(), used()
ctypes.CDLL(sys.argv[1])
print(time.monotonic() - begin, used() - work)"""


def least(library):
    """Seconds by the clock, and of them at work."""
    return min(tuple(map(float, subprocess.run([sys.executable, "-c", LOAD, library], capture_output=True, text=True,
                                               check=True).stdout.split())) for _ in range(5))


for package, wanted in (("libopenmpi40", "5.0.7"), ("libpsm2-2", "11.2.185"), ("libucx0", "1.18.1")):
    version = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True).stdout
    assert version.startswith(wanted), (package, version)
found = {name: least(name) for name in ("libpsm2.so.2", "libucs.so.0", "libmpi.so.40", "libhwloc.so.15")}
for name, (seconds, work) in found.items():
    print(f"{name} is loaded in {seconds:.3f} s, {work:.3f} s of them at work")
assert found["libpsm2.so.2"][0] >= 0.1 and found["libpsm2.so.2"][1] < 0.05
assert found["libucs.so.0"][0] >= 0.03 and found["libucs.so.0"][1] < 0.03
assert found["libmpi.so.40"][0] >= 0.13 and found["libmpi.so.40"][1] < 0.06
assert found["libhwloc.so.15"][0] < 0.05  # one that waits for nothing
END
