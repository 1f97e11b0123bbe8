#include "analysis/cycles/newton.hpp"

#include "analysis/linear_algebra/dense.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>

namespace swirl::analysis {

double newton(const Equation& equation, Eigen::VectorXd& x, const NewtonOptions& options) {
    constexpr double small = 1e-9;  // singular values below that of the largest are a family's
    double best = infinity;
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
        // Below 100 times the goal what rises is rounding.
        if (options.most_rise > 0 && residual > options.most_rise * std::max(best, 100 * options.goal)) break;
        x = x - minimum_norm_solution(derivative, gap, small);
    }
    x = kept;
    return best;
}

}  // namespace swirl::analysis
