// DF, exact, by automatic differentiation.
//
// The contact time is differentiated by the implicit function theorem, not through the search: with g(z, τ) the gap of
// the vertex that strikes, dτ = −∂_z g / g′ at the contact, which is one Newton step taken in Jet arithmetic.
#pragma once

#include "map/derivative/linearised_collision.hpp"
#include "map/map_list.hpp"

#include <ceres/jet.h>

#include <array>

namespace swirl {

/// The collision with Jets: `flight` carries the derivatives, `time` and `vertex` are the contact found in plain
/// numbers.
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along(const CollisionMap<J, shape, rule>& map, const Flight<J>& flight, const Plain<J>& time,
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
    map.strike(flight, at, arm_at(at), collision);
    return collision;
}

/// F and DF at z for one scene. Cost of DF: some four collisions.
template <class T, Shape shape, ImpactRule rule>
class DifferentiatedMap {
public:
    static constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<T, dimension>;
    using Derivative = Eigen::Matrix<T, dimension, dimension>;

    explicit DifferentiatedMap(const CollisionMap<T, shape, rule>& map) : map_(map), jet_map_(in_jets(map.scene())) {}

    const CollisionMap<T, shape, rule>& map() const { return map_; }

    /// `derivative` is meaningless unless a contact was found.
    LinearisedCollision<T, shape> linearise(const SectionPoint<T>& z) const;

    /// DF, by the section coordinates, where the next collision is known already.
    Derivative derivative_of(const PostImpactState<T>& post_impact, const Collision<T>& known) const;

private:
    static Scene<Jet> in_jets(const Scene<T>& s) {
        return {s.sides, Jet(s.alpha), Jet(s.beta), Jet(s.mu), Jet(s.restitution), s.law, Jet(s.inertia_factor)};
    }

    CollisionMap<T, shape, rule> map_;
    CollisionMap<Jet, shape, rule> jet_map_;
};

template <class T, Shape shape, ImpactRule rule>
DifferentiatedMap(const CollisionMap<T, shape, rule>&) -> DifferentiatedMap<T, shape, rule>;

template <class T, Shape shape, ImpactRule rule>
auto DifferentiatedMap<T, shape, rule>::linearise(const SectionPoint<T>& z) const -> LinearisedCollision<T, shape> {
    const PostImpactState<T> post_impact = post_impact_state(z);
    LinearisedCollision<T, shape> result;
    result.collision = map_.advance(post_impact);
    if (result.collision.outcome == FirstContactOutcome::contact)
        result.derivative = derivative_of(post_impact, result.collision);
    return result;
}

template <class T, Shape shape, ImpactRule rule>
auto DifferentiatedMap<T, shape, rule>::derivative_of(const PostImpactState<T>& post_impact,
                                                      const Collision<T>& known) const -> Derivative {
    Derivative derivative;
    const Flight<Jet> flight = flight_from(jet_map_.body(), seeded<Jet, shape>(post_impact));
    const Collision<Jet> collision = strike_along(jet_map_, flight, known.flight_time, known.vertex_step);
    const auto next = coordinates<shape>(section_point(collision.after));
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[i].v.transpose();
    return derivative;
}

// Compiled once, in differentiated_*.cpp.
SWIRL_EVERY_MAP(SWIRL_DECLARE_DERIVATIVE, double)

}  // namespace swirl
