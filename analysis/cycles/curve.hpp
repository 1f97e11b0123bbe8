// One-dimensional sets of cycles: a branch over the parameter, or a family at one parameter. Predictor and corrector.
#pragma once

#include "analysis/cycles/shooting_residual.hpp"

namespace swirl::analysis {

/// A point of a curve of cycles. Lengths on the curve are measured by s² = |δZ|²/k + δp² (δp = 0 along a family).
struct CurvePoint {
    CyclePoints points;
    double p = 0;
    ShootingResidual shooting;  ///< at the point
    Eigen::VectorXd tangent;    ///< unit: (Z, p), or Z alone for a map without a parameter

    double parameter_slope() const { return tangent[tangent.size() - 1]; }  ///< dp/ds of a branch
};

enum class Correction {
    converged,
    word_changed,  ///< converged on another smooth branch of the map
    map_ended,     ///< the map ends on the way
    failed,        ///< no cycle found there, or one so far from where the tangent led that it lies on another curve
};

struct CorrectorOptions {
    double accept = 1e-12;  ///< residual that counts as converged
    double goal = 1e-14;    ///< residual at which the iteration stops
    int most_iterations = 10;
    bool keep_word = true;  ///< a changed word is a failure to stay on the curve
    double farthest = 0.5;  ///< of the cycle from where the tangent led, in units of |h|
};

/// Makes a curve point of a cycle: polishes nothing, works out the derivative and the tangent. False if the map ends.
///   previous  the tangent points along it (empty: along growing p, or the largest coordinate of a family)
bool begin_curve(const ShootingMap& map, const CyclePoints& points, double p, const Eigen::VectorXd& previous,
                 CurvePoint& point);

/// True if solutions near the point are a curve: the Jacobian has one null vector, to 10⁻⁸ when scaled. False where
/// branches cross, and on solution sets of two and more dimensions. Cost: one QR.
bool is_on_curve(const ShootingMap& map, const ShootingResidual& shooting);

/// The point of the curve on the plane across the base's tangent at distance h: pseudo-arclength (Keller 1977).
/// Where that fails, once more by guesses on the map's surfaces, if it has any (ShootingMap::step_from_surface).
/// Cost: 3 to 5 iterations of k steps of the map and one QR of kD + 1 unknowns.
Correction correct(const ShootingMap& map, const CurvePoint& base, double h, CurvePoint& point,
                   const CorrectorOptions& options = {});

/// ⟨a, b⟩ of the curve's length for k points.
double curve_product(const Eigen::VectorXd& a, const Eigen::VectorXd& b, bool has_parameter, std::size_t k);

/// ∂G/∂(Z, p) with one more row: the tangent in the curve's product. Square for a branch.
Eigen::MatrixXd bordered(const ShootingMap& map, const ShootingResidual& shooting, const Eigen::VectorXd& tangent);

}  // namespace swirl::analysis
