#include "analysis/fits/unexcluded.hpp"

#include "analysis/fits/law_fit.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swirl::analysis {

namespace {

using Laws = std::span<const NamedImpactLaw>;

/// Laws that are worse by more never win in a resample.
constexpr double no_contender = 4;

/// At a fixed μ, of the law that is best there.
LawFit fit_at(const ImpactFit& fit, const LawProblem& problem, Laws laws, double friction) {
    LawFit best;
    for (std::size_t i = 0; i < laws.size(); ++i) {
        if (!contends(fit, i)) continue;
        const LawFit found = fit_from(with_law(problem, laws, i), starts_of(fit, i), {}, friction);
        if (!(found.loss >= best.loss)) best = found;
    }
    return best;
}

bool is_excluded(const ImpactFit& fit, const LawFit& found) {
    return 2 * (found.loss - fit.laws[fit.best].loss) > sure_square_of_one;
}

void hold(FittedNumber& number, double value) {
    number.low = std::min(number.low, value), number.high = std::max(number.high, value);
}

void hold(ImpactFit& fit, const LawFit& found) {
    hold(fit.restitution, found.parameters.restitution);
    hold(fit.friction, found.parameters.friction);
}

}  // namespace

LawProblem with_law(LawProblem problem, Laws laws, std::size_t law) {
    problem.law = &laws[law].law;
    return problem;
}

std::vector<LawParameters> starts_of(const ImpactFit& fit, std::size_t law) {
    std::vector<LawParameters> starts = {fit.laws[law].parameters};
    for (const Rival& rival : fit.rivals)
        if (rival.law == law) starts.push_back(rival.parameters);
    return starts;
}

bool contends(const ImpactFit& fit, std::size_t law) {
    return law == fit.best || (fit.laws[law].worse_by > 0 && fit.laws[law].worse_by <= no_contender);
}

bool any_friction_does(const ImpactFit& fit, const LawProblem& problem, Laws laws) {
    return !is_excluded(fit, fit_at(fit, problem, laws, largest_friction));
}

double least_friction(const ImpactFit& fit, const LawProblem& problem, Laws laws) {
    double high = largest_friction, low = high;
    while (low > 1e-3) {
        low = high / 1.3;
        if (is_excluded(fit, fit_at(fit, problem, laws, low))) break;
        high = low;
    }
    for (int halving = 0; halving < 12; ++halving) {
        const double middle = std::sqrt(low * high);
        (is_excluded(fit, fit_at(fit, problem, laws, middle)) ? low : high) = middle;
    }
    return low > 1e-3 ? low : 0;
}

void add_unexcluded(ImpactFit& fit, const LawProblem& problem, Laws laws) {
    constexpr double ratio = 1.2, least_tried = 2e-3;
    const auto edge = [&](double inside, double outside) {
        for (int halving = 0; halving < 8; ++halving) {
            const double middle = std::sqrt(inside * outside);
            (is_excluded(fit, fit_at(fit, problem, laws, middle)) ? outside : inside) = middle;
        }
        return inside;
    };
    for (const Rival& rival : fit.rivals)  // between the points below
        if (const LawFit found = fit_law(with_law(problem, laws, rival.law), rival.parameters);
            !is_excluded(fit, found))
            hold(fit, found);
    double before = 0;
    bool was_excluded = true;
    for (double friction = least_tried; friction < ratio * largest_friction; friction *= ratio) {
        const double tried = std::min(friction, largest_friction);
        const LawFit found = fit_at(fit, problem, laws, tried);
        const bool now_excluded = is_excluded(fit, found);
        if (!now_excluded) hold(fit, found);
        if (!now_excluded && was_excluded) hold(fit.friction, before > 0 ? edge(tried, before) : 0);
        if (now_excluded && !was_excluded) hold(fit.friction, edge(before, tried));
        before = tried, was_excluded = now_excluded;
    }
    // About the best one, which may lie between two points.
    const double best = fit.laws[fit.best].parameters.friction;
    for (const double beside : {best / ratio, best * ratio})
        if (best > 0 && beside < largest_friction && is_excluded(fit, fit_at(fit, problem, laws, beside)))
            hold(fit.friction, edge(best, beside));
}

}  // namespace swirl::analysis
