// Newton's method with a minimum-norm step, whatever the unknowns of a cycle are: one point of it, or all k at once.
#pragma once

#include <Eigen/Core>

#include <functional>

namespace swirl::analysis {

/// G(x) and ∂G/∂x; false where the map ends on the way.
using Equation = std::function<bool(const Eigen::VectorXd& x, Eigen::VectorXd& gap, Eigen::MatrixXd& derivative)>;

struct NewtonOptions {
    double goal = 0;       ///< the iteration stops as soon as max |G| is that small; 0: where rounding stops it
    int most = 12;         ///< iterations; quadratic: 3 or 4 are usual from where a solver stops
    int patience = 2;      ///< from this iteration on one that is no better than the best before is the last
    double most_rise = 0;  ///< so is, from the first on, one that is so many times the best before (0: none is)
};

/// Solves G(x) = 0 from x by steps of minimum norm: where solutions are no points but families (singular values below
/// 10⁻⁹ of the largest) the member near the start is found. Returns the smallest max |G|, whose x is kept; +∞ if the
/// map ends at the start. Cost: an equation and a complete orthogonal decomposition an iteration.
double newton(const Equation& equation, Eigen::VectorXd& x, const NewtonOptions& options = {});

}  // namespace swirl::analysis
