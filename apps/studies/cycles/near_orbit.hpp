// The cycle nearest to a point.
#pragma once

#include "analysis/curves/shooting_map.hpp"
#include "apps/studies/cycles/found_orbits.hpp"
#include "map/model/section.hpp"

#include <functional>

namespace swirl::studies::cycles {

/// Cycles of the periods first … last near z, one a period: the nearest of those that multi-shooting leads to, by the
/// map and with the impacts' times as unknowns,
/// - from z and the states that follow it, and
/// - from points of a cloud about z whose k-th image comes back best. The states that follow z itself are |multiplier|
///   times farther from the cycle than z is; of some thousand points about it some lie near the manifold of points that
///   stay near the cycle. Clouds grow from 3·10⁻⁶ to 3·10⁻², until one holds a cycle.
/// Cost: up to 5 × 400,000 steps of the map and some 60 solutions.
///   map   in that accuracy
///   stop  true: end with what there is
FoundOrbits find_near(const Scene<double>& scene, const analysis::ShootingMap& map, Accuracy accuracy,
                      const SectionPoint<double>& z, int first_period, int last_period,
                      const std::function<bool()>& stop);

}  // namespace swirl::studies::cycles
