// Products with a scene's constants whose rounding errors have no bias.
#pragma once

#include "map/numbers/vec2.hpp"

namespace swirl {

/// A constant c that multiplies numbers at every impact, as c₁ + c₂ with c₁ = 1.001248… c.
///
/// A constant of few digits rounds more to one side than to the other. The product with 1/(1 − 0.4) = 5/3 ends in
/// multiples of a sixth of its last place, ties among them, and which way a tie goes is decided by how 5/3 was rounded:
/// always the same way, and J drifts by some ε/70 per impact (map/README.md, "Section coordinates"). c₁ has no
/// such structure: c₁x is rounded up as often as down, its error is spread evenly over the last place, and so the sum
/// c₁x + c₂x is rounded without bias, too. Its error is some 1½ ulp at most (a product's ½). Cost: a product and a sum.
template <class T>
struct UnbiasedFactor {
    T first{}, second{};
};

template <class T>
constexpr UnbiasedFactor<T> unbiased(const T& c) {
    const T first = T(1.0012484394506866) * c;
    return {first, c - first};  // exact: the two are near to each other
}

template <class T>
constexpr T operator*(const UnbiasedFactor<T>& c, const T& x) {
    return c.first * x + c.second * x;
}
template <class T>
constexpr Vec2<T> operator*(const UnbiasedFactor<T>& c, const Vec2<T>& v) {
    return {c * v.x, c * v.y};
}

}  // namespace swirl
