#include "analysis/cycles/cycle.hpp"

#include "analysis/cycles/multi_shooting.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/linear_algebra/dense.hpp"
#include "analysis/lyapunov/cycle_exponents.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::analysis {

std::string_view name_of(Stability stability) {
    using enum Stability;
    return name_in<Stability>({{stable, "stable"}, {unstable, "unstable"}, {neutral, "neutral"}}, stability);
}

bool is_one(std::complex<double> multiplier) {
    return std::abs(multiplier - 1.0) <= neutral_margin;
}

int index_of(Multipliers multipliers) {
    return static_cast<int>(std::count_if(multipliers.begin(), multipliers.end(),
                                          [](const auto& m) { return std::abs(m) > 1 + neutral_margin; }));
}

Stability stability_of(Multipliers multipliers) {
    if (index_of(multipliers) > 0) return Stability::unstable;
    const bool on = std::any_of(multipliers.begin(), multipliers.end(),
                                [](const auto& m) { return std::abs(m) >= 1 - neutral_margin; });
    return on ? Stability::neutral : Stability::stable;
}

double slowest_of(Multipliers multipliers) {
    double slowest = 0;
    for (const auto& m : multipliers)
        if (!is_one(m)) slowest = std::max(slowest, std::abs(m));
    return slowest;
}

bool attracts(Multipliers multipliers) {
    return std::all_of(multipliers.begin(), multipliers.end(),
                       [](const auto& m) { return is_one(m) || std::abs(m) < 1 - neutral_margin; });
}

std::vector<std::complex<double>> sorted_multipliers(const Eigen::MatrixXd& derivative) {
    if (!derivative.allFinite()) return {};
    const Eigen::VectorXcd values = eigenvalues_of(derivative);
    std::vector<std::complex<double>> multipliers(values.data(), values.data() + values.size());
    sort_multipliers(multipliers);
    return multipliers;
}

void sort_multipliers(std::vector<std::complex<double>>& multipliers) {
    std::stable_sort(multipliers.begin(), multipliers.end(), [](const auto& a, const auto& b) {
        const double first = std::abs(a), second = std::abs(b);
        if (std::abs(first - second) > 1e-12 * (first + second)) return first > second;
        return a.imag() > b.imag();
    });
}

namespace {

template <class Values>
Eigen::Index ones_among(const Values& multipliers) {
    return std::count_if(multipliers.begin(), multipliers.end(), &is_one);
}

std::vector<Eigen::MatrixXd> derivatives_of(const ShootingResidual& shooting) {
    std::vector<Eigen::MatrixXd> derivatives;
    for (const auto& step : shooting.steps) derivatives.push_back(step.by_state);
    return derivatives;
}

/// How many multipliers are 1, `enough` or fewer: in double, and in 100 digits only where that finds too few.
Eigen::Index ones_of(const ShootingResidual& shooting, Eigen::Index enough) {
    const Eigen::VectorXcd quick = eigenvalues_of(monodromy(shooting));
    if (const Eigen::Index ones = ones_among(quick); ones >= enough) return enough;
    return std::min(enough, ones_among(cycle_exponents(derivatives_of(shooting)).multipliers));
}

}  // namespace

Eigen::MatrixXd family_directions(const ShootingResidual& shooting, int dimension) {
    const Eigen::MatrixXd null = null_vectors(shooting.by_points());
    Eigen::MatrixXd first = null.rightCols(null.cols() > 0 ? ones_of(shooting, null.cols()) : 0).topRows(dimension);
    for (Eigen::Index j = 0; j < first.cols(); ++j) {
        first.col(j).normalize();
        Eigen::Index largest;
        first.col(j).cwiseAbs().maxCoeff(&largest);
        if (first(largest, j) < 0) first.col(j) *= -1;
    }
    return first;
}

bool complete_cycle(const ShootingMap& map, double p, Cycle& cycle) {
    const ShootingResidual shooting = shooting_residual(map, cycle.points, p);
    if (!shooting.alive) return false;
    const CycleExponents exponents = cycle_exponents(derivatives_of(shooting));
    if (exponents.outcome != CycleOutcome::completed) return false;
    cycle.residual = shooting.residual();
    cycle.return_time = shooting.duration;
    cycle.mean = shooting.integral / shooting.duration;
    cycle.itinerary = shooting.itinerary;
    cycle.multipliers = exponents.multipliers;
    sort_multipliers(cycle.multipliers);
    cycle.index = index_of(cycle.multipliers);
    cycle.stability = stability_of(cycle.multipliers);
    cycle.tangents = family_directions(shooting, map.dimension);
    return true;
}

CyclePoints minimal_cycle(const ShootingMap& map, const CyclePoints& points, double closure) {
    const std::size_t period = minimal_period(
        points.size(), closure, [&](std::size_t i, std::size_t j) { return map.distance(points[i], points[j]); });
    return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(period)};
}

double distance_between(const ShootingMap& map, const CyclePoints& a, const CyclePoints& b) {
    double best = infinity;
    if (a.size() != b.size()) return best;
    for (std::size_t shift = 0; shift < a.size(); ++shift) {
        double largest = 0;
        for (std::size_t i = 0; i < a.size() && largest < best; ++i)
            largest = std::max(largest, map.distance(a[i], b[(i + shift) % b.size()]));
        best = std::min(best, largest);
    }
    return best;
}

}  // namespace swirl::analysis
