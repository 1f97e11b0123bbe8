// Newton's method for as many equations as unknowns, near where curves of the plane are born.
#pragma once

#include "analysis/boundaries/arc.hpp"

#include <functional>
#include <optional>

namespace swirl::apps::boundaries {

/// The solution near `start`, to rounding.
///   equations  residual of length n and n × n Jacobian at y; false where there are none
/// Empty if the method leaves the ball of radius 0.1 around `start` or has not converged after 20 steps.
std::optional<Eigen::VectorXd> solve_square_system(
    const std::function<bool(const Eigen::VectorXd& y, analysis::ArcEquations& at)>& equations,
    const Eigen::VectorXd& start);

}  // namespace swirl::apps::boundaries
