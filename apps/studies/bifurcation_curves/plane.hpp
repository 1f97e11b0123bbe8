// A rectangle in the plane of two parameters.
#pragma once

#include "apps/studies/scene_map/parameter_range.hpp"

#include <Eigen/Core>

#include <array>
#include <cstddef>

namespace swirl::studies::bifurcation_curves {

/// Each axis has its parameter.
struct Plane {
    std::array<ParameterRange, 2> axes;

    Parameter parameter(int axis) const { return *axes[static_cast<std::size_t>(axis)].parameter; }
    Eigen::Vector2d low() const { return {axes[0].low, axes[1].low}; }
    Eigen::Vector2d high() const { return {axes[0].high, axes[1].high}; }
};

/// Inside, or on the edge up to roundings (analysis::on_edge).
bool is_in(const Plane& plane, const Eigen::Vector2d& p);

/// The scene with the plane's two parameters at p.
Scene<double> scene_at(const Scene<double>& scene, const Plane& plane, const Eigen::Vector2d& p);

}  // namespace swirl::studies::bifurcation_curves
