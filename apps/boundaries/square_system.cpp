#include "apps/boundaries/square_system.hpp"

#include "analysis/linear_algebra/dense.hpp"

#include <cmath>
#include <limits>

namespace swirl::apps::boundaries {

std::optional<Eigen::VectorXd> solve_square_system(
    const std::function<bool(const Eigen::VectorXd& y, analysis::ArcEquations& at)>& equations,
    const Eigen::VectorXd& start) {
    constexpr double rounding = 1e-12, most_rounding = 1e-9, farthest = 0.1;
    Eigen::VectorXd y = start;
    double before = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 20; ++i) {
        analysis::ArcEquations at;
        if (!equations(y, at)) return std::nullopt;
        const Eigen::VectorXd step = analysis::solve_by_qr(at.jacobian, -at.residual);
        const double size = step.norm();
        if (!std::isfinite(size) || !((y - start).norm() < farthest)) return std::nullopt;
        if (size <= rounding || (size >= 0.5 * before && size <= most_rounding)) return y;
        before = size;
        y += step;
    }
    return std::nullopt;
}

}  // namespace swirl::apps::boundaries
