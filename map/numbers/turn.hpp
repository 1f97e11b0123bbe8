// Rotations kept as cis δ − 1, so that a rotation by a small angle keeps all its digits.
#pragma once

#include "map/numbers/real.hpp"
#include "map/numbers/vec2.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>

namespace swirl {

/// cis φ = (cos φ, sin φ).
template <class T>
inline Vec2<T> cis(const T& angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
}

#define SWIRL_INLINED constexpr
#include "map/numbers/turn_formulas.hpp"
#undef SWIRL_INLINED

namespace detail {

inline constexpr int turn_table_size = 65;

/// A tabled vector with what rounding it to double left out. A table's rounding errors do not average out, since
/// the same few entries are used again and again: the rest is added back.
struct TabledVector {
    Vec2<double> value;
    Vec2<double> rest;
};

constexpr TabledVector tabled(const Vec2<long double>& v) {
    const Vec2<double> value{static_cast<double>(v.x), static_cast<double>(v.y)};
    return {value,
            {static_cast<double>(v.x - static_cast<long double>(value.x)),
             static_cast<double>(v.y - static_cast<long double>(value.y))}};
}

/// cis δ − 1 for |δ| ≤ ½ by Taylor's series.
constexpr Vec2<long double> short_turn(long double angle) {
    long double sine = 0;
    long double cosine = 0;  // cos δ − 1
    long double term = 1;
    for (int n = 1; n < 30; ++n) {
        term *= angle / n;
        (n % 2 ? sine : cosine) += n % 4 < 2 ? term : -term;
    }
    return {cosine, sine};
}

/// cis(k/2) − 1, k = 0 … 64, by repeated composition in long double.
constexpr std::array<TabledVector, turn_table_size> turn_table() {
    const Vec2<long double> half = short_turn(0.5L);
    std::array<TabledVector, turn_table_size> table{};
    Vec2<long double> turn{0, 0};
    for (auto& entry : table) {
        entry = tabled(turn);
        turn = compose(turn, half);
    }
    return table;
}

inline constexpr auto half_radians = turn_table();

}  // namespace detail

/// cis δ − 1 = (−2 sin²(δ/2), sin δ), each to a few ε of itself when δ is small and of 1 otherwise.
template <class T>
[[gnu::always_inline]] inline Vec2<T> cis_minus_one(const T& angle) {
    if constexpr (std::is_same_v<T, double>) {
        if (std::fabs(angle) <= 0x1p-13) return tiny_turn_minus_one(angle);
        if (std::fabs(angle) <= 0.25) return small_turn_minus_one(angle);
        if (!(std::fabs(angle) < 32)) {
            const Vec2<double> full = cis(angle);
            return {full.x - 1, full.y};
        }
        // Adding and taking away 1.5·2⁵² rounds to the nearest integer; far quicker than a conversion and back.
        const double nearest = (angle + angle + 0x1.8p52) - 0x1.8p52;
        const int k = static_cast<int>(nearest);
        const detail::TabledVector& entry = detail::half_radians[static_cast<std::size_t>(k < 0 ? -k : k)];
        const double side = k < 0 ? -1 : 1;
        const Vec2<double> coarse{entry.value.x, side * entry.value.y};
        const Vec2<double> fine = small_turn_minus_one(angle - 0.5 * nearest);
        const Vec2<double> rest{entry.rest.x, side * entry.rest.y};
        return compose(coarse, rest, fine);
    } else {
        const Vec2<T> half = cis(T(angle * T(0.5)));
        return {T(-2) * half.y * half.y, T(2) * half.y * half.x};
    }
}

}  // namespace swirl
