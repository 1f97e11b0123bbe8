#include "map/orbit/return_map.hpp"

namespace swirl {

SWIRL_EVERY_MAP(SWIRL_COMPILE_RETURN_MAP, long double)

}  // namespace swirl
