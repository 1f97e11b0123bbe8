// Orbits whose speeds leave the numbers: those that die away in a container at rest, and those that grow without end.
#pragma once

#include "map/model/section.hpp"

namespace swirl {

/// True if a body in a container at rest (β = 0) has slowed down so far that its squares will soon not be held: it dies
/// away geometrically and is called resting. (A body all at rest is left to the search, which proves it.)
template <class T>
bool has_come_to_rest(const Body<T>& body, const PostImpactState<T>& post_impact) {
    if (body.beta != T(0)) return false;
    const T speed = speed_of(body, post_impact.vn, post_impact.vt, post_impact.spin);
    return speed != T(0) && speed < T(detail::smallest_magnitude);
}

/// True if a body has become so fast, or spins so fast, that its squares will soon not be held (Newton's law with
/// friction creates energy).
template <class T>
bool has_diverged(const Body<T>& body, const PostImpactState<T>& post_impact) {
    using std::fabs;
    const T largest(detail::largest_magnitude);
    return !(speed_of(body, post_impact.vn, post_impact.vt, post_impact.spin) <= largest &&
             fabs(post_impact.spin) <= largest);
}

}  // namespace swirl
