#include "analysis/cycles/curve.hpp"

#include "analysis/cycles/null_space.hpp"
#include "analysis/linear_algebra/dense.hpp"

#include <cmath>

namespace swirl::analysis {

namespace {

Equations equations_of(const ShootingMap& map, const std::function<ShootingStep(const Eigen::VectorXd&, double)>& step,
                       double p) {
    return [&map, &step, p](const Eigen::VectorXd& y) { return shooting_residual(map, step, y, p); };
}

/// A direction that the curve has a part of: the null vector of the Jacobian's smallest singular value.
Eigen::VectorXd null_direction(const ShootingResidual& shooting, bool has_parameter) {
    const SingularVectors svd = right_singular_vectors(shooting.jacobian);
    Eigen::VectorXd direction = svd.right.rightCols(1);
    Eigen::Index lead = direction.size() - 1;
    if (!has_parameter || std::abs(direction[lead]) < 1e-6) direction.cwiseAbs().maxCoeff(&lead);
    if (direction[lead] < 0) direction *= -1;
    return direction;
}

}  // namespace

CurveProblem cycle_problem(const ShootingMap& map, std::size_t k, double p) {
    const Eigen::Index coordinates = map.dimension * static_cast<Eigen::Index>(k);
    CurveProblem problem;
    problem.weights =
        Eigen::VectorXd::Constant(coordinates + (map.has_parameter ? 1 : 0), 1.0 / static_cast<double>(k));
    if (map.has_parameter) problem.weights[coordinates] = 1;
    problem.equations = equations_of(map, map.step, p);
    if (map.step_from_surface) problem.equations_from_surface = equations_of(map, map.step_from_surface, p);
    problem.newton.goal = 1e-14;
    problem.newton.accept = 1e-12;
    problem.newton.most_iterations = 10;
    problem.locate.bits = 52;
    problem.locate.most_trials = 100;
    return problem;
}

bool is_on_curve(const ShootingResidual& shooting) {
    Eigen::MatrixXd scaled = shooting.jacobian;
    equilibrate(scaled);
    return rank_of(scaled, null_margin) == scaled.cols() - 1;
}

bool begin_curve(const ShootingMap& map, const CyclePoints& points, double p, const Eigen::VectorXd& previous,
                 CurvePoint& point) {
    const CurveProblem problem = cycle_problem(map, points.size(), p);
    point.y.resize(problem.weights.size());
    point.y.head(problem.weights.size() - (map.has_parameter ? 1 : 0)) = stacked(points);
    if (map.has_parameter) point.y[point.y.size() - 1] = p;
    point.shooting = problem.equations(point.y);
    if (!point.shooting.alive) return false;
    return find_tangent(problem, previous.size() > 0 ? previous : null_direction(point.shooting, map.has_parameter),
                        point);
}

Eigen::VectorXd across(const ShootingMap& map, const CurvePoint& from, const CyclePoints& to, double p) {
    const Eigen::Index coordinates = from.shooting.coordinates();
    Eigen::VectorXd y(from.y.size());
    y.head(coordinates) = stacked(to);
    if (map.has_parameter) y[coordinates] = p;
    return map.difference(y, from.y, coordinates);
}

}  // namespace swirl::analysis
