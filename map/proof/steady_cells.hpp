// The fixed points of a polygon over cells of two of its scene's numbers, by the equations of steady_in_balls.hpp:
// README.md, "Cells".
#pragma once

#include "map/cells/plane_piece.hpp"
#include "map/model/parameter.hpp"
#include "map/model/scene.hpp"

#include <array>
#include <functional>

namespace swirl::proof {

/// A polygon with friction and swirl and e < 1, for all of the plane.
struct PlaneScene {
    Scene<double> base;
    std::array<Parameter, 2> parameters{};
    double max_time = 0;  ///< of a flight
};

/// Halves a piece of the plane until its parts are proven or at the limits (map/cells/plane_search.hpp).
///   stop  true: end; what is left is not looked at
cells::PlanePiece proven_piece(const PlaneScene& scene, const cells::ParameterCell& piece,
                               const cells::PlaneLimits& limits, const std::function<bool()>& stop);

}  // namespace swirl::proof
