// Orbits of many scenes that advance together, one in each lane of a vector (map/batch/README.md).
#pragma once

#include "map/collision_map.hpp"
#include "map/derivative/linearised_collision.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies {

/// Where the steps of an orbit are kept: the state before each, its duration, ∫ S dt and letter.
struct KeptSteps {
    std::vector<PostImpactState<double>>& states;
    std::vector<double>&durations, &integrals;
    std::vector<std::int64_t>& letters;
};

template <int D>
class SceneDynamics;

/// Steps that an orbit is to take.
template <int D>
struct LaneOrbit {
    const SceneDynamics<D>* dynamics = nullptr;  ///< in double
    PostImpactState<double> z{};                 ///< where they begin, and end if they are taken
    std::int64_t count = 0;
    KeptSteps* kept = nullptr;        ///< none: they are not
    bool taken = false;               ///< all of them; else nothing is changed
    double most_excess = 0;           ///< what they may cost beyond as many ordinary ones; negative: not even that
    double excess = 0;                ///< what they do
    bool derivative_is_zero = false;  ///< one of them led through a rest (`has_rested`)
};

/// Are there lanes in this build?
bool has_lanes();

/// What so many steps may cost beyond ordinary ones: dearer ones the orbit takes alone, which does not follow again
/// what repeats itself to the bit.
inline double most_excess(std::int64_t count) {
    return std::max(5e4, 4 * static_cast<double>(count));
}

/// So few take longer together than one after the other.
inline constexpr std::size_t fewest_together = 5;

/// Lets orbits of one shape and impact rule take their steps together, bit for bit as `ReturnMap::advance` takes them
/// alone. Not taken: steps that cost much more than ordinary ones, as through long contact (`most_excess`), or end
/// the orbit; where there are no lanes (sanitizers), none.
template <Shape shape, ImpactRule rule>
void follow_together(std::span<LaneOrbit<section_dimension<shape>>> orbits);

// For SWIRL_EVERY_MAP in with_lanes.cpp and without_lanes.cpp.
#define SWIRL_COMPILE_LANES(T, SHAPE, RULE) \
    template void follow_together<SHAPE, RULE>(std::span<LaneOrbit<section_dimension<SHAPE>>>);

}  // namespace swirl::studies
