#include "map/collision_map.hpp"
#include "map/numbers/quad.hpp"

namespace swirl {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_COLLISION_MAP, Quad)

}  // namespace swirl
