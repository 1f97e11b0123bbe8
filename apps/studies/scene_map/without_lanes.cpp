#include "apps/studies/scene_map/lanes.hpp"

#include <span>

namespace swirl::studies {

bool has_lanes() {
    return false;
}

template <Shape shape, ImpactRule rule>
void follow_together(std::span<LaneOrbit<section_dimension<shape>>>) {}

SWIRL_EVERY_MAP(SWIRL_COMPILE_LANES, double)

}  // namespace swirl::studies
