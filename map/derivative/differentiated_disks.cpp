#include "map/derivative/derivative.hpp"

namespace swirl {

SWIRL_EVERY_DISK_MAP(SWIRL_COMPILE_DERIVATIVE, double)

}  // namespace swirl
