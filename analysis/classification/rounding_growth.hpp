// How far rounding is carried along an attracting cycle.
#pragma once

#include "analysis/classification/tail.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace swirl::analysis {

/// What an error of ε becomes along the k steps from z: ε/d times the largest distance of a neighbour that begins d
/// away, and does so again wherever it has come back to within d. A cycle may return to the bit, as landings undo
/// whatever was before, and yet lead through chaos in between: where it closes is then an accident of rounding.
/// Neighbours and no derivatives, as beyond a border of the map these say nothing. Infinite if the neighbour's map
/// ends. Cost: 2 k steps.
template <SectionMap M>
double rounding_growth(const M& map, State<M> z, std::int64_t k) {
    constexpr double apart = 1e-14;
    Vector<M::dimension> aside;
    for (int c = 0; c < M::dimension; ++c) aside[c] = apart * std::cos(1.0 + c);
    State<M> neighbour = z;
    Vector<M::dimension> point = coordinates(map, z);
    double away = 0, farthest = 0;
    for (std::int64_t i = 0; i < k; ++i) {
        if (away < apart) neighbour = state_at(map, Vector<M::dimension>(point + aside));
        const auto step = map.advance(z), beside = map.advance(neighbour);
        if (!step.alive || !beside.alive) return infinity;
        z = step.state;
        neighbour = beside.state;
        point = coordinates(map, z);
        away = distance(map, coordinates(map, neighbour), point);
        farthest = std::max(farthest, away);
    }
    return std::numeric_limits<double>::epsilon() / apart * farthest;
}

}  // namespace swirl::analysis
