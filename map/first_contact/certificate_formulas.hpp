
#include <algorithm>
#include <cmath>
// Bounds along a flight and what they prove between two moments, for numbers and for lanes
// (numbers/vec2_formulas.hpp says how).

/// The rounding of g′ at a start on the wall: a normal velocity below it counts as zero.
template <class T>
[[gnu::always_inline]] inline T rate_rounding(const Body<T>& body, const Flight<T>& flight) {
    using std::fabs;
    const T speed = fabs(flight.velocity.x) + fabs(flight.velocity.y);
    return T(16) * epsilon<T>() * (speed + body.beta + fabs(flight.spin) * body.alpha);
}

/// Bounds |g‴| of the centre's gap, |W| ≤ `drift`.
template <class T>
[[gnu::always_inline]] inline T centre_third(const Body<T>& body, const T& drift) {
    return T(2) * body.beta * (T(3) * drift + body.outer);
}

/// Bounds |g‴| of any vertex: (2 X·a)‴ = 2 (X‴·a + 3 X″·a′ + 3 X′·a″ + X·a‴), |X| ≤ outer, |X″| = |X‴| = β, |a⁽ᵏ⁾| =
/// α|S|ᵏ.
template <class T>
[[gnu::always_inline]] inline T vertex_third(const Body<T>& body, const Flight<T>& flight, const T& drift) {
    using std::fabs;
    const T s = fabs(flight.spin);
    return centre_third(body, drift) +
           T(2) * body.alpha * (body.beta + s * (T(3) * body.beta + s * (T(3) * drift + s * body.outer)));
}

/// Bounds of |g⁽ᵏ⁾| along a flight, k ≥ 3. In the laboratory the centre is at P = X + w with |P| ≤ outer + β, so that
/// g = |P|² + β² − 2 P·w + … with P linear and w turning at rate 1: the k-th derivative is at most 2β(k|V| + |P|);
/// a vertex adds 2 X·a, with P·a turning at S and w·a at S − 1.
template <class T>
struct DerivativeBounds {
    T centre;
    T vertex;
};

template <int k, class T>
[[gnu::always_inline]] constexpr T power(const T& x) {
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
[[gnu::always_inline]] inline Truth<T> clear_between(const Gap<T>& from, const Gap<T>& to, const T& h, const T& sixth) {
    const T rounding = T(4) * epsilon<T>();
    const auto c = inner_coefficients(from, to, h, sixth);
    // Each comparison is false for a NaN remainder (M overflowed, h⁶ underflowed): it proves nothing.
    return c.first <= rounding && c.second <= rounding && c.third <= rounding && c.fourth <= rounding &&
           from.value <= rounding && to.value <= rounding;
}

/// True if after a correction of fourth order, d, the remaining error is below rounding: d⁴ against ε in the scales
/// g′/g″ and √(g′/g‴), and the next derivative's term, |g⁗| ≤ M. The gap itself must be as small as the correction
/// says: far from a root the correction can vanish too (½gg″ = g′²).
template <class T>
[[gnu::always_inline]] inline Truth<T> is_converged(const Gap<T>& gap, const T& correction, const T& time,
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
[[gnu::always_inline]] inline Truth<T> nonpositive_until(const T& value, const T& rate, const T& curvature, const T& t,
                                                         const T& third) {
    using std::max;
    const T b = max(T(curvature + fraction<T>(1, 3) * third * t), T(0));
    return value <= 0 && value + t * (rate + T(0.5) * b * t) <= 0;
}

/// A gap that may be slightly positive at the ends of an interval and is ≤ 0 in between: positive at most until `out`
/// after the first end and from `in` before the second. Not proven: neither has a meaning.
template <class T>
struct ClosedBetween {
    Truth<T> proven;
    T out, in;
};

/// By the same polynomial: if only c₀ and c₅ are positive, c₀B₀ + c₁B₁ = (1 − s)⁴(c₀(1 − s) + 5c₁s) is not from
/// s = c₀/(c₀ − 5c₁) on.
template <class T>
[[gnu::always_inline]] inline ClosedBetween<T> closed_between(const Gap<T>& from, const Gap<T>& to, const T& h,
                                                              const T& sixth) {
    using std::max;
    const T c0 = max(from.value, T(0)) + T(4) * epsilon<T>();
    const T c5 = max(to.value, T(0)) + T(4) * epsilon<T>();
    const auto c = inner_coefficients(from, to, h, sixth);
    return {c.first < 0 && c.fourth < 0 && c.second <= 0 && c.third <= 0, h * c0 / (c0 - T(5) * c.first),
            h * c5 / (c5 - T(5) * c.fourth)};
}
