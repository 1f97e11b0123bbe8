#include "analysis/orbits/cycle.hpp"

#include "analysis/lyapunov/cycle_exponents.hpp"
#include "analysis/orbits/null_space.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <limits>

namespace swirl::analysis {

std::string_view name(Stability stability) {
    switch (stability) {
        case Stability::stable:
            return "stable";
        case Stability::unstable:
            return "unstable";
        case Stability::neutral:
            return "neutral";
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
        if (std::abs(multiplier) > 1 + neutral_margin)
            ++cycle.index;
        else if (std::abs(multiplier) >= 1 - neutral_margin)
            on = true;
    }
    cycle.stability = cycle.index > 0 ? Stability::unstable : on ? Stability::neutral : Stability::stable;
}

namespace {

template <class Multipliers>
Eigen::Index ones_among(const Multipliers& multipliers) {
    return std::count_if(multipliers.begin(), multipliers.end(),
                         [](const std::complex<double>& m) { return std::abs(m - 1.0) <= neutral_margin; });
}

std::vector<Eigen::MatrixXd> derivatives_of(const ShootingResidual& shooting) {
    std::vector<Eigen::MatrixXd> derivatives;
    for (const auto& step : shooting.steps) derivatives.push_back(step.by_state);
    return derivatives;
}

/// How many multipliers are 1, `enough` or fewer: in double, and in 100 digits only where that finds too few.
Eigen::Index ones_of(const ShootingResidual& shooting, Eigen::Index enough) {
    const Eigen::VectorXcd quick = Eigen::EigenSolver<Eigen::MatrixXd>(monodromy(shooting), false).eigenvalues();
    if (const Eigen::Index ones = ones_among(quick); ones >= enough) return enough;
    return std::min(enough, ones_among(cycle_exponents(derivatives_of(shooting)).multipliers));
}

}  // namespace

Eigen::MatrixXd family_directions(const ShootingResidual& shooting, int dimension) {
    const Eigen::MatrixXd null = null_vectors(shooting.by_points);
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
    cycle.word = word_of(shooting);
    cycle.multipliers = exponents.multipliers;
    sort_multipliers(cycle.multipliers);
    judge_stability(cycle);
    cycle.tangents = family_directions(shooting, map.dimension);
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
