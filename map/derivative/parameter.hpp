// ∂F along one number of the scene.
#pragma once

#include "map/derivative/strike_along.hpp"
#include "map/model/parameter.hpp"
#include "map/numbers/jets.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace swirl {

namespace detail {

/// `derivative_along` of any map with a `strike_along`.
///   flight_of  (map in Jets, post-impact state in Jets): the flight that follows
template <template <class, Shape, ImpactRule> class Map, class T, Shape shape, ImpactRule rule, class FlightOf>
auto along_in_jets(const Map<T, shape, rule>& map, Parameter parameter, const PostImpactState<T>& post_impact,
                   const Collision<T>& known, const FlightOf& flight_of) {
    constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<T, 1>;
    Scene<Jet> along = scene_in<Jet>(map.scene());
    number_of(along, parameter).v[0] = T(1);
    const Map<Jet, shape, rule> jets(along);
    const auto flight = flight_of(jets, state_in_jets<Jet>(post_impact));
    const auto collision = strike_along(jets, flight, known.flight_time, known.vertex_step);
    const auto next = coordinates<shape>(section_point(collision.after));
    Eigen::Matrix<T, dimension, 1> result;
    for (int i = 0; i < dimension; ++i) result[i] = next[static_cast<std::size_t>(i)].v[0];
    return result;
}

}  // namespace detail

/// ∂F/∂λ at a fixed state where the next collision is known, λ the parameter; ∂F/∂z is `derivative_by_saltation`'s. By
/// Jets of one dimension. The uniform lamina's κ does not follow N, which stays. Cost: some two collisions.
template <class T, Shape shape, ImpactRule rule>
auto derivative_along(const CollisionMap<T, shape, rule>& map, Parameter parameter,
                      const PostImpactState<T>& post_impact, const Collision<T>& known) {
    return detail::along_in_jets(map, parameter, post_impact, known,
                                 [](const auto& jets, const auto& state) { return flight_from(jets.body(), state); });
}

}  // namespace swirl
