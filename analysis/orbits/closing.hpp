// What a cycle must fulfil: k points, each mapped to the next. G(Z; p) = 0 with Z = (z_1 … z_k).
#pragma once

#include "analysis/orbits/shooting_map.hpp"

#include <vector>

namespace swirl::analysis {

using CyclePoints = std::vector<Eigen::VectorXd>;

/// G_i = F(z_i; p) − z_{i+1}, angles modulo their period (constraints: F alone), and its derivatives.
struct Closing {
    bool alive = false;               ///< false: the map ended at one of the points
    Eigen::VectorXd gap;              ///< G, of length k D
    Eigen::MatrixXd by_points;        ///< ∂G/∂Z, kD × kD
    Eigen::VectorXd by_parameter;     ///< ∂G/∂p; empty without a parameter
    std::vector<ShootingStep> steps;  ///< the k steps
    double duration = 0;              ///< the cycle's return time
    double integral = 0;              ///< of the map's observable over it

    double residual() const { return gap.lpNorm<Eigen::Infinity>(); }
};

/// What the rounding of z alone leaves in G, 8 ε‖DF‖: no more can be asked of a cycle with large multipliers.
double rounding_of(const Closing& closing);

/// Cost: k steps of the map and (kD)² numbers.
Closing close_cycle(const ShootingMap& map, const CyclePoints& points, double p);

/// z and the k − 1 states after it; empty if the map ends before.
CyclePoints orbit_from(const ShootingMap& map, const Eigen::VectorXd& z, double p, int k);

/// DF(z_k) … DF(z_1), for a map without constraints.
Eigen::MatrixXd monodromy(const Closing& closing);

/// The word: one letter a step.
std::vector<std::int64_t> word_of(const Closing& closing);

Eigen::VectorXd stacked(const CyclePoints& points);
CyclePoints unstacked(const Eigen::VectorXd& z, int dimension);

/// Newton's method for G = 0 with a minimum-norm step, which finds members of a family near the start, until rounding
/// stops it. Returns the residual reached, +∞ if the map ended.
///   goal  stops as soon as the residual is that small
double polish_cycle(const ShootingMap& map, CyclePoints& points, double p, double goal = 0);

}  // namespace swirl::analysis
