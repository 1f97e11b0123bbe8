#include "apps/studies/scene_map/scene_orbit_functions.hpp"
#include "map/numbers/quad.hpp"

template class swirl::studies::SceneOrbit<swirl::Quad>;
