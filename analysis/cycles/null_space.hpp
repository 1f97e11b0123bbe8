// The null space of an equation's Jacobian, whatever the units of its rows and columns are.
#pragma once

#include <Eigen/Core>

namespace swirl::analysis {

/// Scales rows and columns until the largest of each is 1 but for a few per cent (D. Ruiz, RAL-TR-2001-034): the
/// singular values of a scene with S of 10³ then say what its equations say, not what its coordinates are. Returns the
/// columns' factors c, so that c∘v is a null vector of the given matrix if v is one of the scaled.
Eigen::VectorXd equilibrate(Eigen::MatrixXd& matrix);

/// What counts as zero of a scaled matrix's singular values, in units of the largest: well above a derivative's
/// rounding, well below |multiplier − 1| of an isolated cycle.
inline constexpr double null_margin = 1e-8;

/// Null vectors of a matrix as columns, the surest last: those of singular values below `null_margin` after
/// `equilibrate`. Cost: one SVD.
Eigen::MatrixXd null_vectors(const Eigen::MatrixXd& matrix);

}  // namespace swirl::analysis
