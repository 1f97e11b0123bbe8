// A cycle carried from one scene to another by Newton's method (natural continuation).
#pragma once

#include "analysis/section_map.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

namespace swirl::studies::grids {

/// A cycle in the scene to which it was carried.
struct CarriedCycle {
    analysis::CyclePoints points;  ///< none: it was not carried, or not back to where it came from
    double mean_spin = 0;          ///< time mean of S
    double mean_spin_per_impact = 0;
    bool stable = false;  ///< all multipliers inside the unit circle
};

/// Carries the k points of a cycle to another scene with the same N and law, its minimal period kept, in 2ⁿ equal steps
/// of α, β, μ, e and κ: the smallest n of 1 … 4 with which Newton's method converges at each and leads back, in the
/// same steps, to the points themselves (10⁻⁶): one that has jumped to another cycle on the way seldom does.
/// None once stopped.
/// Cost: 2ⁿ⁺¹ solutions of k points.
CarriedCycle carried(const Scene<double>& from, const Scene<double>& to, Accuracy accuracy,
                     const analysis::CyclePoints& points, const analysis::Stop& stop = {});

}  // namespace swirl::studies::grids
