#include "analysis/fits/rivals.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

LawFit fit_from(const LawProblem& problem, const std::vector<LawParameters>& starts,
                const std::optional<double>& fixed_restitution, const std::optional<double>& fixed_friction) {
    LawFit best;
    for (const LawParameters& start : starts) {
        const LawFit found = fit_law(problem, start, fixed_restitution, fixed_friction);
        if (!(found.loss >= best.loss)) best = found;
    }
    return best;
}

std::vector<LawFit> minima_of(const LawProblem& problem, const LawParameters& near, double most) {
    // Kinks of the law where contact modes change make small dents in the loss: also from beside it.
    std::vector<LawFit> found = {fit_law(problem, near)};
    for (const double factor : {0.96, 0.98, 1.02, 1.04})
        found.push_back(fit_law(problem, {near.restitution, factor * near.friction}));
    for (const double friction : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1.6, largest_friction}) {
        LawParameters parameters{0.5, friction};
        LawProblem coarse = problem;
        for (const double factor : {16.0, 4.0}) {
            coarse.scale = factor * problem.scale;
            parameters = fit_law(coarse, parameters).parameters;
        }
        found.push_back(fit_law(problem, parameters));
    }
    std::stable_sort(found.begin(), found.end(), [](const LawFit& a, const LawFit& b) { return a.loss < b.loss; });
    std::vector<LawFit> minima;
    for (const LawFit& one : found) {
        if (2 * (one.loss - found.front().loss) > most) break;
        constexpr double same = 0.01, level = 0.05;
        const bool is_new = std::none_of(minima.begin(), minima.end(), [&](const LawFit& other) {
            const LawParameters &a = one.parameters, &b = other.parameters;
            const bool flat = std::abs(one.loss - other.loss) < level;  // where any large μ predicts the same
            return std::abs(a.restitution - b.restitution) < same &&
                   (flat || std::abs(a.friction - b.friction) < same * (0.1 + b.friction));
        });
        if (is_new) minima.push_back(one);
    }
    return minima;
}

double worse_by(const std::vector<double>& losses, const std::vector<double>& best) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < losses.size(); ++i) sum += losses[i] - best[i];
    const double mean = sum / static_cast<double>(losses.size());
    for (std::size_t i = 0; i < losses.size(); ++i) squares += std::pow(losses[i] - best[i] - mean, 2);
    constexpr double rounding = 1e-6;  // of a loss, where fits end
    return sum > rounding * static_cast<double>(losses.size()) ? sum / std::sqrt(squares) : 0;
}

}  // namespace swirl::analysis
