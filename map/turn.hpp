// Rotations kept as cis δ − 1, so that a turn by a tiny angle loses no digits.
#pragma once

#include "map/real.hpp"
#include "map/vec2.hpp"

#include <cmath>

namespace swirl {

/// cis φ = (cos φ, sin φ).
template <class T>
inline Vec2<T> cis(const T& angle) {
    using std::cos;
    using std::sin;
    return {cos(angle), sin(angle)};
}

namespace detail {

/// Below this angle the Taylor polynomials below are good to ε/4 of the result.
inline constexpr double small_turn = 0.3;

/// Taylor polynomials of cos δ − 1 and sin δ; the first term left out is below 2·10⁻¹⁷ of the sum for |δ| ≤ 0.3.
inline Vec2<double> small_turn_minus_one(double d) {
    const double s = d * d;
    const double s2 = s * s;
    const double sine_high = (-1.0 / 39916800 + s * (1.0 / 6227020800.0)) * s2 + (-1.0 / 5040 + s * (1.0 / 362880));
    const double sine = d + d * s * ((-1.0 / 6 + s * (1.0 / 120)) + s2 * sine_high);
    const double cosine_high = (1.0 / 3628800 * -1.0 + s * (1.0 / 479001600)) * s2 + (-1.0 / 720 + s * (1.0 / 40320));
    const double cosine = s * ((-0.5 + s * (1.0 / 24)) + s2 * cosine_high);
    return {cosine, sine};
}

}  // namespace detail

/// cis δ − 1 = (−2 sin²(δ/2), sin δ), each to a few ε of itself when δ is small and of 1 otherwise.
template <class T>
inline Vec2<T> turn_minus_one(const T& angle) {
    if constexpr (std::is_same_v<T, double>) {
        if (std::fabs(angle) <= detail::small_turn) return detail::small_turn_minus_one(angle);
        const Vec2<double> full = cis(angle);
        return {full.x - 1, full.y};
    } else {
        const Vec2<T> half = cis(T(angle * T(0.5)));
        return {T(-2) * half.y * half.y, T(2) * half.y * half.x};
    }
}

/// The composition of two such turns: (1 + a)(1 + b) − 1.
template <class T>
inline Vec2<T> compose(const Vec2<T>& a, const Vec2<T>& b) {
    return a + b + times(a, b);
}

/// v turned: v + v·(cis δ − 1).
template <class T>
inline Vec2<T> turned(const Vec2<T>& v, const Vec2<T>& turn) {
    return v + times(v, turn);
}

}  // namespace swirl
