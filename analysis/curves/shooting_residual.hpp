// What a cycle must fulfil: k points, each mapped to the next. G(Z; p) = 0 with Z = (z_1 … z_k).
#pragma once

#include "analysis/curves/shooting_map.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace swirl::analysis {

using CyclePoints = std::vector<Eigen::VectorXd>;

/// H(y) and ∂H/∂y at one y = (Z, parameters, …): G_i = F(z_i; p) − z_{i+1}, angles modulo their period (constraints: F
/// alone), and what else is asked of a cycle (that it has a multiplier 1, that a vertex touches).
struct ShootingResidual {
    bool alive = false;                   ///< false: the map ended at one of the points
    Eigen::VectorXd gap;                  ///< H; its first kD components are G
    Eigen::MatrixXd jacobian;             ///< ∂H/∂y
    std::vector<std::int64_t> itinerary;  ///< the letters of the steps: which smooth branch of the map was taken
    Eigen::VectorXd rounding;  ///< what the rounding of z and F leaves in each component of H; empty: not known

    /// Of k points of one map; zero and empty for other equations.
    std::size_t period = 0;           ///< k
    int dimension = 0;                ///< D
    std::vector<ShootingStep> steps;  ///< the k steps
    double duration = 0;              ///< the cycle's return time
    double integral = 0;              ///< of the map's observable over it

    double residual() const { return gap.lpNorm<Eigen::Infinity>(); }
    Eigen::Index coordinates() const { return static_cast<Eigen::Index>(period) * dimension; }
    /// ∂G/∂Z, kD × kD.
    Eigen::MatrixXd by_points() const { return jacobian.leftCols(coordinates()); }
};

/// H and ∂H/∂y as a function of y. The Jacobian steers Newton's method and gives tangents; H alone says where solutions
/// are.
using Equations = std::function<ShootingResidual(const Eigen::VectorXd& y)>;

/// True if |G_i| ≤ `accept` in each component, or what rounding leaves there: 64 ε(Σ_j |∂F_i/∂z_j| max(|z_j|, 1, 1/τ) +
/// |F_i|), since lengths and angles of size 1 make up the map whatever the state is, and an error of ε in them is one
/// of ε/τ in a rate; at most 10⁻⁹(1 + |F_i|), lest a state that the map throws about (u_n → 0) is said to close. No
/// more can be asked of a cycle with large multipliers.
bool closes_to(const ShootingResidual& shooting, double accept);

/// G and ∂G/∂(Z, p). Cost: k steps of the map and (kD)² numbers.
ShootingResidual shooting_residual(const ShootingMap& map, const CyclePoints& points, double p);
/// y = (Z, p), or Z at p for a map without a parameter; by the map's `step`, or by its `step_from_surface`.
ShootingResidual shooting_residual(const ShootingMap& map, const decltype(ShootingMap::step)& step,
                                   const Eigen::VectorXd& y, double p);
ShootingResidual shooting_residual(const PlaneMap& map, const Eigen::VectorXd& stacked_points,
                                   const Eigen::Vector2d& p);

/// z and the k − 1 states after it; empty if the map ends before.
CyclePoints orbit_from(const ShootingMap& map, const Eigen::VectorXd& z, double p, int k);

/// A(z₁) = D(Fᵏ) = DF(z_k) … DF(z_1), for a map without constraints.
Eigen::MatrixXd monodromy(const ShootingResidual& shooting);

Eigen::VectorXd stacked(const CyclePoints& points);
CyclePoints unstacked(const Eigen::VectorXd& z, int dimension);

/// Newton's method for G = 0 with a minimum-norm step, which finds members of a family near the start, until rounding
/// stops it. Returns the residual reached, +∞ if the map ended.
///   goal  stops as soon as the residual is that small
double polish_cycle(const ShootingMap& map, CyclePoints& points, double p, double goal = 0);

}  // namespace swirl::analysis
