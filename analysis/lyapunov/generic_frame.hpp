// An orthonormal frame in general position: where tangent vectors start.
#pragma once

#include <Eigen/Core>

namespace swirl::analysis {

/// A fixed D × D orthonormal matrix without any symmetry that a map could share: no coordinate axis, nor a sum or
/// difference of two, is among its directions.
Eigen::MatrixXd generic_frame(int dimension);

}  // namespace swirl::analysis
