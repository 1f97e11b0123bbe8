// The equations of a cycle on a border of the map.
#pragma once

#include "apps/studies/bifurcation_curves/border_curve.hpp"

namespace swirl::studies::bifurcation_curves {

/// Where the unknowns of a cycle of k points in D coordinates stand in y.
struct BorderLayout {
    Eigen::Index dimension, period;

    Eigen::Index parameters() const { return dimension * period; }
    Eigen::Index time(Eigen::Index flight) const { return parameters() + 2 + flight; }
    Eigen::Index touch_time() const { return time(period); }
};

BorderLayout layout_of(const WordMap& map, const BorderCycle& cycle);

/// The parts of the equations. The cycle: k(D + 1) rows, each impact leads to the next point and its vertex is on the
/// wall. What touches: the row after them (and one more of grazing). The approach of the vertex that strikes first, in
/// place of that: g′(τ_1).
void add_cycle(const WordMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at);
void add_touch(const WordMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
               analysis::ShootingResidual& at);
void add_approach(const WordMap& map, const BorderCycle& like, const BorderLayout& layout, const Eigen::VectorXd& y,
                  analysis::ShootingResidual& at);
/// Of both parameters: Newton's method may lead elsewhere.
bool is_in_range(const Plane& plane, const Eigen::Vector2d& p);

analysis::CurveProblem border_problem(const WordMap& map, const Plane& plane, const BorderCycle& like);

/// The cycle with the numbers of y.
BorderCycle border_cycle_at(const WordMap& map, const BorderCycle& like, const Eigen::VectorXd& y);
Eigen::VectorXd unknowns_of(const WordMap& map, const BorderCycle& cycle);

/// D(Fᵏ) on the side on which nothing touches, or on which there is more slip: DF_i = ∂z′ − ∂_τ z′ ∂_z g/g′.
Eigen::MatrixXd monodromy_of(const WordMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

/// Why y, which solves the equations, is no cycle on this border; empty: it is one.
std::string refusal_of(const WordMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

}  // namespace swirl::studies::bifurcation_curves
