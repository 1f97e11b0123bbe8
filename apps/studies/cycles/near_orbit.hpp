// A cycle by Newton's method from points near it, and the cycle nearest to a point.
#pragma once

#include "analysis/curves/shooting_map.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/cycles/find_orbits.hpp"
#include "map/model/scene.hpp"
#include "map/model/section.hpp"

#include <cstddef>
#include <functional>
#include <vector>

namespace swirl::studies::cycles {

// A cycle of a scene by its points.

/// Where a cycle is said to be, in its own scene.
struct CyclePlace {
    Scene<double> scene;
    std::vector<SectionPoint<double>> points;
    std::size_t number = 1;  ///< of the record's row, from 1
};

/// The cycle of that minimal period to which multi-shooting leads from the points of a place, or from the states that
/// follow its first point where there are fewer; empty if it leads to none.
///   map  of the place's scene, along a parameter with the value p
analysis::CyclePoints cycle_from(const CyclePlace& place, int period, const analysis::ShootingMap& map, double p);

// The cycle nearest to a point.

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
