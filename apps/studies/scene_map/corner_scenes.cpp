#include "apps/studies/scene_map/dynamics_in_double.hpp"

namespace swirl::studies {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_CORNER_DYNAMICS, double)

}  // namespace swirl::studies
