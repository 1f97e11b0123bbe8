// The cycles of a scene, period by period: all fixed points of impacts alone from their equations, the others from
// candidates.
#pragma once

#include "analysis/curves/shooting_map.hpp"
#include "apps/studies/cycles/candidates.hpp"
#include "apps/studies/cycles/found_orbits.hpp"
#include "apps/studies/parallel/run_control.hpp"

namespace swirl::studies::cycles {

inline constexpr double accepted = 1e-11;  ///< residual of a cycle; those found end near 10⁻¹⁵

struct FindOptions {
    CandidateOptions candidates;
    int first_period = 1, last_period = 1;
    double max_time = 12;  ///< flight time of fixed points, in 1/ω_s
    /// Search on, twice as long each time, until the estimate of what was missed is none and twice as many candidates
    /// have brought nothing new, …
    bool complete = false;
    std::int64_t most_starts = 200'000;  ///< … or that many random section points of a period were tried
    RunControl control = {};
};

/// Cycles of each period, each once. Period 1: `find_steady_cycles`, and by search those that lead through contact.
/// Cost: some milliseconds a candidate and period.
FoundOrbits find_orbits(const Scene<double>& scene, const analysis::ShootingMap& map, const FindOptions& options);

}  // namespace swirl::studies::cycles
