// DF, exact, by automatic differentiation: the code of the map itself in Jets, to check what is derived by hand
// (map/derivative/saltation.hpp), which shares no formula of a derivative with it.
#pragma once

#include "map/derivative/strike_along.hpp"
#include "map/map_list.hpp"
#include "map/numbers/jets.hpp"

#include <array>

namespace swirl::tests {

/// F and DF at z for one scene.
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
        Scene<Jet> scene{s.sides, Jet(s.alpha),         Jet(s.beta), Jet(s.mu), Jet(s.restitution),
                         s.law,   Jet(s.inertia_factor)};
        scene.tangential_restitution = Jet(s.tangential_restitution);
        return scene;
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
#define SWIRL_DECLARE_DERIVATIVE(T, SHAPE, RULE) extern template class DifferentiatedMap<T, SHAPE, RULE>;
#define SWIRL_COMPILE_DERIVATIVE(T, SHAPE, RULE) template class DifferentiatedMap<T, SHAPE, RULE>;
SWIRL_EVERY_MAP(SWIRL_DECLARE_DERIVATIVE, double)

}  // namespace swirl::tests
