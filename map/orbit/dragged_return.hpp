// The return map over a floor that drags: ReturnMap, with flights and releases of its own.
#pragma once

#include "map/dragged/dragged_map.hpp"
#include "map/dragged/dragged_release.hpp"
#include "map/orbit/return_map.hpp"

#include <optional>

namespace swirl {

template <class T, Shape shape, ImpactRule rule, class Start>
T turned_in_flight(const DraggedMap<T, shape, rule>& map, const Start& start, const T& time) {
    return map.turned(start.spin, time);
}

template <class T, Shape shape, ImpactRule rule>
Outcome ending_without_contact(const DraggedMap<T, shape, rule>& map) {
    return map.floor().drag > T(0) && map.scene().floor == Floor::dish ? Outcome::riding : Outcome::no_contact;
}

template <class T, Shape shape, ImpactRule rule>
std::optional<Collision<T>> collision_after_release(const DraggedMap<T, shape, rule>& map, const Flight<T>& start) {
    const DraggedFlight<T> flight = dragged_flight(map.floor(), start);
    const auto contact = contact_after_release<shape>(map.body(), flight);
    if (!contact) return {};
    Collision<T> collision;
    const FirstContact<T>& found = contact->found;
    if (found.outcome == FirstContactOutcome::contact)
        map.strike(flight, contact->moment, found.arm, found.vertex, collision);
    collision.outcome = found.outcome;
    collision.steps = found.steps;
    collision.vertex_step = found.vertex;
    collision.simultaneous = found.simultaneous;
    return collision;
}

}  // namespace swirl
