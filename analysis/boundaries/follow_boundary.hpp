// A boundary followed to both its ends, with its points of codimension 2.
#pragma once

#include "analysis/boundaries/augmented_system.hpp"

#include <complex>
#include <optional>
#include <span>

namespace swirl::analysis {

/// Follows the fold, flip or Neimark–Sacker curve near a cycle until it leaves the plane, closes, ends at 1:1 or 1:2
/// (Neimark–Sacker), or meets a border of the map. Steps are those of curves/walk.hpp.
/// Points of codimension 2 are zeros of the functions of codimension_two.hpp, bracketed by a step and found by TOMS
/// 748; what |multipliers| leave of A limits them to 10⁻¹⁶ |A|.
///   points      a cycle with a multiplier near `multiplier`: one found on a branch, or roughly
/// False if no such cycle is found near it within the plane.
/// Cost: 4 to 6 evaluations of the equations a point.
bool follow_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                     std::complex<double> multiplier, const BoundaryOptions& options, Boundary& boundary);

/// A cycle on such a curve, and its critical multiplier.
struct CriticalCycle {
    CyclePoints points;
    Eigen::Vector2d p{0, 0};
    std::complex<double> multiplier;
};

/// The one near a rough cycle, by Newton's method with steps of least length. Empty if none is near it within the
/// plane.
std::optional<CriticalCycle> critical_cycle_near(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points,
                                                 const Eigen::Vector2d& p, std::complex<double> multiplier,
                                                 const BoundaryOptions& options);

/// Is the cycle, cyclic shifts included, on one of the curves? To 10⁻⁶ in points and parameters.
bool is_on_boundary(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                    std::complex<double> multiplier, const BoundaryOptions& options, std::span<const Boundary> known);

}  // namespace swirl::analysis
