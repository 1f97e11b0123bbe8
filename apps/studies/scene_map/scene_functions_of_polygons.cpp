#include "apps/studies/scene_map/scene_functions_in_double.hpp"

namespace swirl::studies {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_DOUBLE_FUNCTIONS, double)

}  // namespace swirl::studies
