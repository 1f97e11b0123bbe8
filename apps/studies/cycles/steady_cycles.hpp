// The fixed points of impacts alone as cycles, from the two equations of a steady mode (map/steady).
#pragma once

#include "analysis/cycles/find_cycles.hpp"
#include "apps/studies/cycles/find_orbits.hpp"
#include "apps/studies/scene_map/accuracy.hpp"

#include <functional>
#include <vector>

namespace swirl::studies::cycles {

/// Every fixed point of F by impacts alone with τ ≤ max_time; of a family over τ the member midway.
///   map       in that accuracy: where it is not double, it has to have the fixed point, too
///   stop      true: end with what there is
/// Cost: steady_modes', and some 30 ms a point for its multipliers in 100 digits.
/// @throws std::invalid_argument for a max_time out of range
SteadySearch find_steady_cycles(const Scene<double>& scene, const analysis::ShootingMap& map, double max_time,
                                const std::function<bool()>& stop, int threads, Accuracy accuracy,
                                std::vector<analysis::Cycle>& cycles);

/// The family that a fixed point belongs to, if it is one of these.
const SteadyFamily* family_of(const Scene<double>& scene, const std::vector<SteadyFamily>& families,
                              const analysis::Cycle& cycle);

}  // namespace swirl::studies::cycles
