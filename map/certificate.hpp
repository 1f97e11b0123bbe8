// Proof that nothing touches between two moments, from what is known at the two moments alone.
//
// On [0, h] let H be the quintic that shares g, g′, g″ with a gap at both ends. With |g⁽⁶⁾| ≤ M,
// |g − H| ≤ M s³(h − s)³/720, and s³(h − s)³ ≤ h⁶ (B₂ + B₃)/20 with B₂, B₃ the middle Bernstein polynomials of degree
// five on [0, h]. Hence g ≤ Σ cₖ Bₖ with H's Bernstein coefficients and M h⁶/14400 added to c₂ and c₃: if no
// coefficient is positive, no contact is between. No square root, no search, and it leaves the critical path free.
#pragma once

#include "map/flight.hpp"

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
    if constexpr (k == 0) return T(1);
    else if constexpr (k == 1) return x;
    else return power<k / 2>(T(x * x)) * power<k % 2>(x);
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
        bounds.vertex = bounds.centre + T(2) * body.alpha * (power<k - 1>(s) * (s * place + T(k) * speed) +
                                                             body.beta * power<k>(relative));
    }
    return bounds;
}

/// True if the gap certainly stays closed to the wall by no more than rounding (4ε) between `from` and `to`, h later.
/// (False says nothing.)
template <class T>
[[gnu::always_inline]] inline bool clear_between(const Gap<T>& from, const Gap<T>& to, const T& h, const T& sixth) {
    const T rounding = T(4) * epsilon<T>();
    const T h2 = h * h;
    const T remainder = sixth * (h2 * h2 * h2) * T(1.0 / 14400);
    const T c1 = from.value + T(0.2) * h * from.rate;
    const T c4 = to.value - T(0.2) * h * to.rate;
    const T c2 = from.value + T(0.4) * h * from.rate + T(0.05) * h2 * from.bend + remainder;
    const T c3 = to.value - T(0.4) * h * to.rate + T(0.05) * h2 * to.bend + remainder;
    const T ends = std::max(from.value, to.value);
    return std::max(std::max(std::max(c1, c4), std::max(c2, c3)), ends) <= rounding;
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

/// True if after a correction of this size the error that is left is below rounding (d⁴ against ε; scale g′/g″). The
/// gap itself must be as small as the correction says: far from a root the correction can vanish too (½gg″ = g′²).
template <class T>
inline bool is_converged(const Gap<T>& gap, const T& correction) {
    using std::fabs;
    const T small = fourth_root_of_epsilon<T>() / T(4);  // 3·10⁻⁵ in double
    const T size = fabs(correction);
    return size <= small && size * fabs(gap.bend) <= small * gap.rate &&
           fabs(gap.value) <= T(2) * gap.rate * size;
}

/// A search for a root ahead that has no guarantees (those come from `clear_between` afterwards) gives up beyond these.
inline constexpr int correction_limit = 8;
inline constexpr double longest_guess = 16;       // radians of swirl
inline constexpr double longest_correction = 0.5;

}  // namespace swirl::detail
