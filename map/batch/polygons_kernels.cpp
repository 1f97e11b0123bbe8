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

RoundResult polygons(ImpactRule rule, bool sums_chatter, LaneBlock& block) {
    switch (rule) {
        case ImpactRule::frictionless:
            return look_by<Shape::polygon, ImpactRule::frictionless>(sums_chatter, block);
        case ImpactRule::newton:
            return look_by<Shape::polygon, ImpactRule::newton>(sums_chatter, block);
        case ImpactRule::stronge:
            return look_by<Shape::polygon, ImpactRule::stronge>(sums_chatter, block);
        case ImpactRule::poisson:
            break;
    }
    return look_by<Shape::polygon, ImpactRule::poisson>(sums_chatter, block);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(polygons);

RoundResult advance_polygons(ImpactRule rule, bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(polygons)(rule, sums_chatter, block);
}

}  // namespace swirl::detail
#endif
