#include "apps/studies/scene_map/orbit_by_map.hpp"
#include "apps/studies/scene_map/rounded_dynamics.hpp"
#include "map/orbit/maps_in_quad.hpp"

namespace swirl::studies {

template class SceneOrbit<Quad>;

SWIRL_EVERY_MAP(SWIRL_COMPILE_ROUNDED_DYNAMICS, Quad)

}  // namespace swirl::studies
