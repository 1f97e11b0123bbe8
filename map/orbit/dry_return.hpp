// The return map over a floor with dry friction: ReturnMap, with flights of its own; contact is not followed.
#pragma once

#include "map/dry/dry_map.hpp"
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

/// Of no use: contact, from which a body is released, is not followed.
template <Shape shape, ImpactRule rule>
std::optional<Collision<double>> collision_after_release(const DryMap<double, shape, rule>&, const Flight<double>&) {
    return {};
}

}  // namespace swirl
