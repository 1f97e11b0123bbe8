// A map with two parameters as the continuation of boundaries sees it: sizes known at run time.
#pragma once

#include "analysis/cycles/shooting_residual.hpp"
#include "analysis/special_values.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

namespace swirl::analysis {

/// F(z; p), p = (p₁, p₂), with its exact first derivatives.
struct PlaneStep {
    bool alive = false;             ///< false: the map ends here; nothing else is meaningful then
    Eigen::VectorXd state;          ///< F(z; p)
    Eigen::MatrixXd by_state;       ///< ∂F/∂z, D × D
    Eigen::MatrixXd by_parameters;  ///< ∂F/∂p, D × 2
    std::int64_t letter = 0;        ///< which smooth branch of the map was taken
    double duration = 1;            ///< time that the step took
    double margin = infinity;       ///< ShootingStep::margin
};

/// z ↦ F(z; p).
struct PlaneMap {
    int dimension = 0;
    std::vector<double> angle_periods;  ///< per coordinate; 0: a plain number
    double least_margin = 0;            ///< ShootingMap::least_margin
    std::function<PlaneStep(const Eigen::VectorXd& z, const Eigen::Vector2d& p)> step;
};

/// What k points leave open, G_i = F(z_i; p) − z_{i+1}, angles modulo their period.
struct PlaneShooting {
    bool alive = false;              ///< false: the map ended at one of the points
    Eigen::VectorXd gap;             ///< G, of length kD
    Eigen::MatrixXd by_unknowns;     ///< ∂G/∂(Z, p), kD × (kD + 2)
    std::vector<PlaneStep> steps;    ///< the k steps
    std::vector<std::int64_t> word;  ///< their letters
};

/// Cost: k steps of the map.
PlaneShooting plane_shooting(const PlaneMap& map, const Eigen::VectorXd& stacked_points, const Eigen::Vector2d& p);

/// A(z₁) = D(Fᵏ) = DF(z_k) … DF(z₁).
Eigen::MatrixXd monodromy(const PlaneShooting& shooting);

/// The map on the line through p along parameter `axis` (0 or 1), for solvers of one parameter.
ShootingMap on_line(const PlaneMap& map, int axis, const Eigen::Vector2d& p);

}  // namespace swirl::analysis
