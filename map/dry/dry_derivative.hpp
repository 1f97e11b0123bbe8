// DF over a floor with dry friction, and ∂F along a number of the scene: the known flight once more in Jets, by the
// same steps. map/dry/README.md, "Derivative".
#pragma once

#include "map/derivative/parameter.hpp"
#include "map/derivative/saltation.hpp"
#include "map/dragged/dragged_derivative.hpp"
#include "map/dry/dry_map.hpp"
#include "map/numbers/jets.hpp"

#include <array>
#include <cstddef>

namespace swirl {

namespace detail {

template <class J>
struct JetStation {
    Station<J> station;
    bool has_stopped = false;
};

/// The last station before `time`, or that where the body stops.
template <class J>
JetStation<J> station_before(const DryFlight<double>& plain_flight, const DryFlight<J>& flight, double time) {
    DryCourse course(plain_flight);
    JetStation<J> last{first_station(flight), course.has_stopped()};
    while (!last.has_stopped) {
        course.advance();
        if (course.station().time >= time) return last;
        Station<J>& at = last.station;
        at.y = slowing_after(flight, at, J(course.step()));
        at.time = J(course.station().time);
        at.rate = slowing_rate(flight, at.time, at.y);
        last.has_stopped = course.has_stopped();
    }
    return last;
}

/// The collision in Jets.
///   map   in double; jets  the same in Jets
template <class J, Shape shape, ImpactRule rule>
Collision<J> strike_along_course(const DryMap<double, shape, rule>& map, const DryMap<J, shape, rule>& jets,
                                 const PostImpactState<double>& start, const PostImpactState<J>& start_in_jets,
                                 double time, int vertex) {
    const DryFlight<double> plain_flight = map.dry_flight(flight_from(map.body(), start));
    const DryFlight<J> flight = jets.dry_flight(flight_from(jets.body(), start_in_jets));
    const JetStation<J> before = station_before(plain_flight, flight, time);
    const Station<J>& at = before.station;
    if (before.has_stopped) {
        const Flight<J> rest = resting(flight, dry_moment<shape>(flight, at.time, at.y));
        return strike_along_flight(jets.impacts(), rest, time - plain(at.time), vertex);
    }
    const Body<J>& body = jets.body();
    const auto arm_at = [&](const DryMoment<J>& moment) { return arm_of_contact<shape>(body, moment.at, vertex); };
    Slowing<J> y = slowing_after(flight, at, J(time) - at.time);
    const DryMoment<J> nominal = dry_moment<shape>(flight, J(time), y);
    const J shift = contact_shift<shape>(body, nominal.at, nominal.spin, arm_at(nominal));
    const Slowing<J> rate = slowing_rate(flight, J(time), y);
    for (std::size_t i = 0; i < y.size(); ++i) y[i] = y[i] + J(plain(rate[i])) * shift;
    const DryMoment<J> moment = dry_moment<shape>(flight, J(time) + shift, y);
    Collision<J> collision;
    jets.impacts().strike(arriving(flight, moment), moment.at, arm_at(moment), 0, collision);
    return collision;
}

template <Shape shape, ImpactRule rule>
auto derivative_by_jets(const DryMap<double, shape, rule>& map, const PostImpactState<double>& start, double time,
                        int vertex) {
    constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<double, dimension>;
    const DryMap<Jet, shape, rule> jets(scene_in<Jet>(map.scene()), nullptr, map.pressure());
    const auto c = coordinates<shape>(section_point(start));
    std::array<Jet, dimension> seeded;
    for (int i = 0; i < dimension; ++i) seeded[static_cast<std::size_t>(i)] = Jet(c[static_cast<std::size_t>(i)], i);
    const auto collision =
        strike_along_course(map, jets, start, post_impact_state(section_point<shape>(seeded)), time, vertex);
    const auto next = coordinates<shape>(section_point(collision.after));
    Eigen::Matrix<double, dimension, dimension> derivative;
    for (int i = 0; i < dimension; ++i) derivative.row(i) = next[static_cast<std::size_t>(i)].v.transpose();
    return derivative;
}

}  // namespace detail

/// DF(z) where the next collision is known. Cost: some four collisions.
template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const DryMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const Collision<double>& known) {
    return detail::derivative_by_jets(map, start, known.flight_time, known.vertex_step);
}

template <Shape shape, ImpactRule rule>
auto derivative_by_saltation(const DryMap<double, shape, rule>& map, const PostImpactState<double>& start,
                             const KeptFlight& kept) {
    return detail::derivative_by_jets(map, start, kept.flight_time, kept.vertex_step);
}

/// ∂F/∂λ at a fixed state where the next collision is known. By Jets of one dimension.
template <Shape shape, ImpactRule rule>
auto derivative_along(const DryMap<double, shape, rule>& map, Parameter parameter,
                      const PostImpactState<double>& post_impact, const Collision<double>& known) {
    constexpr int dimension = section_dimension<shape>;
    using Jet = ceres::Jet<double, 1>;
    Scene<Jet> along = scene_in<Jet>(map.scene());
    number_of(along, parameter).v[0] = 1;
    const DryMap<Jet, shape, rule> jets(along, nullptr, map.pressure());
    const auto collision = detail::strike_along_course(map, jets, post_impact, state_in_jets<Jet>(post_impact),
                                                       known.flight_time, known.vertex_step);
    const auto next = coordinates<shape>(section_point(collision.after));
    Eigen::Matrix<double, dimension, 1> result;
    for (int i = 0; i < dimension; ++i) result[i] = next[static_cast<std::size_t>(i)].v[0];
    return result;
}

}  // namespace swirl
