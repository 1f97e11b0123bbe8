// --plane NAME=A:B twice: the plane of two parameters, and the scene that lies in it.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/studies/bifurcation_curves/plane.hpp"

#include <string>
#include <vector>

namespace swirl::apps::boundaries {

using namespace studies::bifurcation_curves;

/// @throws BadInput unless there are two ranges of different parameters
Plane plane_from(const std::vector<std::string>& texts);

/// A scene of the plane: what the plane itself says is needed neither from flags nor from a file.
/// @throws BadInput, or std::invalid_argument if a corner of the plane is out of range
Scene<double> scene_of(SceneOptions options, const Plane& plane);

/// The scene's parameters but the plane's.
Settings scene_settings_of(const Scene<double>& scene, const Plane& plane);

}  // namespace swirl::apps::boundaries
