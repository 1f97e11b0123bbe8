// When a cycle has a given multiplier: one number g that is zero then, with its gradient (minimally augmented systems).
#pragma once

#include "analysis/boundaries/plane_map.hpp"

#include <Eigen/Core>

#include <complex>
#include <optional>

namespace swirl::analysis {

/// Real borders of the multiple shooting's matrix, kD long each: anything near its null vectors.
struct CriticalBorders {
    Eigen::VectorXd column;  ///< B
    Eigen::VectorXd row;     ///< C
};

/// With M(λ) the block-cyclic matrix of DF(z_i) and −I whose closing block is −λI (singular where λ is a multiplier):
///     [[M, B], [Cᵀ, 0]] (q; g) = (0; 1),   [[M*, C], [Bᵀ, 0]] (p; ḡ) = (0; 1)
struct CriticalValue {
    std::complex<double> g;
    Eigen::VectorXcd right;              ///< q, kD long
    Eigen::VectorXcd left;               ///< p
    std::complex<double> by_multiplier;  ///< ∂g/∂λ = p_k* q_1
};

/// Cost: one LU of kD + 1 complex unknowns.
CriticalValue critical_value(const PlaneShooting& shooting, std::complex<double> multiplier,
                             const CriticalBorders& borders);

/// ∂g/∂(Z, p) = −p*(∂M)q, kD + 2 long. The second derivatives are central differences of the exact first ones along
/// q, good to 10⁻⁹ or so: they steer, g itself is exact. Cost: 2k steps of the map for a real q, 4k for a complex one.
/// Empty where the map ends beside the cycle.
std::optional<Eigen::VectorXcd> gradient_of(const PlaneMap& map, const Eigen::VectorXd& points,
                                            const Eigen::Vector2d& p, const PlaneShooting& shooting,
                                            const CriticalValue& value);

/// Borders from the null vectors at a cycle that has the multiplier, or nearly: their real parts, turned so that these
/// are largest. Without `before` by inverse iteration.
CriticalBorders borders_at(const PlaneShooting& shooting, std::complex<double> multiplier,
                           const std::optional<CriticalBorders>& before = std::nullopt);

}  // namespace swirl::analysis
