#include "analysis/orbits/cycle.hpp"

#include "analysis/lyapunov/cycle_exponents.hpp"

#include <Eigen/SVD>

#include <algorithm>
#include <limits>

namespace swirl::analysis {

std::string_view name(Stability stability) {
    switch (stability) {
        case Stability::stable: return "stable";
        case Stability::unstable: return "unstable";
        case Stability::neutral: return "neutral";
    }
    return "?";
}

void sort_multipliers(std::vector<std::complex<double>>& multipliers) {
    std::stable_sort(multipliers.begin(), multipliers.end(), [](const auto& a, const auto& b) {
        const double first = std::abs(a), second = std::abs(b);
        if (std::abs(first - second) > 1e-12 * (first + second)) return first > second;
        return a.imag() > b.imag();
    });
}

void judge_stability(Cycle& cycle) {
    bool on = false;
    cycle.index = 0;
    for (const auto& multiplier : cycle.multipliers) {
        if (std::abs(multiplier) > 1 + neutral_margin) ++cycle.index;
        else if (std::abs(multiplier) >= 1 - neutral_margin) on = true;
    }
    cycle.stability = cycle.index > 0 ? Stability::unstable : on ? Stability::neutral : Stability::stable;
}

Eigen::MatrixXd family_directions(const Closing& closing, int dimension) {
    constexpr double null = 1e-8;
    const Eigen::JacobiSVD<Eigen::MatrixXd> svd(closing.by_points, Eigen::ComputeFullV);
    const auto& values = svd.singularValues();
    Eigen::Index rank = values.size();
    while (rank > 0 && values[rank - 1] <= null * values[0]) --rank;
    Eigen::MatrixXd first = svd.matrixV().rightCols(values.size() - rank).topRows(dimension);
    for (Eigen::Index j = 0; j < first.cols(); ++j) {
        first.col(j).normalize();
        Eigen::Index largest;
        first.col(j).cwiseAbs().maxCoeff(&largest);
        if (first(largest, j) < 0) first.col(j) *= -1;
    }
    return first;
}

bool complete_cycle(const ShootingMap& map, double p, Cycle& cycle) {
    const Closing closing = close_cycle(map, cycle.points, p);
    if (!closing.alive) return false;
    std::vector<Eigen::MatrixXd> derivatives;
    for (const auto& step : closing.steps) derivatives.push_back(step.by_state);
    const CycleExponents exponents = cycle_exponents(derivatives);
    if (exponents.outcome != CycleOutcome::completed) return false;
    cycle.residual = closing.residual();
    cycle.return_time = closing.duration;
    cycle.mean = closing.integral / closing.duration;
    cycle.word = word_of(closing);
    cycle.multipliers = exponents.multipliers;
    sort_multipliers(cycle.multipliers);
    judge_stability(cycle);
    cycle.tangents = family_directions(closing, map.dimension);
    return true;
}

CyclePoints minimal_cycle(const ShootingMap& map, const CyclePoints& points, double closure) {
    const std::size_t k = points.size();
    for (std::size_t d = 1; d < k; ++d) {
        if (k % d != 0) continue;
        bool closes = true;
        for (std::size_t i = 0; closes && i < k; ++i) closes = map.distance(points[i], points[(i + d) % k]) <= closure;
        if (closes) return {points.begin(), points.begin() + static_cast<std::ptrdiff_t>(d)};
    }
    return points;
}

double distance_between(const ShootingMap& map, const CyclePoints& a, const CyclePoints& b) {
    double best = std::numeric_limits<double>::infinity();
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
