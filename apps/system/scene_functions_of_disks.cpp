#include "apps/system/scene_functions.hpp"

namespace swirl::apps {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& double_functions() {
    return ConcreteScene<shape, rule>::functions;
}

SWIRL_EVERY_DISK_MAP(SWIRL_COMPILE_DOUBLE_FUNCTIONS, double)

}  // namespace swirl::apps
