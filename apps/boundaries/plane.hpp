// --plane NAME=A:B twice: the plane of two parameters.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/parameter_range.hpp"

#include <Eigen/Core>

#include <array>
#include <string>
#include <vector>

namespace swirl::apps::boundaries {

struct Plane {
    std::array<ParameterRange, 2> axes;

    Parameter parameter(int axis) const { return *axes[static_cast<std::size_t>(axis)].parameter; }
    Eigen::Vector2d low() const { return {axes[0].low, axes[1].low}; }
    Eigen::Vector2d high() const { return {axes[0].high, axes[1].high}; }
};

/// @throws BadInput unless there are two ranges of different parameters
Plane plane_from(const std::vector<std::string>& texts);

Scene<double> scene_at(const Scene<double>& scene, const Plane& plane, const Eigen::Vector2d& p);

/// A scene of the plane: what the plane itself says is needed neither from flags nor from a file.
/// @throws BadInput, or std::invalid_argument if a corner of the plane is out of range
Scene<double> scene_of(SceneOptions options, const Plane& plane);

/// The scene's parameters but the plane's.
Settings scene_settings_of(const Scene<double>& scene, const Plane& plane);

}  // namespace swirl::apps::boundaries
