#include "analysis/boundaries/plane_map.hpp"

#include <utility>

namespace swirl::analysis {

ShootingMap on_line(const PlaneMap& map, int axis, const Eigen::Vector2d& p) {
    ShootingMap line;
    line.dimension = map.dimension;
    line.angle_periods = map.angle_periods;
    line.least_margin = map.least_margin;
    line.has_parameter = true;
    line.step = [map, axis, p](const Eigen::VectorXd& z, double value) {
        Eigen::Vector2d there = p;
        there[axis] = value;
        const PlaneStep at = map.step(z, there);
        ShootingStep step;
        step.alive = at.alive;
        if (!at.alive) return step;
        step.state = at.state;
        step.by_state = at.by_state;
        step.by_parameter = at.by_parameters.col(axis);
        step.letter = at.letter;
        step.duration = at.duration;
        step.margin = at.margin;
        return step;
    };
    return line;
}

PlaneShooting plane_shooting(const PlaneMap& map, const Eigen::VectorXd& points, const Eigen::Vector2d& p) {
    const Eigen::Index d = map.dimension, size = points.size(), k = size / d;
    ShootingMap angles;  // its difference of angles alone is wanted
    angles.dimension = map.dimension;
    angles.angle_periods = map.angle_periods;
    PlaneShooting shooting;
    shooting.gap.resize(size);
    shooting.by_unknowns = Eigen::MatrixXd::Zero(size, size + 2);
    for (Eigen::Index i = 0; i < k; ++i) {
        const Eigen::Index next = (i + 1) % k;
        PlaneStep step = map.step(points.segment(i * d, d), p);
        if (!step.alive) return shooting;
        shooting.gap.segment(i * d, d) = angles.difference(step.state, points.segment(next * d, d));
        shooting.by_unknowns.block(i * d, i * d, d, d) += step.by_state;
        shooting.by_unknowns.block(i * d, next * d, d, d) -= Eigen::MatrixXd::Identity(d, d);
        shooting.by_unknowns.block(i * d, size, d, 2) = step.by_parameters;
        shooting.word.push_back(step.letter);
        shooting.steps.push_back(std::move(step));
    }
    shooting.alive = shooting.gap.allFinite() && shooting.by_unknowns.allFinite();
    return shooting;
}

Eigen::MatrixXd monodromy(const PlaneShooting& shooting) {
    Eigen::MatrixXd product = shooting.steps.front().by_state;
    for (std::size_t i = 1; i < shooting.steps.size(); ++i) product = shooting.steps[i].by_state * product;
    return product;
}

}  // namespace swirl::analysis
