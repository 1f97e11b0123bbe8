// What a return step costs, by count.
#pragma once

#include "map/orbit/return_map.hpp"

namespace swirl::apps {

/// What a power series in contact costs, with the search for what ends it.
inline constexpr double effort_per_series = 8;

/// The cost of a return step in ordinary ones, which look at some eight moments of a flight (0.3 … 1 µs). A power
/// series in contact, costs as much as eight of them: a step through contact some 200, one with a long swing in a weak
/// swirl 100,000. Counts, so that it is the same on every machine.
inline double effort_of(const ReturnStep<double>& step) {
    constexpr double per_look = 1.0 / 8;
    double effort = 1;
    if (step.collision.steps > 8) effort = per_look * step.collision.steps;
    return effort + effort_per_series * static_cast<double>(contact_steps(step));
}

}  // namespace swirl::apps
