#include "analysis/cycles/newton.hpp"

#include "analysis/linear_algebra/dense.hpp"

#include <limits>

namespace swirl::analysis {

double newton(const Equation& equation, Eigen::VectorXd& x, const NewtonOptions& options) {
    constexpr double small = 1e-9;  // singular values below that of the largest are a family's
    double best = std::numeric_limits<double>::infinity();
    Eigen::VectorXd kept = x, gap;
    Eigen::MatrixXd derivative;
    for (int i = 0; i < options.most; ++i) {
        if (!equation(x, gap, derivative)) break;
        const double residual = gap.lpNorm<Eigen::Infinity>();
        const bool better = residual < best;
        if (better) {
            best = residual;
            kept = x;
        }
        if (best <= options.goal || (!better && i > options.patience)) break;
        x -= minimum_norm_solution(derivative, gap, small);
    }
    x = kept;
    return best;
}

}  // namespace swirl::analysis
