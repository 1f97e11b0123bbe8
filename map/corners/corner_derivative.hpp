// DF of a polygon with rounded corners, by hand and along a number of the scene. map/corners/README.md, "Derivative"
#pragma once

#include "map/corners/corner_map.hpp"
#include "map/derivative/parameter.hpp"
#include "map/derivative/saltation.hpp"
#include "map/derivative/strike_along.hpp"

#include <Eigen/Core>

#include <cstddef>

namespace swirl {

namespace detail {

/// From the body's units to R_c: rows and columns of v_n and v_t.
template <class T>
Matrix5<T> in_container_units(Matrix5<T> d, const T& unit) {
    d.template middleRows<2>(2) *= unit;
    d.template middleCols<2>(2) /= unit;
    return d;
}

}  // namespace detail

/// As of CollisionMap, in the body's units, with the lever arm of the corner.
template <class T, Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CornerMap<T, shape, rule>& map, const PostImpactState<T>& start,
                             const Collision<T>& known) {
    const Body<T>& body = map.body();
    const Flight<T> flight = map.flight_after(start);
    const auto contact = detail::contact_change_of<shape>(body, flight, known.flight_time, known.vertex_step);
    detail::Matrix5<T> d = detail::flight_derivative<shape>(flight, contact, known.flight_time);
    const PostImpactState<T> before = detail::before_impact(flight, known.normal, known.after);
    const Impulse<T> impulse{known.impulse.normal / body.unit, known.impulse.tangential / body.unit,
                             known.impulse.mode};
    detail::add_impact<rule, true>(body, map.scene(), before, impulse, d);
    return detail::in_container_units(d, body.unit);
}

template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CornerMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const KeptFlight& kept) {
    const Body<double>& body = map.body();
    const Flight<double> flight = map.flight_after(start);
    const auto contact = detail::contact_change_of<shape>(body, flight, kept.flight_time, kept.vertex_step);
    detail::Matrix5<double> d = detail::flight_derivative<shape>(flight, contact, kept.flight_time);
    const PostImpactState<double> before = detail::before_impact(flight, contact.normal, kept.after);
    const Impulse<double> impulse{before.vn - kept.after.vn / body.unit, kept.after.vt / body.unit - before.vt,
                                  kept.mode};
    detail::add_impact<rule, true>(body, map.scene(), before, impulse, d);
    return detail::in_container_units(d, body.unit);
}

/// The flight and its impact in Jets, as of CollisionMap.
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along(const CornerMap<J, shape, rule>& map, const Flight<J>& flight, const Plain<J>& time,
                          int vertex) {
    return detail::strike_along_flight(map, flight, time, vertex);
}

/// ∂F along a number of the scene, r among them, at r = 0, too. As of CollisionMap.
template <class T, Shape shape, ImpactRule rule>
auto derivative_along(const CornerMap<T, shape, rule>& map, Parameter parameter, const PostImpactState<T>& post_impact,
                      const Collision<T>& known) {
    constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<T, 1>;
    Scene<Jet> along = scene_in<Jet>(map.scene());
    number_of(along, parameter).v[0] = T(1);
    const CornerMap<Jet, shape, rule> jets(along);
    const Flight<Jet> flight = jets.flight_after(state_in_jets<Jet>(post_impact));
    const auto collision = strike_along(jets, flight, known.flight_time, known.vertex_step);
    const auto next = coordinates<shape>(section_point(collision.after));
    Eigen::Matrix<T, dimension, 1> result;
    for (int i = 0; i < dimension; ++i) result[i] = next[static_cast<std::size_t>(i)].v[0];
    return result;
}

}  // namespace swirl
