#include "map/batch/lane_block.hpp"
#include "map/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "map/batch/poisson_polygon_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "map/batch/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

RoundResult advance_poisson_polygons_here(const KernelKind& kind, LaneBlock& block) {
    return look_by<Shape::polygon, ImpactRule::poisson>(kind.sums_chatter, block);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(advance_poisson_polygons_here);

RoundResult advance_poisson_polygons(const KernelKind& kind, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(advance_poisson_polygons_here)(kind, block);
}

}  // namespace swirl::detail
#endif
