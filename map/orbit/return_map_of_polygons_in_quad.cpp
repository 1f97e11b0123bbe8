#include "map/numbers/quad.hpp"
#include "map/orbit/return_map.hpp"

namespace swirl {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_RETURN_MAP, Quad)

}  // namespace swirl
