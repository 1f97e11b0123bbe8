// Where a body is at any moment over a floor with dry friction.
#pragma once

#include "map/model/scene.hpp"
#include "map/orbit/bent_flight.hpp"

namespace swirl {

/// The flights and contacts of a scene; nothing without dry friction. Places later than a flight lasts are
/// not asked for; each costs a step of the integration.
BentPaths dry_paths(const Scene<double>& scene);

}  // namespace swirl
