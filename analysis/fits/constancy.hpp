// Do e and μ depend on how fast the bodies strike or slip?
#pragma once

#include "analysis/fits/law_fit.hpp"

#include <span>
#include <string>
#include <vector>

namespace swirl::analysis {

/// What one impact alone would have each parameter be, to first order about the fit: the parameter plus
/// g·residual/|g|², g the slopes of its misfit. Speeds are those of the most likely velocity before the impact.
struct ImpactResidual {
    double approach_speed, slip_speed;  ///< of the contact before the impact
    double misfit;                      ///< distance from the law, in units of the fit's scale
    double weight;                      ///< the biweight's: 0 an outlier, 1 a perfect fit
    /// e and μ less the fit's; NaN where the impact does not depend on it.
    double restitution, friction;
    double restitution_information, friction_information;  ///< |g|²: one over the variance of these
};
std::vector<ImpactResidual> residuals_of(const LawProblem& problem, const LawParameters& parameters);

/// The slope of a parameter over a speed, by least squares over the impacts, weighted by the biweight and by what each
/// impact tells of the parameter; its standard error holds for any scatter (HC3,
/// MacKinnon & White 1985).
struct ConstancyTest {
    std::string parameter;  ///< "restitution" or "friction"
    std::string speed;      ///< "approach" or "slip"
    double slope, error;    ///< change of the parameter per unit of speed; NaN where no impact tells
    bool constant;          ///< |slope| ≤ `sure_slope` errors; true, too, where fewer than 3 impacts tell
};

/// Four tests at 5 % together (Bonferroni), by Student's t: as many errors as a slope of 0 stays within.
///   freedom  (Σ w x²)²/Σ (w x²)² − 2 with weights w and speeds x from their mean: the few impacts by which the slope
///   is
///            known (after Satterthwaite)
double sure_slope(double freedom);

std::vector<ConstancyTest> constancy_tests(std::span<const ImpactResidual> residuals);

}  // namespace swirl::analysis
