// DF of a polygon with rounded corners, by hand and along a number of the scene. map/corners/README.md, "Derivative"
#pragma once

#include "map/corners/corner_map.hpp"
#include "map/derivative/parameter.hpp"
#include "map/derivative/saltation.hpp"
#include "map/derivative/strike_along.hpp"

#include <utility>

namespace swirl {

namespace detail {

/// From the body's units to R_c: rows and columns of v_n and v_t.
template <class T>
Matrix5<T> in_container_units(Matrix5<T> d, const T& unit) {
    d.template middleRows<2>(2) *= unit;
    d.template middleCols<2>(2) /= unit;
    return d;
}

/// DF in R_c.
///   struck  (flight, contact_change_of): the state before the impact, and the impulse in the body's units
template <class T, Shape shape, ImpactRule rule, class Struck>
Matrix5<T> corner_derivative(const CornerMap<T, shape, rule>& map, const PostImpactState<T>& start, const T& time,
                             int vertex_step, const Struck& struck) {
    const Body<T>& body = map.body();
    const Flight<T> flight = map.flight_after(start);
    const auto contact = contact_change_of<shape>(body, flight, time, vertex_step);
    Matrix5<T> d = flight_derivative<shape>(flight, contact, time);
    const auto [before, impulse] = struck(flight, contact);
    add_impact<rule, true>(body, map.scene(), before, impulse, d);
    return in_container_units(d, body.unit);
}

}  // namespace detail

/// As of CollisionMap, in the body's units, with the lever arm of the corner.
template <class T, Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CornerMap<T, shape, rule>& map, const PostImpactState<T>& start,
                             const Collision<T>& known) {
    return detail::corner_derivative(
        map, start, known.flight_time, known.vertex_step, [&](const Flight<T>& flight, const auto&) {
            const T& unit = map.body().unit;
            return std::pair(
                detail::before_impact(flight, known.normal, known.after),
                Impulse<T>{known.impulse.normal / unit, known.impulse.tangential / unit, known.impulse.mode});
        });
}

template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const CornerMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const KeptFlight& kept) {
    return detail::corner_derivative(
        map, start, kept.flight_time, kept.vertex_step, [&](const Flight<double>& flight, const auto& contact) {
            const double unit = map.body().unit;
            const PostImpactState<double> before = detail::before_impact(flight, contact.normal, kept.after);
            return std::pair(
                before, Impulse<double>{before.vn - kept.after.vn / unit, kept.after.vt / unit - before.vt, kept.mode});
        });
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
    return detail::along_in_jets(map, parameter, post_impact, known,
                                 [](const auto& jets, const auto& state) { return jets.flight_after(state); });
}

}  // namespace swirl
