#!/usr/bin/env bash
# UCX 1.18.1 (Debian 13's libucx0, which libopenmpi40 of Open MPI 5 links): a constructor of libucs.so.0 installs a handler of
# SIGHUP when the library is loaded, before main and without a look at what was there. A process that nohup has started, with
# SIGHUP ignored, no longer ignores it from then on; so a program that is linked with MPI, and asks in main whether SIGHUP is
# ignored (the convention by which nohup works), hears that it is not, and ends with its terminal. Without the library the
# signal stays ignored. Open MPI 4.1 of Debian 12 loads UCX in MPI_Init alone.
# As root, with mmdebstrap: a root of these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'umount "$root/trixie/proc" 2>/dev/null || true; rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=python3,libopenmpi40 trixie "$root/trixie"
mount -t proc proc "$root/trixie/proc"
chroot "$root/trixie" dpkg-query --show libopenmpi40 libucx0
chroot "$root/trixie" nohup /usr/bin/python3 - <<'END' 2>/dev/null
import ctypes
import re
import subprocess


def ignores_hangup():
    with open("/proc/self/status") as status:
        return bool(int(re.search(r"SigIgn:\s*(\w+)", status.read())[1], 16) & 1)


version = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", "libucx0"], capture_output=True, text=True).stdout
assert version.startswith("1.18.1"), version
before = ignores_hangup()
ctypes.CDLL("libmpi.so.40")
print("SIGHUP ignored under nohup:", before, "; once libmpi.so.40 is loaded:", ignores_hangup())
assert (before, ignores_hangup()) == (True, False)
END
