// Records that curves begin at or are compared with.
#pragma once

#include "apps/boundaries/plane_options.hpp"
#include "apps/studies/bifurcation_curves/against.hpp"
#include "apps/studies/bifurcation_curves/starting_points.hpp"

#include <string>
#include <vector>

namespace swirl::apps::boundaries {

/// The special points in a record of `continue` or `bifurcate --branches` along a parameter of the plane; of one of
/// `boundaries` a cycle in the middle of each curve.
/// @throws BadInput if it is none, or of another scene
std::vector<StartingPoint> starting_points_of_record(const std::string& file, const Scene<double>& scene,
                                                     const Plane& plane);

/// The runs of a sweep's record over the plane.
/// @throws BadInput if it is no sweep over these two parameters alone, or of another scene
MappedPlane mapped_plane(const std::string& file, const Scene<double>& scene, const Plane& plane);

}  // namespace swirl::apps::boundaries
