// The attracting steady modes of a scene, and which share of its starts came to each: 0 of one that none found.
#pragma once

#include "apps/studies/modes/attractors.hpp"
#include "map/model/scene.hpp"
#include "map/steady/steady_modes.hpp"

#include <span>
#include <vector>

namespace swirl::studies {

struct SteadyShare {
    double spin = 0;         ///< S
    double flight_time = 0;  ///< τ, in 1/ω_s
    double multiplier = 0;   ///< the largest |multiplier|, < 1
    double share = 0;        ///< of the runs; 0: none came to it
};

/// What a run says of where it came to.
struct SettledRun {
    analysis::Kind kind;
    double mean_spin;
};

/// Those with a flight time up to `longest_attracting_flight`, by branch and rising flight time (map/steady/README.md).
/// A run is of the mode whose S its mean is (`same_mean`); where two have one S (1, the swirl's), of the first. None of
/// a disk or without friction: their steady modes are families, which have no share each. Cost: half a millisecond;
/// with thousands of sides and little friction up to 1.1 s.
std::vector<SteadyShare> steady_shares(const Scene<double>& scene, std::span<const SettledRun> runs);

}  // namespace swirl::studies
