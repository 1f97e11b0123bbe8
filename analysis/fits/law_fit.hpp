// e and μ of a law from many impacts: how far each is from it, the fit, and rivals that explain them nearly as well.
#pragma once

#include "analysis/fits/measured_impact.hpp"
#include "analysis/special_values.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

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

// e and μ of one law from many impacts.

/// Largest μ that is looked at: friction beyond it holds every contact, whatever its offset.
inline constexpr double largest_friction = 50;

struct LawFit {
    LawParameters parameters;
    double loss = nan;  ///< half the summed biweight loss of the misfits, in units of their scale
};

/// What a fit is made of. Weights count impacts; 0 leaves one out.
struct LawProblem {
    std::span<const MeasuredImpact> impacts;
    std::span<const double> weights;
    double inertia = nan;
    const ImpactLaw* law = nullptr;
    double scale = 1;  ///< of the misfits: 1 where the stated errors are all there is
};

/// Least summed biweight loss over e in [0, 1] and μ in [0, largest_friction], from `start`: total least squares,
/// Ceres. One of both may be fixed. Some ten evaluations of the law an impact and iteration.
LawFit fit_law(const LawProblem& problem, const LawParameters& start,
               const std::optional<double>& fixed_restitution = {}, const std::optional<double>& fixed_friction = {});

struct RobustStart {
    LawParameters parameters;
    double scale = nan;  ///< that holds four in five misfits at the best point of the grid: coarser than the final one
};

/// A start that gross errors do not reach: the point of a grid of (e, μ) with the least biweight loss, at the scale
/// that the least 80 % quantile of the misfits gives, or half a step of e beside that point where this is more. All
/// weights count as 1.
RobustStart first_parameters(const LawProblem& problem);

/// The misfits' robust standard deviation, from their median; never below rounding.
double misfit_scale(const LawProblem& problem, const LawParameters& parameters);

/// Half the biweight loss of each impact.
std::vector<double> losses_of(const LawProblem& problem, const LawParameters& parameters);

// Other pairs of e and μ that explain the impacts nearly as well: a loss has several minima where impacts are alike.

/// A deviance above the least by more does not become the least in one resample of thousands.
inline constexpr double no_rival = 12;

struct Rival {
    std::size_t law = 0;
    LawParameters parameters;
};

/// Minima of a law's loss, the least one first: from several μ at scales that fall to the problem's, and from `near`.
/// Those of more than `most` in deviance above the least are left out. Impacts of one kind have several: with q/p
/// for a friction that never holds, and an e to it, any of them is explained, as it is by one that holds. Some thirty
/// fits.
std::vector<LawFit> minima_of(const LawProblem& problem, const LawParameters& near, double most);

/// The least loss from any of the starts, e or μ fixed or not.
LawFit fit_from(const LawProblem& problem, const std::vector<LawParameters>& starts,
                const std::optional<double>& fixed_restitution = {}, const std::optional<double>& fixed_friction = {});

/// The differences of the losses, impact by impact, in standard errors of their sum; 0 where there is none.
double worse_by(const std::vector<double>& losses, const std::vector<double>& best);

}  // namespace swirl::analysis
