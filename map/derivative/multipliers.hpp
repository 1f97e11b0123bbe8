// The multipliers of a cycle.
#pragma once

#include <Eigen/Core>

namespace swirl {

/// The eigenvalues of DFᵏ, in no order. In a file of its own, because Eigen's solver takes some ten seconds to compile.
///   derivative  D × D
/// Cost: a Hessenberg reduction and the QR algorithm, some 10 D³.
Eigen::VectorXcd multipliers_of(const Eigen::MatrixXd& derivative);

}  // namespace swirl
