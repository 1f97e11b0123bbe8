// What a return step costs, by count.
#pragma once

#include "map/orbit/return_map.hpp"

namespace swirl::studies {

/// What a power series in contact costs, with the search for what ends it.
inline constexpr double cost_per_series = 16;
/// What a step of the integration of contact over a dry floor costs, in flights over that floor, which are integrated,
/// too.
inline constexpr double cost_per_dry_step = 0.25;

/// The cost of a return step in ordinary ones of its map (0.3 … 1 µs; over a dry floor some 100), from counts, so that
/// it is the same on every machine.
inline double cost_of(const ReturnStep<double>& step, double per_contact_step = cost_per_series) {
    constexpr int ordinary_looks = 32;  // moments at which a flight is evaluated: with more it is dearer
    constexpr double per_look = 0.5;    // among all vertices: two arc tangents, two sincos
    const double flight = step.collision.steps > ordinary_looks ? per_look * step.collision.steps : 1;
    return flight + per_contact_step * static_cast<double>(contact_steps(step));
}

}  // namespace swirl::studies
