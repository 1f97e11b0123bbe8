// One-dimensional sets of cycles as curves: a branch over the parameter, or a family at one parameter.
#pragma once

#include "analysis/curves/curve.hpp"
#include "analysis/cycles/cycle.hpp"

#include <cstddef>
#include <functional>
#include <vector>

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

// Families: cycles that are not isolated (the disk's steady modes at e = 1, all cycles of a conservative map).

struct FamilyOptions {
    double step = 0.01;      ///< longest step along the family
    double shortest = 1e-6;  ///< the walk ends where it must take shorter ones
    int most_steps = 3000;   ///< in each direction
};

/// A one-parameter family, from one end to the other through the member it was found by.
struct FamilyCurve {
    std::vector<CurvePoint> members;
    bool closed = false;  ///< the walk came back to its beginning
    double p = 0;         ///< the map's parameter
};

/// Walks along the family through a cycle with one tangent, both ways, until it ends at a border of the map or closes.
FamilyCurve walk_family(const ShootingMap& map, double p, const Cycle& cycle, const FamilyOptions& options = {});

/// The members at which `value` is `goal`, each refined to rounding: pins a family by S, or by its return time.
std::vector<CyclePoints> pinned_members(const ShootingMap& map, const FamilyCurve& family,
                                        const std::function<double(const CurvePoint&)>& value, double goal);

/// True if b lies on the family's curve.
bool belongs_to(const ShootingMap& map, const FamilyCurve& curve, const CyclePoints& b);

/// True if b can be reached from a by small steps from cycle to cycle: for families of two and more parameters.
bool is_reachable(const ShootingMap& map, double p, const CyclePoints& a, const CyclePoints& b);

}  // namespace swirl::analysis
