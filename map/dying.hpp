// Orbits that die away in a container at rest.
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

}  // namespace swirl
