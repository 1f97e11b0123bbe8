// Of a map in double itself: compiled by the two files that list the maps.
#pragma once

#include "apps/studies/scene_map/scene_functions.hpp"

namespace swirl::studies {

template <Shape shape, ImpactRule rule>
const SceneFunctions<section_dimension<shape>>& double_functions() {
    return ConcreteScene<shape, rule>::functions;
}

}  // namespace swirl::studies
