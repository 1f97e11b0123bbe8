// Where a body is at any moment of a flight over a floor with dry friction.
#pragma once

#include "map/model/scene.hpp"
#include "map/orbit/bent_flight.hpp"

namespace swirl {

/// The flights of a scene; nothing without dry friction, where they are straight or in closed form. Places later than a
/// flight lasts are not asked for; each costs a step of the integration.
BendFlight dry_paths(const Scene<double>& scene);

}  // namespace swirl
