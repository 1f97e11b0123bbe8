#include "map/batch/lane_block.hpp"

// Vectors must be members of a struct here; those whose length is known at run time only can't be. SSSE3 has nothing
// that SSE2 and SSE4 have not, for doubles.
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV | HWY_SSSE3 | HWY_AVX3_DL)
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "map/batch/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "map/batch/disk-inl.hpp"
#include "map/batch/polygon-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

template <Shape shape, ImpactRule rule, bool sums_chatter>
RoundResult look_at_all(LaneBlock& block) {
    const int lanes = static_cast<int>(hn::Lanes(Tag()));
    RoundResult all_lanes;
    for (int i = 0; i < block_lanes; i += lanes) {
        RoundResult some;
        if constexpr (shape == Shape::disk)
            some = look_at_disks<rule, sums_chatter>(block, i);
        else
            some = look_at_polygons<rule, sums_chatter>(block, i);
        all_lanes.struck |= some.struck << i;
        all_lanes.left |= some.left << i;
    }
    return all_lanes;
}

template <Shape shape, ImpactRule rule>
RoundResult look_by(bool sums_chatter, LaneBlock& block) {
    return sums_chatter ? look_at_all<shape, rule, true>(block) : look_at_all<shape, rule, false>(block);
}

RoundResult advance_block(const KernelKind& kind, LaneBlock& block) {
    const bool chatter = kind.sums_chatter;
    if (kind.shape == Shape::disk)  // with friction its laws coincide
        return kind.rule == ImpactRule::frictionless ? look_by<Shape::disk, ImpactRule::frictionless>(chatter, block)
                                                     : look_by<Shape::disk, ImpactRule::poisson>(chatter, block);
    switch (kind.rule) {
        case ImpactRule::frictionless:
            return look_by<Shape::polygon, ImpactRule::frictionless>(chatter, block);
        case ImpactRule::newton:
            return look_by<Shape::polygon, ImpactRule::newton>(chatter, block);
        case ImpactRule::stronge:
            return look_by<Shape::polygon, ImpactRule::stronge>(chatter, block);
        case ImpactRule::poisson:
            break;
    }
    return look_by<Shape::polygon, ImpactRule::poisson>(chatter, block);
}

int vector_lanes() {
    return static_cast<int>(hn::Lanes(Tag()));
}

const char* instruction_set() {
    return hwy::TargetName(HWY_TARGET);
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::detail {

HWY_EXPORT(advance_block);
HWY_EXPORT(vector_lanes);
HWY_EXPORT(instruction_set);

RoundResult advance_lanes(const KernelKind& kind, LaneBlock& block) {
    return HWY_DYNAMIC_DISPATCH(advance_block)(kind, block);
}
int lanes_of_vector() {
    return HWY_DYNAMIC_DISPATCH(vector_lanes)();
}
const char* name_of_instruction_set() {
    return HWY_DYNAMIC_DISPATCH(instruction_set)();
}

}  // namespace swirl::detail
#endif
