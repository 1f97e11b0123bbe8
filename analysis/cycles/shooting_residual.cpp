#include "analysis/cycles/shooting_residual.hpp"

#include "analysis/cycles/newton.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace swirl::analysis {

namespace {

/// What one step's component is known to. Lengths and angles at its end are known to some ε, as if rates at its
/// beginning were to ε/τ.
Eigen::VectorXd rounding_of(const ShootingStep& step, const Eigen::VectorXd& z) {
    constexpr double epsilon = std::numeric_limits<double>::epsilon(), most = 1e-9;
    const Eigen::VectorXd size = step.state.cwiseAbs();
    const Eigen::VectorXd known =
        64 * epsilon * (step.by_state.cwiseAbs() * z.cwiseAbs().cwiseMax(std::max(1.0, 1 / step.duration)) + size);
    return known.cwiseMin((most * (1 + size.array())).matrix());
}

}  // namespace

ShootingResidual shooting_residual(const ShootingMap& map, const CyclePoints& points, double p) {
    const auto k = static_cast<int>(points.size());
    const int d = map.dimension;
    const int passed_on = d - map.constraints;
    ShootingResidual shooting;
    shooting.gap.resize(k * d);
    shooting.rounding.resize(k * d);
    shooting.by_points = Eigen::MatrixXd::Zero(k * d, k * d);
    if (map.has_parameter) shooting.by_parameter.resize(k * d);
    for (int i = 0; i < k; ++i) {
        const int next = (i + 1) % k;
        ShootingStep step = map.step(points[static_cast<std::size_t>(i)], p);
        if (!step.alive) return shooting;
        shooting.gap.segment(i * d, d) = map.gap(step.state, points[static_cast<std::size_t>(next)]);
        shooting.by_points.block(i * d, i * d, d, d) += step.by_state;
        shooting.by_points.block(i * d, next * d, passed_on, passed_on) -=
            Eigen::MatrixXd::Identity(passed_on, passed_on);
        if (map.has_parameter) shooting.by_parameter.segment(i * d, d) = step.by_parameter;
        shooting.rounding.segment(i * d, d) = rounding_of(step, points[static_cast<std::size_t>(i)]);
        shooting.duration += step.duration;
        shooting.integral += step.integral;
        shooting.steps.push_back(std::move(step));
    }
    shooting.alive = shooting.gap.allFinite() && shooting.by_points.allFinite();
    return shooting;
}

bool closes_to(const ShootingResidual& shooting, double accept) {
    return shooting.alive && (shooting.gap.array().abs() <= shooting.rounding.array().max(accept)).all();
}

CyclePoints orbit_from(const ShootingMap& map, const Eigen::VectorXd& z, double p, int k) {
    CyclePoints points{z};
    while (static_cast<int>(points.size()) < k) {
        const ShootingStep step = map.step(points.back(), p);
        if (!step.alive) return {};
        points.push_back(step.state);
    }
    return points;
}

Eigen::MatrixXd monodromy(const ShootingResidual& shooting) {
    Eigen::MatrixXd product = shooting.steps.front().by_state;
    for (std::size_t i = 1; i < shooting.steps.size(); ++i) product = shooting.steps[i].by_state * product;
    return product;
}

std::vector<std::int64_t> word_of(const ShootingResidual& shooting) {
    std::vector<std::int64_t> word;
    for (const auto& step : shooting.steps) word.push_back(step.letter);
    return word;
}

Eigen::VectorXd stacked(const CyclePoints& points) {
    const Eigen::Index d = points.front().size();
    Eigen::VectorXd z(static_cast<Eigen::Index>(points.size()) * d);
    for (std::size_t i = 0; i < points.size(); ++i) z.segment(static_cast<Eigen::Index>(i) * d, d) = points[i];
    return z;
}

CyclePoints unstacked(const Eigen::VectorXd& z, int dimension) {
    CyclePoints points;
    for (Eigen::Index i = 0; i < z.size(); i += dimension) points.emplace_back(z.segment(i, dimension));
    return points;
}

double polish_cycle(const ShootingMap& map, CyclePoints& points, double p, double goal) {
    const auto equation = [&](const Eigen::VectorXd& z, Eigen::VectorXd& gap, Eigen::MatrixXd& derivative) {
        ShootingResidual shooting = shooting_residual(map, unstacked(z, map.dimension), p);
        gap = std::move(shooting.gap);
        derivative = std::move(shooting.by_points);
        return shooting.alive;
    };
    Eigen::VectorXd z = stacked(points);
    NewtonOptions options;
    options.goal = goal;
    const double residual = newton(equation, z, options);
    points = unstacked(z, map.dimension);
    for (auto& point : points) point = map.normalised(point);
    return residual;
}

}  // namespace swirl::analysis
