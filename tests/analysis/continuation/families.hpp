// Maps with one parameter whose bifurcations are known in closed form or published.
#pragma once

#include "analysis/continuation/continue_branch.hpp"
#include "analysis/curves/shooting_map.hpp"

#include <cmath>

namespace swirl::analysis {

/// A branch is followed from `low` to `high`.
inline ContinuationOptions range(double low, double high) {
    ContinuationOptions options;
    options.low = low;
    options.high = high;
    return options;
}

}  // namespace swirl::analysis

namespace swirl::analysis::maps {

/// x′ = r x (1 − x).
inline ShootingMap logistic_family() {
    ShootingMap map;
    map.dimension = 1;
    map.has_parameter = true;
    map.angle_periods = {0};
    map.step = [](const Eigen::VectorXd& z, double r) {
        ShootingStep step;
        step.alive = std::abs(z[0]) < 10;
        step.state = Eigen::VectorXd::Constant(1, r * z[0] * (1 - z[0]));
        step.by_state = Eigen::MatrixXd::Constant(1, 1, r * (1 - 2 * z[0]));
        step.by_parameter = Eigen::VectorXd::Constant(1, z[0] * (1 - z[0]));
        return step;
    };
    return map;
}

/// x′ = x + p x − xⁿ.
inline ShootingMap crossing_family(int n) {
    ShootingMap map;
    map.dimension = 1;
    map.has_parameter = true;
    map.angle_periods = {0};
    map.step = [n](const Eigen::VectorXd& z, double p) {
        ShootingStep step;
        step.alive = std::abs(z[0]) < 10;
        step.state = Eigen::VectorXd::Constant(1, z[0] + p * z[0] - std::pow(z[0], n));
        step.by_state = Eigen::MatrixXd::Constant(1, 1, 1 + p - n * std::pow(z[0], n - 1));
        step.by_parameter = Eigen::VectorXd::Constant(1, z[0]);
        return step;
    };
    return map;
}
inline ShootingMap pitchfork_family() {
    return crossing_family(3);
}
inline ShootingMap transcritical_family() {
    return crossing_family(2);
}

/// x′ = 1 − a x² + y, y′ = b x over a.
inline ShootingMap henon_family(double b = 0.3) {
    ShootingMap map;
    map.dimension = 2;
    map.has_parameter = true;
    map.angle_periods = {0, 0};
    map.step = [b](const Eigen::VectorXd& z, double a) {
        ShootingStep step;
        step.alive = z.norm() < 100;
        step.state = Eigen::Vector2d(1 - a * z[0] * z[0] + z[1], b * z[0]);
        step.by_state = Eigen::Matrix2d{{-2 * a * z[0], 1}, {b, 0}};
        step.by_parameter = Eigen::Vector2d(-z[0] * z[0], 0);
        return step;
    };
    return map;
}

/// φ′ = φ + v, v′ = αv − γ cos φ′ over γ.
inline ShootingMap bouncing_ball_family(double alpha = 0.8) {
    ShootingMap map;
    map.dimension = 2;
    map.has_parameter = true;
    map.angle_periods = {2 * M_PI, 0};
    map.step = [alpha](const Eigen::VectorXd& z, double gamma) {
        ShootingStep step;
        step.alive = true;
        const double phase = z[0] + z[1];
        const double slope = gamma * std::sin(phase);
        step.state = Eigen::Vector2d(phase, alpha * z[1] - gamma * std::cos(phase));
        step.by_state = Eigen::Matrix2d{{1, 1}, {slope, alpha + slope}};
        step.by_parameter = Eigen::Vector2d(0, -std::cos(phase));
        return step;
    };
    return map;
}

}  // namespace swirl::analysis::maps
