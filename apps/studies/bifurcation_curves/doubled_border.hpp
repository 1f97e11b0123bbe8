// The border curve of the doubled cycle, which is born where a cycle on a border has a multiplier −1.
#pragma once

#include "apps/studies/bifurcation_curves/border_cycle.hpp"
#include "apps/studies/bifurcation_curves/plane.hpp"

#include <optional>

namespace swirl::studies::bifurcation_curves {

/// A cycle of twice the period on the same border, beside a cycle there with a multiplier −1: its points and flights
/// are those of the two turns ± ε times the eigenvector, and one of the turns touches, the other stays inside. Newton's
/// method on the equations of the border (border_system.hpp) and that amplitude ε, from 10⁻² down to 10⁻⁴. With μ the
/// distance along the border from the special point, ε² ~ μ (the doubled cycle's square root) and its distance from the
/// border ~ ε: the curve touches the flip curve that ends there.
/// Empty if no such cycle is found on either side.
std::optional<BorderCycle> doubled_on_border(const WordMap& map, const Plane& plane, const BorderCycle& flip);

}  // namespace swirl::studies::bifurcation_curves
