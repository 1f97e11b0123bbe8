// A norm in which a matrix whose eigenvalues lie inside the unit circle contracts, however far from normal it is.
#pragma once

#include <Eigen/Core>

#include <optional>

namespace swirl::analysis {

/// ‖x‖² = xᵀPx with P = Σ (Aʲ)ᵀAʲ, the solution of P = 1 + AᵀPA (Stein's equation). Then ‖Ax‖² = ‖x‖² − |x|², so that
/// ‖Ax‖ ≤ q‖x‖ with q² = 1 − 1/λ_max(P).
struct ContractionNorm {
    Eigen::MatrixXd root;  ///< upper triangular R with P = RᵀR: ‖x‖ = |Rx|
    double largest = 1;    ///< λ_max(P) ≥ 1: ‖x‖² ≤ λ_max |x|²
    double rate = 0;       ///< q < 1

    double of(const Eigen::VectorXd& x) const { return (root * x).norm(); }
    /// The x of norm `size` for which Rx points along axis i.
    Eigen::VectorXd axis(Eigen::Index i, double size) const;
};

/// None where A does not contract by more than rounding: P beyond 10¹². By doubling (R. A. Smith, SIAM J. Appl. Math.
/// 16 (1968) 198), some ten products of matrices.
std::optional<ContractionNorm> contraction_norm(const Eigen::MatrixXd& a);

}  // namespace swirl::analysis
