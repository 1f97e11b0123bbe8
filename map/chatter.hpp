// When collision-only following has come to its end: impacts that accumulate (Zeno). Design, section 5.
#pragma once

#include "map/collision_map.hpp"

#include <cmath>

namespace swirl {

/// True if a flight is the end of chatter: with e < 1, it lifted the vertex that had struck by less than the rounding
/// of its position. Its lift is at most |u_n| τ, so no speed threshold is needed: the test is ε itself.
///   launch     the state just after the impact that began the flight
///   collision  the next one
/// Successive flights of chatter shrink geometrically; this is reached within about ln(1/ε)/(1 − e) impacts of the
/// first of them. (An accidental flight as small as this has a probability of order ε.) Only the vertex that had struck
/// counts: two that strike together have no flight between them and may well part. If they don't, their normal
/// velocities shrink from impact to impact until the wall holds them (`ContactOutcome::sustained`).
template <class T>
bool ends_chatter(const Body<T>& body, const T& restitution, const Launch<T>& launch, const Collision<T>& collision) {
    using std::fabs;
    return restitution < T(1) && collision.vertex_step == 0 &&
           fabs(approach_of(body, launch).un) * collision.flight_time <= T(4) * epsilon<T>();
}

/// True if a body in a container at rest (β = 0) has slowed down so far that its squares will soon not be held: it dies
/// away geometrically and is called resting. (A body all at rest is left to the search, which proves it.)
template <class T>
bool has_died_away(const Body<T>& body, const Launch<T>& launch) {
    if (body.beta != T(0)) return false;
    const T speed = speed_of(body, launch.vn, launch.vt, launch.spin);
    return speed != T(0) && speed < T(detail::smallest_magnitude);
}

}  // namespace swirl
