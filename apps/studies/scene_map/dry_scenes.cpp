#include "apps/studies/scene_map/dynamics_in_double.hpp"

namespace swirl::studies {

SWIRL_EVERY_MAP(SWIRL_COMPILE_DRY_DYNAMICS, double)

}  // namespace swirl::studies
