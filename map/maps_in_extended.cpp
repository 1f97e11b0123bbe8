#include "map/collision_map.hpp"

namespace swirl {

SWIRL_EVERY_MAP(SWIRL_COMPILE_COLLISION_MAP, long double)

}  // namespace swirl
