// The return map over a floor with dry friction: ReturnMap, with flights of its own, and with a disk's contact.
#pragma once

#include "map/dry/dry_map.hpp"
#include "map/dry/rim_contact.hpp"
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
    if constexpr (shape == Shape::disk)
        return map.advance_after_release(flight);
    else
        return {};  // a polygon's contact, from which it would be released, is not followed
}

/// From just after an impact at which chatter has come to its end.
template <ImpactRule rule>
ContactPhase<double> follow_dry_contact(const DryMap<double, Shape::disk, rule>& map,
                                        const PostImpactState<double>& post_impact, double horizon,
                                        const ContactSink& sink) {
    return follow_rim(map.rim(), post_impact, horizon, sink);
}

}  // namespace swirl
