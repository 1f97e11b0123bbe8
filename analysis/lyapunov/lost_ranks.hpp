// How many multipliers of a cycle are zero because DFᵏ loses rank, and not because they are small.
#pragma once

#include <Eigen/Core>

#include <span>

namespace swirl::analysis {

/// The dimension of the generalised null space of DFᵏ = D_k … D₁, the derivatives in the order in which they are
/// passed. A frame in general position is carried round n times, n the matrices' size, since a nilpotent part of size
/// m ≤ n vanishes at the mth power; after each derivative the frame is orthonormalised, and a direction whose length
/// fell to `rank_tolerance` ‖D_i‖ or less is lost. O(k n⁴).
Eigen::Index lost_ranks(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance);

}  // namespace swirl::analysis
