#include "apps/studies/scene_map/dynamics_in_double.hpp"
#include "apps/studies/scene_map/orbit_by_map.hpp"

#include <memory>

namespace swirl::studies {

template class SceneOrbit<double>;

template <Shape shape, ImpactRule rule>
std::shared_ptr<const SceneDynamics<section_dimension<shape>>> make_dynamics_in_double(const Scene<double>& scene) {
    return std::make_shared<const DynamicsInDouble<shape, rule>>(scene);
}

SWIRL_EVERY_MAP(SWIRL_COMPILE_DYNAMICS_IN_DOUBLE, double)

}  // namespace swirl::studies
