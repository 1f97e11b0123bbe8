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

/// The fixed points over a floor that drags that `dragged_modes` lists up to max_time, but for those of `found`. Cost:
/// dragged_modes', and some 30 ms a point.
/// @throws std::invalid_argument for a max_time out of range, or a scene without drag
std::vector<analysis::Cycle> dragged_cycles(const Scene<double>& scene, const analysis::ShootingMap& map,
                                            double max_time, const RunControl& control,
                                            const std::vector<analysis::Cycle>& found);

/// The family that a fixed point belongs to, if it is one of these.
const SteadyFamily* family_of(const Scene<double>& scene, const std::vector<SteadyFamily>& families,
                              const analysis::Cycle& cycle);

}  // namespace swirl::studies::cycles
