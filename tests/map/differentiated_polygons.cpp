#include "tests/map/differentiated_map.hpp"

namespace swirl::tests {

SWIRL_EVERY_POLYGON_MAP(SWIRL_COMPILE_DERIVATIVE, double)

}  // namespace swirl::tests
