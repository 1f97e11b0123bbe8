#include "apps/system/scene_functions_in_double.hpp"

namespace swirl::apps {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_DOUBLE_FUNCTIONS, double)

}  // namespace swirl::apps
