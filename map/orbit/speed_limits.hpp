// Orbits whose speeds leave the range of numbers: decaying ones in a container at rest, and diverging ones.
#pragma once

#include "map/model/section.hpp"

#include <cmath>

namespace swirl {

/// True if β = 0 and the speed is below 10⁻⁷⁵, where its powers underflow: it decays geometrically, and the orbit ends
/// as `resting`. (For a speed of exactly zero the search proves that no contact follows.)
template <class T>
bool has_come_to_rest(const Body<T>& body, const PostImpactState<T>& post_impact) {
    if (body.beta != T(0)) return false;
    const T speed = speed_of(body, post_impact.vn, post_impact.vt, post_impact.spin);
    return speed != T(0) && speed < T(detail::smallest_magnitude);
}

/// True if a speed or the spin exceeds 10⁷⁵, where its powers overflow (Newton's law with friction can create energy).
template <class T>
bool has_diverged(const Body<T>& body, const PostImpactState<T>& post_impact) {
    using std::fabs;
    const T largest(detail::largest_magnitude);
    return !(speed_of(body, post_impact.vn, post_impact.vt, post_impact.spin) <= largest &&
             fabs(post_impact.spin) <= largest);
}

/// True if a velocity, the spin or the impulse is infinite or NaN: there is no such impact. Speeds that outgrow the
/// numbers within contact, strike by strike (Newton's law with friction), or an inertia factor κ so far below rounding
/// that powers of 1/κ overflow, lead there.
template <class T>
bool is_out_of_range(const PostImpactState<T>& post_impact, const T& impulse) {
    const T sum = post_impact.vn + post_impact.vt + post_impact.spin + impulse;
    return !(sum - sum == T(0));
}

}  // namespace swirl
