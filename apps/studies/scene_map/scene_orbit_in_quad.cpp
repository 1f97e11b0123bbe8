#include "apps/studies/scene_map/scene_orbit_functions.hpp"

template class swirl::studies::SceneOrbit<swirl::Quad>;
