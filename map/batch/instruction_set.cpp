#include "map/batch/lane_block.hpp"
#include "map/batch/targets.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "map/batch/instruction_set.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

int lanes_here() {
    return static_cast<int>(hwy::HWY_NAMESPACE::Lanes(hwy::HWY_NAMESPACE::CappedTag<double, block_lanes>()));
}

const char* name_here() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(lanes_here);
HWY_EXPORT(name_here);

int lanes_of_vector() {
    return HWY_DYNAMIC_DISPATCH(lanes_here)();
}
const char* name_of_instruction_set() {
    return HWY_DYNAMIC_DISPATCH(name_here)();
}

}  // namespace swirl::detail
#endif
