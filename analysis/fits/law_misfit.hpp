// How far a measured impact is from a law, errors before and after the impact counted alike.
#pragma once

#include "analysis/fits/measured_impact.hpp"

#include <Eigen/Core>

#include <optional>

namespace swirl::analysis {

/// The distance of (v⁻, v⁺) from the surface v⁺ = law(v⁻) in units of the standard errors: the least of
/// |(v⁻ − w)/σ⁻|² + |(v⁺ − law(w))/σ⁺|² over w.
struct LawMisfit {
    Eigen::Vector3d residual;            ///< of this squared length; independent components of unit variance
    Eigen::Matrix<double, 3, 2> slopes;  ///< by e and μ, to the order that gives the distance's gradient exactly
    Eigen::Vector3d before;              ///< w, the most likely velocity before the impact
    double squared() const { return residual.squaredNorm(); }
};

/// Of an impact with fixed weights the residual is those times v⁺ − law(v⁻), w = v⁻, and the slopes are its own. Else
/// Gauss–Newton in w from v⁻, halved while it does not shorten the distance (the law has kinks where the contact mode
/// changes), at most `misfit_steps` of them. With J = ∂law/∂w the residual is C^(−1/2) (v⁺ − law(w) − J (v⁻ − w)),
/// C = diag(σ⁺²) + J diag(σ⁻²) Jᵀ, and at the nearest w its derivative by the parameters −C^(−1/2) ∂law/∂(e, μ).
LawMisfit misfit_of(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                    const LawParameters& parameters);
inline constexpr int misfit_steps = 4;

/// The impact with the weights that its errors have at these parameters; without any, as if the law passed errors on as
/// they are. Total least squares fits the shape of the cloud of impacts that are all alike to the stated errors: where
/// these are correlated in a way that is not stated, wrongly, and the more surely the more impacts there are. With
/// fixed weights only the cloud's middle counts; errors before the impact then bias e and μ by terms of their squares.
MeasuredImpact with_fixed_weights(const MeasuredImpact& impact, double inertia, const ImpactLaw& law,
                                  const std::optional<LawParameters>& parameters);

/// The law's v⁺ of a measured v⁻, beside the v⁺ that was measured.
struct Prediction {
    Eigen::Vector3d after;
    double squared;  ///< of v⁺ − after, in units of its covariance: χ² with 3 degrees of freedom where the law holds
};
Prediction predict(const MeasuredImpact& impact, double inertia, const ImpactLaw& law, const LawParameters& parameters);

}  // namespace swirl::analysis
