// Other pairs of e and μ that explain the impacts nearly as well: a loss has several minima where impacts are alike.
#pragma once

#include "analysis/fits/law_fit.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace swirl::analysis {

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
