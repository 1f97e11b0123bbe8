#include "map/derivative/derivative.hpp"

namespace swirl {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_DERIVATIVE, double)

}  // namespace swirl
