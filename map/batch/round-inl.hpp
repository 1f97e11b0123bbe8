// A round: one look at the flight of every lane of a block.
#if defined(SWIRL_MAP_BATCH_ROUND_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_MAP_BATCH_ROUND_INL
#undef SWIRL_MAP_BATCH_ROUND_INL
#else
#define SWIRL_MAP_BATCH_ROUND_INL
#endif

#include "map/batch/polygon-inl.hpp"
#include "map/batch/sampled_disk-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace swirl::detail::HWY_NAMESPACE {

/// By the second search: of a disk whose first has failed.
template <Shape shape, ImpactRule rule, bool from_samples = false>
HWY_INLINE RoundResult look_by(bool sums_chatter, LaneBlock& block) {
    const int lanes = static_cast<int>(hn::Lanes(Tag()));
    RoundResult all_lanes;
    for (int i = 0; i < block_lanes; i += lanes) {
        RoundResult some;
        if constexpr (from_samples)
            some = look_at_sampled_disks<rule>(block, i);
        else if constexpr (shape == Shape::disk)
            some = look_at_disks<rule>(sums_chatter, block, i);
        else
            some = look_at_polygons<rule>(sums_chatter, block, i);
        all_lanes.struck |= some.struck << i;
        all_lanes.left |= some.left << i;
        all_lanes.search_failed |= some.search_failed << i;
    }
    return all_lanes;
}

}  // namespace swirl::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
