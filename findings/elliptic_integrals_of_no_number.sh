#!/usr/bin/env bash
# Boost 1.74 (Debian 12's) and 1.83 (Debian 13's), the three complete elliptic integrals of a modulus that is not a number, as a
# ratio of speeds that overflowed may be. One would guess that all return NaN, or that all raise a domain error. K(k) and D(k)
# return NaN; E(k) throws, and its text names an argument of a function that the caller did not call: "ellint_rd ... Argument z must
# be > 0, but got 0". So a program that takes E and D side by side sees one come back as NaN, by which a step can be refused, and is
# thrown out by the other: the modulus is to be looked at before.
# As root, with mmdebstrap: two roots of these packages alone, in a temporary folder. Compiled with NDEBUG, as releases are.
set -euo pipefail
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cat >"$folder/integrals.cpp" <<'END'
#include <boost/math/special_functions/ellint_1.hpp>
#include <boost/math/special_functions/ellint_2.hpp>
#include <boost/math/special_functions/ellint_d.hpp>
#include <boost/version.hpp>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

template <class Of>
void show(const char* name, const Of& of) {
    try {
        std::printf("%d %s: %s\n", BOOST_VERSION, name, std::isnan(of(std::nan(""))) ? "nan" : "a number");
    } catch (const std::exception& error) {
        const std::string text = error.what();
        std::printf("%d %s: throws, %s\n", BOOST_VERSION, name, text.substr(text.find("ellint")).c_str());
    }
}

int main() {
    show("K", [](double k) { return boost::math::ellint_1(k); });
    show("E", [](double k) { return boost::math::ellint_2(k); });
    show("D", [](double k) { return boost::math::ellint_d(k); });
}
END
for release in bookworm trixie; do
    case $release in
    bookworm) packages=libboost1.74-dev=1.74.0+ds1-21 ;;
    trixie) packages=libboost1.83-dev=1.83.0-4.2 ;;
    esac
    mmdebstrap --quiet --variant=apt --include="g++,$packages" "$release" "$folder/$release"
    cp "$folder/integrals.cpp" "$folder/$release/"
    chroot "$folder/$release" g++ -std=c++17 -O1 -DNDEBUG integrals.cpp -o integrals
    chroot "$folder/$release" ./integrals
done | tee "$folder/seen"
for version in 107400 108300; do
    grep -qx "$version K: nan" "$folder/seen"
    grep -qx "$version D: nan" "$folder/seen"
    grep -q "^$version E: throws, ellint_rd.*Argument z must be > 0, but got 0" "$folder/seen"
done
