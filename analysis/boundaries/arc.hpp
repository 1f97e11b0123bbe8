// Curves H(y) = 0 of one equation fewer than unknowns, whatever the equations are: predictor and corrector.
#pragma once

#include "analysis/cycles/curve.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace swirl::analysis {

/// H and ∂H/∂y at one y.
struct ArcEquations {
    Eigen::VectorXd residual;        ///< H, of length n − 1
    Eigen::MatrixXd jacobian;        ///< (n − 1) × n
    std::vector<std::int64_t> word;  ///< the smooth branch of the map that was taken
};

/// A curve in n unknowns.
struct ArcSystem {
    Eigen::VectorXd weights;  ///< of the arclength, s² = Σ w_i δy_i²; n of them
    /// False where the map ends. The Jacobian steers Newton's method and gives the tangent; H alone says where the
    /// curve is.
    std::function<bool(const Eigen::VectorXd& y, ArcEquations& at)> equations;

    double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return a.cwiseProduct(weights).dot(b); }
};

struct ArcPoint {
    Eigen::VectorXd y;
    Eigen::VectorXd tangent;  ///< of unit length in the system's product
    ArcEquations at;
};

/// Between tangents a step apart: a bend of 14 degrees.
inline constexpr double least_cosine_along = 0.97;

/// How far p is outside the plane low … high, in its widths; negative inside, infinite where p is no number.
double outside_plane(const Eigen::Vector2d& low, const Eigen::Vector2d& high, const Eigen::Vector2d& p);

/// A point of the curve near a guess, by Newton's method with steps of minimum norm, and the tangent there.
///   along  the tangent has a positive product with it
///   farthest  in arclength, that the point may lie from the guess
/// False if none is found. Cost: some 3 to 6 times the equations.
bool begin_arc(const ArcSystem& system, const Eigen::VectorXd& guess, const Eigen::VectorXd& along, double farthest,
               ArcPoint& point);

/// The point of the curve on the plane across the base's tangent at distance h (pseudo-arclength, Keller 1977). It
/// converges when a step of Newton's method is rounding.
///   keep_word  another word is an outcome of its own
Correction correct(const ArcSystem& system, const ArcPoint& base, double h, ArcPoint& point, bool keep_word = true);

/// Does the curve pass `target`, one of its points, in the same direction between the base (which is not passed) and
/// its step h? Corrected at target's place along the tangent, it is target (to 10⁻⁷).
bool passes(const ArcSystem& system, const ArcPoint& base, double h, const ArcPoint& target, bool keep_word = true);

/// Where between the base (value f0) and its step h (value f1) `value` is zero, by TOMS 748 to rounding; every trial is
/// a corrected point. False if the corrector failed on the way, or if |value| does not fall there as at a zero (a
/// pole).
bool locate(const ArcSystem& system, const ArcPoint& base, double h, double f0, double f1,
            const std::function<double(const ArcPoint&)>& value, ArcPoint& found, bool keep_word = true);

}  // namespace swirl::analysis
