// Proof that nothing touches between two moments, from what is known at the two moments alone.
//
// On [0, h] let H be the quintic that shares g, g′, g″ with a gap at both ends. With |g⁽⁶⁾| ≤ M,
// |g − H| ≤ M s³(h − s)³/720, and s³(h − s)³ ≤ h⁶ (B₂ + B₃)/20 with B₂, B₃ the middle Bernstein polynomials of degree
// five on [0, h]. Hence g ≤ Σ cₖ Bₖ with H's Bernstein coefficients and M h⁶/14400 added to c₂ and c₃: if no
// coefficient is positive, no contact is between. No square root, no search; no later operation waits for the result. M
// holds on all of [0, h] and not only while nothing is outside: it rests on |P| ≤ outer + β, and P, the centre seen
// from the swirl's, is linear in time and within that at both ends.
#pragma once

#include "map/model/flight.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace swirl::detail {

/// Bounds of |g⁽ᵏ⁾| along a flight, k ≥ 3. In the laboratory the centre is at P = X + w with |P| ≤ outer + β, so that
/// g = |P|² + β² − 2 P·w + … with P linear and w turning at rate 1: the k-th derivative is at most 2β(k|V| + |P|);
/// a vertex adds 2 X·a, with P·a turning at S and w·a at S − 1.
template <class T>
struct DerivativeBounds {
    T centre;
    T vertex;
};

template <int k, class T>
constexpr T power(const T& x) {
    if constexpr (k == 0)
        return T(1);
    else if constexpr (k == 1)
        return x;
    else
        return power<k / 2>(T(x * x)) * power<k % 2>(x);
}

template <int k, Shape shape, class T>
[[gnu::always_inline]] inline DerivativeBounds<T> derivative_bounds(const Body<T>& body, const Flight<T>& flight) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    const T place = body.outer + body.beta;
    DerivativeBounds<T> bounds;
    bounds.centre = T(2) * body.beta * (T(k) * speed + place);
    bounds.vertex = bounds.centre;
    if constexpr (shape == Shape::polygon) {
        const T s = fabs(flight.spin);
        const T relative = fabs(flight.spin - T(1));
        bounds.vertex =
            bounds.centre +
            T(2) * body.alpha * (power<k - 1>(s) * (s * place + T(k) * speed) + body.beta * power<k>(relative));
    }
    return bounds;
}

/// c₁ … c₄ of the bound.
template <class T>
struct InnerCoefficients {
    T first, second, third, fourth;
};

template <class T>
[[gnu::always_inline]] inline InnerCoefficients<T> inner_coefficients(const Gap<T>& from, const Gap<T>& to, const T& h,
                                                                      const T& sixth) {
    const T h2 = h * h;
    const T remainder = sixth * (h2 * h2 * h2) * fraction<T>(1, 14400);
    return {from.value + fraction<T>(1, 5) * h * from.rate,
            from.value + fraction<T>(2, 5) * h * from.rate + fraction<T>(1, 20) * h2 * from.curvature + remainder,
            to.value - fraction<T>(2, 5) * h * to.rate + fraction<T>(1, 20) * h2 * to.curvature + remainder,
            to.value - fraction<T>(1, 5) * h * to.rate};
}

/// True if g ≤ 4ε (rounding) is proven between `from` and `to`, h later. False: not proven, a contact may or may not
/// exist.
template <class T>
[[gnu::always_inline]] inline bool clear_between(const Gap<T>& from, const Gap<T>& to, const T& h, const T& sixth) {
    const T rounding = T(4) * epsilon<T>();
    const auto c = inner_coefficients(from, to, h, sixth);
    // Each comparison is false for a NaN remainder (M overflowed, h⁶ underflowed): it proves nothing.
    return c.first <= rounding && c.second <= rounding && c.third <= rounding && c.fourth <= rounding &&
           from.value <= rounding && to.value <= rounding;
}

template <class T>
inline T fourth_root_of_epsilon() {
    if constexpr (std::is_same_v<T, double>) {
        return 0x1p-13;
    } else {
        using std::sqrt;
        return sqrt(sqrt(epsilon<T>()));
    }
}

/// True if after a correction of fourth order, d, the remaining error is below rounding: d⁴ against ε in the scales
/// g′/g″ and √(g′/g‴), and the next derivative's term, |g⁗| ≤ M. The gap itself must be as small as the correction
/// says: far from a root the correction can vanish too (½gg″ = g′²).
template <class T>
[[gnu::always_inline]] inline bool is_converged(const Gap<T>& gap, const T& correction, const T& time,
                                                const T& fourth) {
    using std::fabs;
    const T small = fourth_root_of_epsilon<T>() / T(4);  // 3·10⁻⁵ in double
    const T size = fabs(correction);
    const T square = size * size;
    return size <= small && size * fabs(gap.curvature) <= small * gap.rate &&
           square * fabs(gap.jerk) <= small * small * gap.rate &&
           fourth * (square * square) <= epsilon<T>() * gap.rate * time && fabs(gap.value) <= T(2) * gap.rate * size;
}

/// True if g ≤ 0 for a time t, by |g‴| ≤ M: up to t the gap is at most g + g′s + ½b s² with b = (g″ + M t/3)⁺, which is
/// convex. Backwards in time g′ changes sign.
template <class T>
[[gnu::always_inline]] inline bool nonpositive_until(const T& value, const T& rate, const T& curvature, const T& t,
                                                     const T& third) {
    const T b = std::max(T(curvature + fraction<T>(1, 3) * third * t), T(0));
    return value <= 0 && value + t * (rate + T(0.5) * b * t) <= 0;
}

/// A gap that may be slightly positive at the ends of an interval and is ≤ 0 in between: positive at most until `out`
/// after the first end and from `in` before the second.
template <class T>
struct ClosedBetween {
    bool proven = false;
    T out{}, in{};
};

/// By the same polynomial: if only c₀ and c₅ are positive, c₀B₀ + c₁B₁ = (1 − s)⁴(c₀(1 − s) + 5c₁s) is not from
/// s = c₀/(c₀ − 5c₁) on.
template <class T>
[[gnu::always_inline]] inline ClosedBetween<T> closed_between(const Gap<T>& from, const Gap<T>& to, const T& h,
                                                              const T& sixth) {
    const T c0 = std::max(from.value, T(0)) + T(4) * epsilon<T>();
    const T c5 = std::max(to.value, T(0)) + T(4) * epsilon<T>();
    const auto c = inner_coefficients(from, to, h, sixth);
    if (!(c.first < 0 && c.fourth < 0 && c.second <= 0 && c.third <= 0)) return {};
    return {true, h * c0 / (c0 - T(5) * c.first), h * c5 / (c5 - T(5) * c.fourth)};
}

/// A search for a root ahead that has no guarantees (those come from `clear_between` afterwards) gives up beyond these.
inline constexpr int correction_limit = 8;
inline constexpr double longest_guess = 16;  // radians of swirl
inline constexpr double longest_correction = 0.5;

}  // namespace swirl::detail
