// A collision that is known already, once more in Jets: its derivatives by whatever the flight and the scene carry.
//
// The contact time is differentiated by the implicit function theorem, not through the search: with g(z, τ) the gap of
// the vertex that strikes, dτ = −∂_z g / g′ at the contact, which is one Newton step taken in Jet arithmetic.
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/numbers/jets.hpp"

#include <cmath>

namespace swirl {

namespace detail {

/// `strike_along` of a map whose flights are CollisionMap's.
template <template <class, Shape, ImpactRule> class Map, class J, Shape shape, ImpactRule rule>
Collision<J> strike_along_flight(const Map<J, shape, rule>& map, const Flight<J>& flight, const Plain<J>& time,
                                 int vertex) {
    const auto arm_at = [&](const Instant<J>& at) {
        if constexpr (shape == Shape::disk) {
            using std::sqrt;
            return Vec2<J>((map.body().alpha / sqrt(dot(at.centre, at.centre))) * at.centre);
        } else {
            return map.body().turned_to_vertex(at.arm, vertex);
        }
    };
    const Instant<J> nominal = instant_at<shape>(flight, J(time));
    const Vec2<J> arm = arm_at(nominal);
    const Vec2<J> x = nominal.centre + arm;
    // g′ = 2 x·x′; the disk's rim does not move against its centre's gap.
    Vec2<J> rate = nominal.drift;
    if constexpr (shape == Shape::polygon) rate = rate + flight.spin * quarter_turned(arm);
    // dτ = −dg/g′: only g is differentiated. Differentiating g/g′ would add g/g′² times dg′, where g is rounding only:
    // large for flights that graze.
    J shift = J(Plain<J>(-1) / (2 * plain(dot(x, rate)))) * dot(x, x);
    shift.a = Plain<J>(0);  // the value of the time is exact to rounding: only its derivative is used
    const Instant<J> at = instant_at<shape>(flight, J(time) + shift);
    Collision<J> collision;
    map.strike(flight, at, arm_at(at), 0, collision);
    return collision;
}

}  // namespace detail

/// The collision with Jets: `flight` carries the derivatives, `time` and `vertex` are the contact found in plain
/// numbers.
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along(const CollisionMap<J, shape, rule>& map, const Flight<J>& flight, const Plain<J>& time,
                          int vertex) {
    return detail::strike_along_flight(map, flight, time, vertex);
}

}  // namespace swirl
