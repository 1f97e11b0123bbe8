#include "apps/studies/scene_map/rounded_scene.hpp"

namespace swirl::studies {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& extended_functions() {
    return RoundedScene<CollisionMap<long double, shape, rule>>::functions;
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_EXTENDED_FUNCTIONS, double)

}  // namespace swirl::studies
