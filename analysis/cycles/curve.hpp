// One-dimensional sets of cycles as curves: a branch over the parameter, or a family at one parameter.
#pragma once

#include "analysis/curves/curve.hpp"

namespace swirl::analysis {

/// G(Z; p) = 0 of k points: y = (Z, p) of a branch, where the map has a parameter, or Z of a family at p. The arclength
/// is s² = |δZ|²/k + δp². The corrector has converged at a residual of 10⁻¹⁴, or where it stops to fall at 10⁻¹² or
/// what rounding leaves. The map must outlive it.
CurveProblem cycle_problem(const ShootingMap& map, std::size_t k, double p);

/// Makes a curve point of a cycle: polishes nothing, works out the derivative and the tangent. False if the map ends.
///   previous  the tangent points along it (empty: along growing p, or the largest coordinate of a family)
bool begin_curve(const ShootingMap& map, const CyclePoints& points, double p, const Eigen::VectorXd& previous,
                 CurvePoint& point);

/// True if solutions near the point are a curve: the Jacobian has one null vector, to 10⁻⁸ when scaled. False where
/// branches cross, and on solution sets of two and more dimensions. Cost: one QR.
bool is_on_curve(const ShootingResidual& shooting);

/// From a cycle of the curve to another cycle with parameter p, angles as angles.
Eigen::VectorXd across(const ShootingMap& map, const CurvePoint& from, const CyclePoints& to, double p);

}  // namespace swirl::analysis
