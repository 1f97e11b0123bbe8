#!/usr/bin/env bash
# cbrt of two C libraries of Debian 12, asked for ∛(k/1000), k = 1 … 1000. A good guess is that a function of the C library
# is rounded correctly but in rare cases, and that all give the same number. The GNU C library's (2.36) is not the nearest
# double in 554 of 1,000 cases, musl's (1.2.3) in 84, and the two differ in 547: an iteration that takes its steps from cbrt
# has other last digits, and a chaotic orbit that does other numbers altogether, on another C library. So a map that promises
# the same bits everywhere needs a cube root of its own, of nothing but the arithmetic of IEEE 754.
# As root, with mmdebstrap: a root of these packages alone, in a temporary folder.
set -euo pipefail
root=$(mktemp -d)
trap 'rm -rf "$root"' EXIT
mmdebstrap --quiet --variant=apt --include=gcc,libc6-dev,musl-tools bookworm "$root/bookworm"
cat > "$root/bookworm/tmp/roots.c" <<'END'
#include <math.h>
#include <stdio.h>
int main(void) {
    for (int k = 1; k <= 1000; ++k) {
        volatile double x = k / 1000.0;
        const double root = cbrt(x), nearest = (double)cbrtl((long double)x);
        printf("%d %a %d\n", k, root, root != nearest);
    }
}
END
said=$(chroot "$root/bookworm" bash -euc 'cd /tmp
dpkg-query --show --showformat "\${Package} \${Version}\n" libc6 musl
gcc -O0 roots.c -o with_glibc -lm
musl-gcc -O0 -static roots.c -o with_musl
./with_glibc > glibc && ./with_musl > musl
for library in glibc musl; do
    echo "$library: $(grep -c " 1$" $library) of $(wc -l < $library) are not the nearest double"
done
cut -d" " -f2 glibc > roots.glibc && cut -d" " -f2 musl > roots.musl
echo "they differ in $(diff roots.glibc roots.musl | grep -c "^<")"')
printf '%s\n' "$said"
expected='libc6 2.36-9+deb12u14
musl 1.2.3-1
glibc: 554 of 1000 are not the nearest double
musl: 84 of 1000 are not the nearest double
they differ in 547'
[[ $said == "$expected" ]]
