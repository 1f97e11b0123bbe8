// Minimally augmented systems: a fold, flip or Neimark–Sacker curve of cycles as the zeros of equations that are
// regular on it.
#pragma once

#include "analysis/boundaries/boundary.hpp"
#include "analysis/boundaries/critical_value.hpp"

namespace swirl::analysis {

/// Unknowns y = (Z, p), equations G(Z; p) = 0 and
///   fold            g(1) = 0
///   flip            g(−1) = 0
///   Neimark–Sacker  with one more unknown c = cos θ, E = O = 0 where for λ = e^{iθ}
///                   E = (g(λ) + g(1/λ))/2,  O = (g(λ) − g(1/λ))/(λ − 1/λ)
/// With real borders g(λ̄) is the conjugate of g(λ), so that E = Re g and O = Im g/sin θ are smooth functions of c, also
/// where |c| > 1 (neutral saddles λ, 1/λ): the curve passes 1:1 and 1:2 as any other point.
struct AugmentedSystem {
    BoundaryKind kind = BoundaryKind::fold;
    PlaneMap map;
    std::size_t period = 1;
    Eigen::Vector2d unit{1, 1};  ///< of the parameters, in the arclength: the plane's widths
    CriticalBorders borders;

    Eigen::Index coordinates() const { return map.dimension * static_cast<Eigen::Index>(period); }
    /// The multiplier that y has.
    std::complex<double> multiplier(const Eigen::VectorXd& y) const;
    PlaneShooting shooting(const Eigen::VectorXd& y) const;
};

/// The equations for `correct`; they hold a copy of the system.
/// Cost of one evaluation: k steps of the map and 2k (fold, flip) or 4k beside them, LUs of kD + 1 complex unknowns: 2,
/// or 6 for Neimark–Sacker.
ArcSystem equations_of(const AugmentedSystem& system);

/// The borders taken anew at a point of the curve, so that the matrix stays well conditioned along it.
void renew_borders(AugmentedSystem& system, const Eigen::VectorXd& y);

/// The system at a cycle that has a multiplier near `multiplier`, and y there. False if the map ends.
bool augmented_system_at(const PlaneMap& map, BoundaryKind kind, const CyclePoints& points, const Eigen::Vector2d& p,
                         std::complex<double> multiplier, const Eigen::Vector2d& unit, AugmentedSystem& system,
                         Eigen::VectorXd& y);

}  // namespace swirl::analysis
