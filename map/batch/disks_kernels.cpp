// The kernels of disks for all instruction sets, with and without friction. Highway reads this file once for each set.
#include "map/batch/lane_block.hpp"
#include "map/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "map/batch/disks_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "map/batch/round-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

RoundResult disks(ImpactRule rule, bool sums_chatter, LaneBlock& block) {
    if (rule == ImpactRule::frictionless) return look_by<Shape::disk, ImpactRule::frictionless>(sums_chatter, block);
    return look_by<Shape::disk, ImpactRule::poisson>(sums_chatter, block);
}

RoundResult sampled_disks(ImpactRule rule, LaneBlock& block) {
    if (rule == ImpactRule::frictionless) return look_by<Shape::disk, ImpactRule::frictionless, true>(false, block);
    return look_by<Shape::disk, ImpactRule::poisson, true>(false, block);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(disks);
HWY_EXPORT(sampled_disks);

RoundResult advance_disks(ImpactRule rule, bool sums_chatter, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(disks)(rule, sums_chatter, block);
}

RoundResult advance_sampled_disks(ImpactRule rule, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(sampled_disks)(rule, block);
}

}  // namespace swirl::detail
#endif
