// The values of μ that a fit's loss does not exclude.
#pragma once

#include "analysis/fits/fit_impacts.hpp"
#include "analysis/fits/law_fit.hpp"

#include <cstddef>
#include <span>
#include <vector>

namespace swirl::analysis {

/// The problem of a fit with one of the laws.
LawProblem with_law(LawProblem problem, std::span<const NamedImpactLaw> laws, std::size_t law);

/// The parameters of a law, and its rivals.
std::vector<LawParameters> starts_of(const ImpactFit& fit, std::size_t law);

/// It may be the best one in a resample; one that predicts the same as the best is not looked at.
bool contends(const ImpactFit& fit, std::size_t law);

/// Any μ does: 2 (loss − least loss) of the largest, χ² with 1 degree of freedom, does not exclude it.
bool any_friction_does(const ImpactFit& fit, const LawProblem& problem, std::span<const NamedImpactLaw> laws);

/// Where any large μ does: the least one that does.
double least_friction(const ImpactFit& fit, const LawProblem& problem, std::span<const NamedImpactLaw> laws);

/// Makes the intervals hold every μ that the loss does not exclude, and the e that goes with it: where impacts are
/// alike several ranges of μ explain them, and a resample knows those that its starts lead to. Some 70 fits of each law
/// that contends.
void add_unexcluded(ImpactFit& fit, const LawProblem& problem, std::span<const NamedImpactLaw> laws);

}  // namespace swirl::analysis
