// The equations of a cycle on a border of the map.
#pragma once

#include "apps/boundaries/border_curve.hpp"

namespace swirl::apps::boundaries {

/// Where the unknowns of a cycle of k points in D coordinates stand in y.
struct BorderLayout {
    Eigen::Index dimension, period;

    Eigen::Index parameters() const { return dimension * period; }
    Eigen::Index time(Eigen::Index flight) const { return parameters() + 2 + flight; }
    Eigen::Index touch_time() const { return time(period); }
};

BorderLayout layout_of(const WordMap& map, const BorderCycle& cycle);

analysis::ArcSystem border_system(const WordMap& map, const Plane& plane, const BorderCycle& like);

Eigen::VectorXd unknowns_of(const WordMap& map, const BorderCycle& cycle);

/// D(Fᵏ) on the side on which nothing touches, or on which there is more slip: DF_i = ∂z′ − ∂_τ z′ ∂_z g/g′.
Eigen::MatrixXd monodromy_of(const WordMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

/// Why y, which solves the equations, is no cycle on this border; empty: it is one.
std::string refusal_of(const WordMap& map, const BorderCycle& like, const Eigen::VectorXd& y);

}  // namespace swirl::apps::boundaries
