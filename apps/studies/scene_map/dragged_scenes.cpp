#include "apps/studies/scene_map/dragged_dynamics.hpp"

#include <memory>

namespace swirl::studies {

template <Shape shape, ImpactRule rule>
std::shared_ptr<const SceneDynamics<section_dimension<shape>>> make_dragged_dynamics(const Scene<double>& scene) {
    return std::make_shared<const DraggedDynamics<shape, rule>>(scene);
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_DRAGGED_DYNAMICS, double)

}  // namespace swirl::studies
