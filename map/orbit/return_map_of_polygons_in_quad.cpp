#include "map/orbit/maps_in_quad.hpp"

namespace swirl {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_RETURN_MAP, Quad)

}  // namespace swirl
