#include "apps/studies/scene_map/rounded_scene.hpp"
#include "map/numbers/quad.hpp"

namespace swirl::studies {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& quad_functions() {
    return RoundedScene<CollisionMap<Quad, shape, rule>>::functions;
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_QUAD_FUNCTIONS, double)

}  // namespace swirl::studies
