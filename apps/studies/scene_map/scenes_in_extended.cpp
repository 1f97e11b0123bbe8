#include "apps/studies/scene_map/orbit_by_map.hpp"
#include "apps/studies/scene_map/rounded_dynamics.hpp"

namespace swirl::studies {

template class SceneOrbit<long double>;

SWIRL_EVERY_MAP(SWIRL_COMPILE_ROUNDED_DYNAMICS, long double)

}  // namespace swirl::studies
