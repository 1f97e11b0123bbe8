// e and μ of one law from many impacts.
#pragma once

#include "analysis/fits/law_misfit.hpp"
#include "analysis/special_values.hpp"

#include <optional>
#include <span>
#include <vector>

namespace swirl::analysis {

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
/// that the least 80 % quantile of the misfits gives. All weights count as 1.
RobustStart first_parameters(const LawProblem& problem);

/// The misfits' robust standard deviation, from their median; never below rounding.
double misfit_scale(const LawProblem& problem, const LawParameters& parameters);

/// Half the biweight loss of each impact.
std::vector<double> losses_of(const LawProblem& problem, const LawParameters& parameters);

}  // namespace swirl::analysis
