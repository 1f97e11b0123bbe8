// The return map over a floor with dry friction: ReturnMap, with flights and contact of its own.
#pragma once

#include "map/dry/dry_map.hpp"
#include "map/dry/wall_contact.hpp"
#include "map/orbit/return_map.hpp"

#include <optional>

namespace swirl {

template <Shape shape, ImpactRule rule>
double turned_in_flight(const DryMap<double, shape, rule>& map, const Flight<double>& start, const double& time) {
    return map.turned(start, time);
}
template <Shape shape, ImpactRule rule>
double turned_in_flight(const DryMap<double, shape, rule>& map, const PostImpactState<double>& start,
                        const double& time) {
    return map.turned(flight_from(map.body(), start), time);
}

template <Shape shape, ImpactRule rule>
Outcome ending_without_contact(const DryMap<double, shape, rule>& map) {
    return map.scene().floor == Floor::dish && map.scene().has_dry_floor() ? Outcome::riding : Outcome::no_contact;
}

template <Shape shape, ImpactRule rule>
std::optional<Collision<double>> collision_after_release(const DryMap<double, shape, rule>& map,
                                                         const Flight<double>& flight) {
    return map.advance_after_release(flight);
}

/// By the largest push of the floor and its largest torque.
template <Shape shape, ImpactRule rule>
bool may_come_to_contact(const DryMap<double, shape, rule>& map, const ContactScene<double>& contact,
                         const PostImpactState<double>& post_impact) {
    const Body<double>& body = map.body();
    const double most = map.scene().floor_deceleration();
    ContactScene<double> pushed = contact;
    pushed.floor.drags = true;
    pushed.floor.push = {most, 0};
    pushed.floor.turning = most * map.pressure()->distance() * body.alpha * body.inverse_inertia;
    return may_chatter(pushed, post_impact);
}

template <Shape shape, ImpactRule rule>
ChatterCompletion<double> completion_after(const DryMap<double, shape, rule>& map, const ContactScene<double>&,
                                           const PostImpactState<double>& post_impact) {
    return dry_completion(map.wall(), post_impact);
}

template <Shape shape, ImpactRule rule>
ContactPhase<double> phase_from(const DryMap<double, shape, rule>& map, const ContactScene<double>&,
                                const ChatterCompletion<double>& completion, double horizon,
                                const ContactSink& sink = {}, long most_steps = most_contact_steps) {
    return follow_dry_contact(map.wall(), completion, horizon, sink, most_steps);
}

}  // namespace swirl
