// A flight and its impact with the impact's time as an unknown of its own: regular where the map is not. As an impact
// grazes, u_n → 0, the time of contact moves as ∂τ = −∂g/g′ and DF grows without bound; g(z, τ) and the state after an
// impact at τ have bounded derivatives.
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/first_contact/vertices.hpp"
#include "map/model/parameter.hpp"
#include "map/numbers/jets.hpp"

#include <Eigen/Core>

#include <array>

namespace swirl {

template <class T, Shape shape>
struct TimedCollision {
    static constexpr int unknowns = section_dimension<shape> + 1;  ///< z, τ
    bool possible = false;   ///< the vertex nearest to the wall at τ approaches it, and not by rounding only
    Collision<T> collision;  ///< its impact, as if it were on the wall
    T gap{};                 ///< g of that vertex at τ: zero at a contact
    Eigen::Matrix<T, unknowns, unknowns> derivative;  ///< of (z after the impact, g) by (z, τ)
};

namespace detail {

/// A touch at u_n = 0 is no impact: a body at rest in the laboratory that the wall touches once a turn solves all
/// equations. Near such a double root g is known to ε and u_n therefore to √ε; this bound is well above √ε.
inline constexpr double least_impact_speed = 1e-6;

/// The vertex nearest to the wall at a moment; the disk has one.
template <Shape shape, class T>
Candidate<T> nearest_to_wall(const Body<T>& body, const Flight<T>& flight, const Instant<T>& at) {
    if constexpr (shape == Shape::disk) {
        return {0, at.centre, centre_gap(body, flight, at)};
    } else {
        NearestTwo<T> pair;
        look_around(body, flight, at, pair);
        return pair.first.gap.value >= pair.second.gap.value ? pair.first : pair.second;
    }
}

}  // namespace detail

/// The impact at `time` after z, whether or not anything is on the wall then and whatever touched before: a solution
/// with gap = 0 is one of the map only if the map's own first contact is at that time. z is just after an impact. Cost:
/// one pass in Jets of dimension + 1, some six collisions.
template <class T, Shape shape, ImpactRule rule>
TimedCollision<T, shape> collide_at(const CollisionMap<T, shape, rule>& in, const SectionPoint<T>& z, const T& time) {
    constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<T, dimension + 1>;
    TimedCollision<T, shape> result;
    const Body<T>& body = in.body();
    const Flight<T> plain_flight = flight_from(body, post_impact_state(z));
    const auto nearest = detail::nearest_to_wall<shape>(body, plain_flight, instant_at<shape>(plain_flight, time));
    result.possible = nearest.gap.rate > T(2 * detail::least_impact_speed);  // g′ = 2 u_n
    if (!result.possible) return result;

    const CollisionMap<Jet, shape, rule> map(scene_in<Jet>(in.scene()));
    const auto c = coordinates<shape>(z);
    std::array<Jet, dimension> seeded;
    for (int i = 0; i < dimension; ++i) seeded[i] = Jet(c[i], i);
    const Flight<Jet> flight = flight_from(map.body(), post_impact_state(section_point<shape>(seeded)));
    const Instant<Jet> at = instant_at<shape>(flight, Jet(time, dimension));
    Collision<Jet> collision;
    Jet gap;
    if constexpr (shape == Shape::disk) {
        gap = dot(at.centre, at.centre) - map.body().inner * map.body().inner;
        map.strike(flight, at, at.centre, 0, collision);  // a disk's strike takes no arm
    } else {
        const Vec2<Jet> arm = map.body().turned_to_vertex(at.arm, nearest.vertex);
        const Vec2<Jet> x = at.centre + arm;
        gap = dot(x, x) - Jet(1);
        map.strike(flight, at, arm, 0, collision);
    }
    const auto next = coordinates<shape>(section_point(collision.after));
    const auto take = [&](int row, const Jet& value) { result.derivative.row(row) = value.v.transpose(); };
    for (int i = 0; i < dimension; ++i) take(i, next[i]);
    take(dimension, gap);
    std::array<T, dimension> after;
    for (int i = 0; i < dimension; ++i) after[i] = next[i].a;
    result.collision.after = post_impact_state(section_point<shape>(after));
    result.collision.flight_time = time;
    result.collision.vertex_step = nearest.vertex;
    result.collision.impulse.mode = collision.impulse.mode;
    result.gap = nearest.gap.value;
    return result;
}

}  // namespace swirl
