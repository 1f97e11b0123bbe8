// How far one may go along a flight without passing a contact.
//
// With |g‴| ≤ M on the way, g(h) ≤ P(h) = g + g′h + ½g″h² + M h³/6, so no contact lies before P's first positive root.
// And for every H, P(h) ≤ g + g′h + ½(g″ + MH/3)h² on [0, H]: the smaller of H and that parabola's first root is safe,
// whatever H is; the closer H is to P's root the longer is the step. Near a transversal contact the error after a step
// h is O(M h³/g′): the advance converges cubically, from below.
#pragma once

#include "map/model/flight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::detail {

/// First positive root of g + g′h + ½ b h² for g < 0; +∞ if there is none.
template <class T>
inline T first_root(const T& g, const T& rate, const T& curvature) {
    using std::sqrt;
    const T discriminant = rate * rate - T(2) * curvature * g;
    if (discriminant < 0) return std::numeric_limits<T>::infinity();
    if (rate >= 0) return T(-2) * g / (rate + sqrt(discriminant));
    if (curvature <= 0) return std::numeric_limits<T>::infinity();
    return (sqrt(discriminant) - rate) / curvature;
}

/// A bound from above for P's first positive root when the parabola without M has none (Lagrange, Kioustelidis).
template <class T>
inline T root_bound(const Gap<T>& gap, const T& third) {
    using std::cbrt;
    using std::sqrt;
    const T leading = third / T(6);
    if (leading == 0) return std::numeric_limits<T>::infinity();
    T bound = cbrt(T(-gap.value / leading));
    if (gap.rate < 0) bound = std::max(bound, T(sqrt(-gap.rate / leading)));
    if (gap.curvature < 0) bound = std::max(bound, T(T(-0.5) * gap.curvature / leading));
    return T(2) * bound;
}

/// A safe step from inside, g < 0.
template <class T>
inline T safe_step(const Gap<T>& gap, const T& third) {
    T reach = first_root(gap.value, gap.rate, gap.curvature);
    if (!(reach < std::numeric_limits<T>::infinity())) reach = root_bound(gap, third);
    if (!(reach < std::numeric_limits<T>::infinity())) return reach;
    const T parabola = gap.curvature + third * reach / T(3);
    const T step = std::min(reach, first_root(gap.value, gap.rate, parabola));
    if (step > T(0.99) * reach) return step;
    const T nearer = T(0.5) * (step + reach);
    const T tighter = gap.curvature + third * nearer / T(3);
    return std::max(step, std::min(nearer, first_root(gap.value, gap.rate, tighter)));
}

/// A safe step off the wall, g = 0 and g′ < 0 (or g′ = 0, g″ < 0): here P/h is a parabola, and its root is exact.
template <class T>
inline T safe_step_off_the_wall(const Gap<T>& gap, const T& third) {
    using std::sqrt;
    const T half_curvature = T(0.5) * gap.curvature;
    const T root = sqrt(half_curvature * half_curvature - T(2) / T(3) * third * gap.rate);
    if (half_curvature > 0) return T(-2) * gap.rate / (half_curvature + root);
    if (third == 0) return std::numeric_limits<T>::infinity();
    return (root - half_curvature) * T(3) / third;
}

}  // namespace swirl::detail
