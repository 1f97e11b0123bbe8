#include "apps/system/scene_functions.hpp"

namespace swirl::apps {

template <ImpactRule rule>
const SceneFunctions<polygon_dimension>& polygon_functions() {
    return ConcreteScene<Shape::polygon, rule>::functions;
}

template const SceneFunctions<polygon_dimension>& polygon_functions<ImpactRule::frictionless>();
template const SceneFunctions<polygon_dimension>& polygon_functions<ImpactRule::poisson>();
template const SceneFunctions<polygon_dimension>& polygon_functions<ImpactRule::newton>();
template const SceneFunctions<polygon_dimension>& polygon_functions<ImpactRule::stronge>();

}  // namespace swirl::apps
