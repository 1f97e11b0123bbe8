// When collision-only following has come to its end: impacts that accumulate (Zeno). Design, section 5.
#pragma once

#include "map/collision_map.hpp"

#include <cmath>

namespace swirl {

/// True if a flight is the end of chatter: with e < 1, it lifted the vertex that had struck by less than the rounding
/// of its position. Its lift is at most |u_n| τ, so no speed threshold is needed: the test is ε itself.
///   launch       the state just after the impact that began the flight
///   flight_time  τ
/// Successive flights of chatter shrink geometrically; this is reached within about ln(1/ε)/(1 − e) impacts of the
/// first of them. (An accidental flight as small as this has a probability of order ε.)
template <class T>
bool ends_chatter(const Body<T>& body, const T& restitution, const Launch<T>& launch, const T& flight_time) {
    using std::fabs;
    return restitution < T(1) && fabs(approach_of(body, launch).un) * flight_time <= T(4) * epsilon<T>();
}

}  // namespace swirl
