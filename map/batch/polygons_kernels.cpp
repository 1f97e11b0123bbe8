// The kernels of polygons for all instruction sets, one for each impact rule. Highway reads this file once for each
// set.
#include "map/batch/lane_block.hpp"
#include "map/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "map/batch/polygons_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "map/batch/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

RoundResult frictionless_polygons(bool sums_chatter, LaneBlock& block) {
    return look_by<Shape::polygon, ImpactRule::frictionless>(sums_chatter, block);
}

RoundResult poisson_polygons(bool sums_chatter, LaneBlock& block) {
    return look_by<Shape::polygon, ImpactRule::poisson>(sums_chatter, block);
}

RoundResult newton_polygons(bool sums_chatter, LaneBlock& block) {
    return look_by<Shape::polygon, ImpactRule::newton>(sums_chatter, block);
}

RoundResult stronge_polygons(bool sums_chatter, LaneBlock& block) {
    return look_by<Shape::polygon, ImpactRule::stronge>(sums_chatter, block);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(frictionless_polygons);
HWY_EXPORT(poisson_polygons);
HWY_EXPORT(newton_polygons);
HWY_EXPORT(stronge_polygons);

RoundResult advance_frictionless_polygons(bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(frictionless_polygons)(sums_chatter, block);
}

RoundResult advance_poisson_polygons(bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(poisson_polygons)(sums_chatter, block);
}

RoundResult advance_newton_polygons(bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(newton_polygons)(sums_chatter, block);
}

RoundResult advance_stronge_polygons(bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(stronge_polygons)(sums_chatter, block);
}

}  // namespace swirl::detail
#endif
