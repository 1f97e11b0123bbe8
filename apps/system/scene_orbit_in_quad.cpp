#include "apps/system/scene_orbit_functions.hpp"

template class swirl::apps::SceneOrbit<swirl::Quad>;
