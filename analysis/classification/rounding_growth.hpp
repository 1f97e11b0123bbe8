// How far rounding is carried along a cycle that forgets its past.
#pragma once

#include "analysis/classification/tail.hpp"

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
double rounding_growth(const M& map, Vector<M::dimension> z, std::int64_t k) {
    constexpr double apart = 1e-14;
    Vector<M::dimension> neighbour = z;
    double farthest = 0;
    for (std::int64_t i = 0; i < k; ++i) {
        if (distance(map, neighbour, z) < apart)
            for (int c = 0; c < M::dimension; ++c) neighbour[c] = z[c] + apart * std::cos(1.0 + c);
        const auto step = map.advance(z), beside = map.advance(neighbour);
        if (!step.alive || !beside.alive) return std::numeric_limits<double>::infinity();
        z = step.state;
        neighbour = beside.state;
        farthest = std::max(farthest, distance(map, neighbour, z));
    }
    return std::numeric_limits<double>::epsilon() / apart * farthest;
}

}  // namespace swirl::analysis
