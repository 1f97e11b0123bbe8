#!/usr/bin/env bash
# Highway 1.0.3 (Debian 12's libhwy1): loading the library is enough to have it measure the resolution of the clock. Its
# nanobenchmark is a part of the one shared library, with a static object that is made by hwy::platform::TimerResolution(), which
# reads the clock over and over. So a program that links Highway for its table of instruction sets alone, and calls nothing of
# it, pays for that before main, each time that it is started: about 4 ms of 0.5 on the machine where this was met.
# Shown by a function of the same name that is loaded before and says that it was called. As root, with mmdebstrap: a root of
# these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=g++,libhwy-dev bookworm "$root/bookworm"
cat > "$root/bookworm/tmp/said.cpp" <<'END'
#include <cstdio>
namespace hwy::platform {
double TimerResolution();
double TimerResolution() {
    std::puts("the clock's resolution is asked for");
    return 1e-9;
}
}  // namespace hwy::platform
END
printf '#include <cstdio>\nint main() { std::puts("main"); }\n' > "$root/bookworm/tmp/empty.cpp"
said=$(chroot "$root/bookworm" bash -euc 'cd /tmp
dpkg-query --show --showformat "\${Package} \${Version}\n" libhwy1
g++ -shared -fPIC said.cpp -o said.so
g++ empty.cpp -o without && g++ empty.cpp -o with -Wl,--no-as-needed -lhwy
echo "not linked with libhwy:" && LD_PRELOAD=./said.so ./without
echo "linked with libhwy:" && LD_PRELOAD=./said.so ./with')
printf '%s\n' "$said"
expected='libhwy1 1.0.3-3+deb12u1
not linked with libhwy:
main
linked with libhwy:
the clock'\''s resolution is asked for
main'
[[ $said == "$expected" ]]
