// The maps in 113 bits, compiled once. Apart from the others, since the number's own headers are longer than the map's.
#pragma once

#include "map/numbers/quad.hpp"
#include "map/orbit/return_map.hpp"

namespace swirl {

SWIRL_EVERY_MAP(SWIRL_DECLARE_COLLISION_MAP, Quad)
SWIRL_EVERY_MAP(SWIRL_DECLARE_RETURN_MAP, Quad)

}  // namespace swirl
