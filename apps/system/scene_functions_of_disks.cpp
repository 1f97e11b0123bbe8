#include "apps/system/scene_functions.hpp"

namespace swirl::apps {

template <ImpactRule rule>
const SceneFunctions<disk_dimension>& disk_functions() {
    return ConcreteScene<Shape::disk, rule>::functions;
}

template const SceneFunctions<disk_dimension>& disk_functions<ImpactRule::frictionless>();
template const SceneFunctions<disk_dimension>& disk_functions<ImpactRule::poisson>();

}  // namespace swirl::apps
