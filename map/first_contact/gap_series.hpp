// A gap as its Taylor polynomial of tenth degree about one moment, and the root of that near the moment.
//
// One evaluation of the flight a few hundredths of a radian d away from the contact thus gives the contact's time to
// rounding: the truncation error is below M d¹¹/11!, |g⁽¹¹⁾| ≤ M. Two corrections, of fifth and of third order, solve
// the polynomial; only their two divisions are on the critical path.
#pragma once

#include "map/model/flight.hpp"

#include <cmath>
#include <type_traits>

namespace swirl::detail {

/// c[k] = g⁽ᵏ⁾/k!.
template <class T>
struct GapSeries {
    T c[11];
};

/// A root of the polynomial: `first` + `second` after its moment, `second` being the smaller by far.
template <class T>
struct SeriesRoot {
    T first, second;
    T value, rate;     ///< g and g′ at `first`
    T half_curvature;  ///< ½g″ there
};

/// Householder's correction of third order, δ = −g (g′² − ½gg″) / (g′³ − gg′g″ + g²g‴/6): the error d becomes O(d⁴).
template <class T>
[[gnu::always_inline]] inline T householder(const T& value, const T& rate, const T& half_curvature,
                                            const T& sixth_jerk) {
    const T square = rate * rate;
    const T curvature = half_curvature + half_curvature;
    return -(value * (square - value * half_curvature)) /
           (rate * (square - value * curvature) + value * (value * sixth_jerk));
}

/// The same of fourth order: with A₀ = 1 and Aₖ = c₁Aₖ₋₁ − c₀c₂Aₖ₋₂ + c₀²c₃Aₖ₋₃ − …, the n-th is −c₀Aₙ₋₁/Aₙ.
template <class T>
[[gnu::always_inline]] inline T householder(const GapSeries<T>& g) {
    const auto& c = g.c;
    const T square = c[1] * c[1];
    const T r = c[0] * c[2];
    const T t = c[0] * c[0] * c[3];
    const T third = c[1] * (square - (r + r)) + t;
    const T fourth =
        square * (square - c[0] * (T(3) * c[2])) + (r * r + (T(2) * c[1] * t - c[0] * c[0] * (c[0] * c[4])));
    return -(c[0] * third) / fourth;
}

template <class T>
[[gnu::always_inline]] inline SeriesRoot<T> root_of(const GapSeries<T>& g) {
    const auto& c = g.c;
    SeriesRoot<T> root;
    root.first = householder(g);
    const T d = root.first;
    const T d2 = d * d;
    const T d4 = d2 * d2;
    root.value = ((c[0] + c[1] * d) + d2 * (c[2] + c[3] * d)) +
                 d4 * (((c[4] + c[5] * d) + d2 * (c[6] + c[7] * d)) + d4 * ((c[8] + c[9] * d) + d2 * c[10]));
    root.rate = ((c[1] + T(2) * c[2] * d) + d2 * (T(3) * c[3] + T(4) * c[4] * d)) +
                d4 * (((T(5) * c[5] + T(6) * c[6] * d) + d2 * (T(7) * c[7] + T(8) * c[8] * d)) +
                      d4 * (T(9) * c[9] + T(10) * c[10] * d));
    root.half_curvature = ((c[2] + T(3) * c[3] * d) + d2 * (T(6) * c[4] + T(10) * c[5] * d)) +
                          d4 * ((T(15) * c[6] + T(21) * c[7] * d) + d2 * (T(28) * c[8] + T(36) * c[9] * d));
    root.second = -(root.value * root.rate) / (root.rate * root.rate - root.value * root.half_curvature);
    return root;
}

/// The gap at the root.
template <class T>
[[gnu::always_inline]] inline Gap<T> gap_at(const GapSeries<T>& g, const SeriesRoot<T>& root) {
    const T jerk = T(6) * (g.c[3] + T(4) * g.c[4] * root.first);
    return {T(0), root.rate + T(2) * root.second * root.half_curvature, T(2) * root.half_curvature + root.second * jerk,
            jerk};
}

template <class T>
inline T cube_root_of_epsilon() {
    if constexpr (std::is_same_v<T, double>) {
        return 0x1p-17;
    } else {
        using std::cbrt;
        return cbrt(epsilon<T>());
    }
}

/// True if both errors of the root are far below rounding, so that they do not accumulate either: O(d³) of the
/// polynomial's root after the second correction d (scale g′/g″), and the truncated term of the flight, |g⁽¹¹⁾| ≤
/// `eleventh`. The gap must be as small as the correction says: far from a root the correction can vanish too.
template <class T>
[[gnu::always_inline]] inline bool is_converged(const SeriesRoot<T>& root, const T& time, const T& eleventh) {
    using std::fabs;
    const T small = cube_root_of_epsilon<T>() / T(8);
    const T size = fabs(root.second);
    const T d = fabs(root.first);
    const T d2 = d * d;
    const T d4 = d2 * d2;
    return size <= small && size * fabs(root.half_curvature) <= small * root.rate &&
           fabs(root.value) <= T(2) * root.rate * size &&
           eleventh * (d4 * d4 * (d2 * d)) * fraction<T>(1, 39916800) <=
               fraction<T>(1, 1024) * epsilon<T>() * root.rate * time;
}

}  // namespace swirl::detail
