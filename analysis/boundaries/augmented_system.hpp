// Minimally augmented systems: one number g that is zero where a cycle has a given multiplier, and a fold, flip or
// Neimark–Sacker curve of cycles as the zeros of equations that are regular on it.
#pragma once

#include "analysis/boundaries/boundary.hpp"

#include <Eigen/Core>

#include <complex>
#include <cstddef>
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
CriticalValue critical_value(const ShootingResidual& shooting, std::complex<double> multiplier,
                             const CriticalBorders& borders);

/// ∂g/∂(Z, p) = −p*(∂M)q, kD + 2 long. The second derivatives are central differences of the exact first ones along
/// q, good to 10⁻⁹ or so: they steer, g itself is exact. Cost: 2k steps of the map for a real q, 4k for a complex one.
/// Empty where the map ends beside the cycle.
///   steep_below  see AugmentedSystem
std::optional<Eigen::VectorXcd> gradient_of(const PlaneMap& map, const Eigen::VectorXd& points,
                                            const Eigen::Vector2d& p, const ShootingResidual& shooting,
                                            const CriticalValue& value, double steep_below);

/// Borders from the null vectors at a cycle that has the multiplier, or nearly: their real parts, turned so that these
/// are largest. Without `before` by inverse iteration.
CriticalBorders borders_at(const ShootingResidual& shooting, std::complex<double> multiplier,
                           const std::optional<CriticalBorders>& before = std::nullopt);

/// Unknowns y = (Z, p), equations G(Z; p) = 0 and
///   fold            g(1) = 0
///   flip            g(−1) = 0
///   Neimark–Sacker  with one more unknown c = cos θ, E = O = 0 where for λ = e^{iθ}
///                   E = (g(λ) + g(1/λ))/2,  O = (g(λ) − g(1/λ))/(λ − 1/λ)
/// With real borders g(λ̄) is the conjugate of g(λ), so that E = Re g and O = Im g/sin θ are smooth functions of c, also
/// where |c| > 1 (neutral saddles λ, 1/λ): the curve passes 1:1 and 1:2 as any other point.
struct AugmentedSystem {
    BoundaryKind kind = BoundaryKind::fold;
    PlaneMap map;
    std::size_t period = 1;
    Eigen::Vector2d unit{1, 1};  ///< of the parameters, in the arclength: the plane's widths
    CriticalBorders borders;
    /// Where DF grows as 1/margin (ShootingStep), as towards a vanishing impact, it changes within margin²: below this
    /// margin differences are taken over (margin/steep_below)² of their length. 0: nowhere.
    double steep_below = 0;

    Eigen::Index coordinates() const { return map.dimension * static_cast<Eigen::Index>(period); }
    /// y of a cycle.
    Eigen::VectorXd unknowns(const CyclePoints& points, const Eigen::Vector2d& p,
                             std::complex<double> multiplier) const;
    /// The multiplier that y has.
    std::complex<double> multiplier(const Eigen::VectorXd& y) const;
    /// Of the cycle alone.
    ShootingResidual shooting(const Eigen::VectorXd& y) const;
    /// Of the arclength, s² = |δZ|²/k + Σ δp_j²/unit_j² (+ δc²).
    Eigen::VectorXd weights() const;
};

/// The system's curve; its equations hold a copy of the system.
/// Cost of one evaluation: k steps of the map and 2k (fold, flip) or 4k beside them, LUs of kD + 1 complex unknowns: 2,
/// or 6 for Neimark–Sacker.
CurveProblem problem_of(const AugmentedSystem& system);

}  // namespace swirl::analysis
