#include "analysis/curves/shooting_residual.hpp"

#include "analysis/curves/newton.hpp"

#include <algorithm>
#include <cstddef>
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

/// Of k points, by a map with so many parameters.
template <class StepFrom>
ShootingResidual residual_of(const MapCoordinates& map, Eigen::Index parameters, const CyclePoints& points,
                             const StepFrom& step_from) {
    const Eigen::Index d = map.dimension, size = d * static_cast<Eigen::Index>(points.size());
    const Eigen::Index passed_on = d - map.constraints;
    ShootingResidual shooting;
    shooting.period = points.size();
    shooting.dimension = map.dimension;
    shooting.gap.resize(size);
    shooting.rounding.resize(size);
    shooting.jacobian = Eigen::MatrixXd::Zero(size, size + parameters);
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::size_t next = (k + 1) % points.size();
        const Eigen::Index i = d * static_cast<Eigen::Index>(k), j = d * static_cast<Eigen::Index>(next);
        ShootingStep step = step_from(points[k]);
        if (!step.alive) return shooting;
        shooting.gap.segment(i, d) = map.gap(step.state, points[next]);
        shooting.jacobian.block(i, i, d, d) += step.by_state;
        shooting.jacobian.block(i, j, passed_on, passed_on) -= Eigen::MatrixXd::Identity(passed_on, passed_on);
        if (parameters > 0) shooting.jacobian.block(i, size, d, parameters) = step.by_parameter;
        shooting.rounding.segment(i, d) = rounding_of(step, points[k]);
        shooting.duration += step.duration;
        shooting.integral += step.integral;
        shooting.itinerary.push_back(step.letter);
        shooting.steps.push_back(std::move(step));
    }
    shooting.alive = shooting.gap.allFinite() && shooting.jacobian.allFinite();
    return shooting;
}

}  // namespace

ShootingMap on_line(const PlaneMap& map, int axis, const Eigen::Vector2d& p) {
    ShootingMap line{map, true, [map, axis, p](const Eigen::VectorXd& z, double value) {
                         Eigen::Vector2d there = p;
                         there[axis] = value;
                         ShootingStep step = map.step(z, there);
                         if (step.alive) step.by_parameter = step.by_parameter.col(axis).eval();
                         return step;
                     }};
    return line;
}

ShootingResidual shooting_residual(const ShootingMap& map, const CyclePoints& points, double p) {
    return residual_of(map, map.has_parameter ? 1 : 0, points,
                       [&](const Eigen::VectorXd& z) { return map.step(z, p); });
}

ShootingResidual shooting_residual(const ShootingMap& map, const decltype(ShootingMap::step)& step,
                                   const Eigen::VectorXd& y, double p) {
    const Eigen::Index parameters = map.has_parameter ? 1 : 0, coordinates = y.size() - parameters;
    const double there = map.has_parameter ? y[coordinates] : p;
    return residual_of(map, parameters, unstacked(y.head(coordinates), map.dimension),
                       [&](const Eigen::VectorXd& z) { return step(z, there); });
}

ShootingResidual shooting_residual(const PlaneMap& map, const Eigen::VectorXd& stacked_points,
                                   const Eigen::Vector2d& p) {
    return residual_of(map, 2, unstacked(stacked_points, map.dimension),
                       [&](const Eigen::VectorXd& z) { return map.step(z, p); });
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
    const auto equations = [&](const Eigen::VectorXd& z) {
        ShootingResidual shooting = shooting_residual(map, unstacked(z, map.dimension), p);
        shooting.jacobian.conservativeResize(Eigen::NoChange, shooting.coordinates());  // p is given
        return shooting;
    };
    Eigen::VectorXd z = stacked(points);
    const double residual = newton_of_least_norm(equations, z, until_rounding(goal));
    points = unstacked(z, map.dimension);
    for (auto& point : points) point = map.normalised(point);
    return residual;
}

}  // namespace swirl::analysis
