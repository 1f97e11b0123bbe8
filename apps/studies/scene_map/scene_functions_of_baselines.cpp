#include "apps/studies/scene_map/rounded_scene.hpp"

namespace swirl::studies {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& baseline_functions() {
    return RoundedScene<BaselineMap<shape, rule>>::functions;
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_BASELINE_FUNCTIONS, double)

}  // namespace swirl::studies
