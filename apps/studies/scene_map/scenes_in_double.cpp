#include "apps/studies/scene_map/dynamics_in_double.hpp"
#include "apps/studies/scene_map/orbit_by_map.hpp"

namespace swirl::studies {

template class SceneOrbit<double>;

SWIRL_EVERY_MAP(SWIRL_COMPILE_DYNAMICS_IN_DOUBLE, double)

}  // namespace swirl::studies
