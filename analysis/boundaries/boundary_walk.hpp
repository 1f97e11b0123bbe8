// One way along a boundary.
#pragma once

#include "analysis/boundaries/codimension_two.hpp"

namespace swirl::analysis {

/// From `start`, a point of the system's curve, in the direction of its tangent. The first point is `start` itself.
void walk_boundary(AugmentedSystem system, const ArcPoint& start, const BoundaryOptions& options, Boundary& boundary);

/// Smallest distance, over cyclic shifts, of two points of a curve's unknowns in its arclength; angles as angles.
///   turned  if given: b's unknowns, shifted and with whole turns added, so that they lie nearest to a's
///   tangent  if given: a direction at b, shifted likewise
double distance_between(const AugmentedSystem& system, const Eigen::VectorXd& a, const Eigen::VectorXd& b,
                        Eigen::VectorXd* turned = nullptr, Eigen::VectorXd* tangent = nullptr);

/// y with the angles of its points in (−π, π].
Eigen::VectorXd normalised(const AugmentedSystem& system, const Eigen::VectorXd& y);

}  // namespace swirl::analysis
