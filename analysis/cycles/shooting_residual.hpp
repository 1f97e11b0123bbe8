// What a cycle must fulfil: k points, each mapped to the next. G(Z; p) = 0 with Z = (z_1 … z_k).
#pragma once

#include "analysis/cycles/shooting_map.hpp"

#include <vector>

namespace swirl::analysis {

using CyclePoints = std::vector<Eigen::VectorXd>;

/// G_i = F(z_i; p) − z_{i+1}, angles modulo their period (constraints: F alone), and its derivatives.
struct ShootingResidual {
    bool alive = false;               ///< false: the map ended at one of the points
    Eigen::VectorXd gap;              ///< G, of length k D
    Eigen::MatrixXd by_points;        ///< ∂G/∂Z, kD × kD
    Eigen::VectorXd by_parameter;     ///< ∂G/∂p; empty without a parameter
    std::vector<ShootingStep> steps;  ///< the k steps
    double duration = 0;              ///< the cycle's return time
    double integral = 0;              ///< of the map's observable over it
    Eigen::VectorXd rounding;         ///< what the rounding of z and F leaves in each component of G

    double residual() const { return gap.lpNorm<Eigen::Infinity>(); }
};

/// True if |G_i| ≤ `accept` in each component, or what rounding leaves there: 64 ε(Σ_j |∂F_i/∂z_j| max(|z_j|, 1, 1/τ) +
/// |F_i|), since lengths and angles of size 1 make up the map whatever the state is, and an error of ε in them is one
/// of ε/τ in a rate; at most 10⁻⁹(1 + |F_i|), lest a state that the map throws about (u_n → 0) is said to close. No
/// more can be asked of a cycle with large multipliers.
bool closes_to(const ShootingResidual& shooting, double accept);

/// Cost: k steps of the map and (kD)² numbers.
ShootingResidual shooting_residual(const ShootingMap& map, const CyclePoints& points, double p);

/// z and the k − 1 states after it; empty if the map ends before.
CyclePoints orbit_from(const ShootingMap& map, const Eigen::VectorXd& z, double p, int k);

/// DF(z_k) … DF(z_1), for a map without constraints.
Eigen::MatrixXd monodromy(const ShootingResidual& shooting);

/// The word: one letter a step.
std::vector<std::int64_t> word_of(const ShootingResidual& shooting);

Eigen::VectorXd stacked(const CyclePoints& points);
CyclePoints unstacked(const Eigen::VectorXd& z, int dimension);

/// Newton's method for G = 0 with a minimum-norm step, which finds members of a family near the start, until rounding
/// stops it. Returns the residual reached, +∞ if the map ended.
///   goal  stops as soon as the residual is that small
double polish_cycle(const ShootingMap& map, CyclePoints& points, double p, double goal = 0);

}  // namespace swirl::analysis
