// Orbits whose speeds leave the numbers: those that die away in a container at rest, and those that grow without end.
#pragma once

#include "map/section.hpp"

namespace swirl {

/// True if a body in a container at rest (β = 0) has slowed down so far that its squares will soon not be held: it dies
/// away geometrically and is called resting. (A body all at rest is left to the search, which proves it.)
template <class T>
bool has_died_away(const Body<T>& body, const Launch<T>& launch) {
    if (body.beta != T(0)) return false;
    const T speed = speed_of(body, launch.vn, launch.vt, launch.spin);
    return speed != T(0) && speed < T(detail::smallest_magnitude);
}

/// True if a body has become so fast, or spins so fast, that its squares will soon not be held (Newton's law with
/// friction creates energy).
template <class T>
bool has_diverged(const Body<T>& body, const Launch<T>& launch) {
    using std::fabs;
    const T largest(detail::largest_magnitude);
    return !(speed_of(body, launch.vn, launch.vt, launch.spin) <= largest && fabs(launch.spin) <= largest);
}

}  // namespace swirl
