// Fold, flip and Neimark–Sacker curves of a scene's cycles.
#pragma once

#include "analysis/section_map.hpp"
#include "apps/studies/bifurcation_curves/curves.hpp"

#include <optional>
#include <string>

namespace swirl::studies::bifurcation_curves {

/// The kind of a name; empty for a border's.
std::optional<analysis::BoundaryKind> smooth_kind(const std::string& name);

/// With normal forms in 113 bits at special points, and names of borders.
analysis::BoundaryOptions smooth_options(const Scene<double>& scene, const Plane& plane, double longest_step,
                                         const analysis::Stop& stop);

/// `map`: any of the scene's, for its coordinates.
Curve curve_of(const analysis::Boundary& boundary, const analysis::ShootingMap& map);

}  // namespace swirl::studies::bifurcation_curves
