// Curves H(y) = 0 of one equation fewer than unknowns, whatever the equations are: predictor and corrector.
#pragma once

#include "analysis/curves/newton.hpp"

#include <cstdint>
#include <functional>

namespace swirl::analysis {

/// How the zero of a function along a step is found, by TOMS 748 (Alefeld, Potra, Shi 1995).
struct LocateRule {
    int bits = 50;  ///< of the arclength
    std::uintmax_t most_trials = 60;
    bool has_poles = false;    ///< where |value| does not fall to 10⁻³ of that at the step's ends there is no zero
    bool takes_middle = true;  ///< of the last bracket; false: its lower end
};

/// A curve in n unknowns.
struct CurveProblem {
    Eigen::VectorXd weights;  ///< of the arclength, s² = Σ w_i δy_i²; n of them
    Equations equations;      ///< n − 1 of them, or n that are solved along a curve all the same (a family's)
    /// `equations` by steps from surfaces beside which a guess may lie (ShootingMap::step_from_surface): tried where
    /// the corrector fails. What they converge to must solve `equations`. Empty: there are none.
    Equations equations_from_surface = {};
    NewtonRule newton = {};
    LocateRule locate = {};
    bool keeps_itinerary = true;  ///< a solution with another itinerary lies on another smooth curve

    double product(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const { return a.cwiseProduct(weights).dot(b); }
    double length(const Eigen::VectorXd& y) const;
};

/// Of equations whose rounding is not known: the corrector has converged when a step of Newton's method is rounding,
/// 10⁻¹⁴ of well-conditioned unknowns, and 10⁻⁹ where large multipliers leave no less.
CurveProblem augmented_problem(Eigen::VectorXd weights, Equations equations);

struct CurvePoint {
    Eigen::VectorXd y;
    Eigen::VectorXd tangent;    ///< of unit length in the problem's product
    ShootingResidual shooting;  ///< the equations at y

    /// Of a curve of cycles of one map, y = (Z, p, …): the cycle, and p (0 without a parameter).
    CyclePoints points() const;
    bool has_parameter() const { return y.size() > shooting.coordinates(); }
    double p() const { return has_parameter() ? y[shooting.coordinates()] : 0; }
    double parameter_slope() const { return tangent[tangent.size() - 1]; }  ///< dp/ds of a branch
};

/// ∂H/∂y with one more row: the tangent in the problem's product.
Eigen::MatrixXd bordered(const CurveProblem& problem, const ShootingResidual& at, const Eigen::VectorXd& tangent);

/// The tangent at the point, ∂H/∂y · t = 0, with ⟨along, t⟩ > 0; false unless it is well defined.
bool find_tangent(const CurveProblem& problem, const Eigen::VectorXd& along, CurvePoint& point);

/// A point of the curve near a guess, by Newton's method with steps of least arclength, and the tangent there.
///   along  the tangent has a positive product with it
///   farthest  in arclength, that the point may lie from the guess
/// False if none is found. Cost: some 3 to 6 times the equations.
bool find_point(const CurveProblem& problem, const Eigen::VectorXd& guess, const Eigen::VectorXd& along,
                double farthest, CurvePoint& point);

/// The point of the curve on the plane across the base's tangent at distance h (pseudo-arclength, Keller 1977): the
/// predictor is y + h t, the corrector Newton's method within the plane.
///   farthest  that the corrector may lead from the predictor, in units of |h|: farther lies another curve
/// Cost: 3 to 5 times the equations and as many QRs of n unknowns.
Correction correct(const CurveProblem& problem, const CurvePoint& base, double h, CurvePoint& point,
                   double farthest = 0.5);

/// Does the curve pass `target`, one of its points, in the same direction between the base (which is not passed) and
/// its step h? Corrected at target's place along the tangent, it is target (to 10⁻⁷).
bool passes(const CurveProblem& problem, const CurvePoint& base, double h, const CurvePoint& target);

/// Where between the base (value f0) and its step h (value f1) `value` is zero; every trial is a corrected point. False
/// if the signs are equal, if the corrector failed on the way, or at a pole.
bool locate(const CurveProblem& problem, const CurvePoint& base, double h, double f0, double f1,
            const std::function<double(const CurvePoint&)>& value, CurvePoint& found);

}  // namespace swirl::analysis
