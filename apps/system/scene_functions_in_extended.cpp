#include "apps/system/rounded_scene.hpp"

namespace swirl::apps {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& extended_functions() {
    return RoundedScene<CollisionMap<long double, shape, rule>>::functions;
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_EXTENDED_FUNCTIONS, double)

}  // namespace swirl::apps
