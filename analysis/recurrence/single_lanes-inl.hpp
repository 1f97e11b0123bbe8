// Rows of a tile in single precision: eight lanes hold the eight rows of one column, sixteen those of two.
//
// Included by the files of kernels alone, once for each instruction set.
#if defined(SWIRL_ANALYSIS_RECURRENCE_SINGLE_LANES_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef SWIRL_ANALYSIS_RECURRENCE_SINGLE_LANES_INL
#undef SWIRL_ANALYSIS_RECURRENCE_SINGLE_LANES_INL
#else
#define SWIRL_ANALYSIS_RECURRENCE_SINGLE_LANES_INL
#endif

#include "analysis/recurrence/tile_kernels.hpp"

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Singles = hn::CappedTag<float, 2 * tile_side>;
using SingleVector = hn::Vec<Singles>;

/// The key with the difference d of coordinate m (metric.hpp), up to rounding: the product and sum are one operation.
template <Norm norm>
HWY_INLINE SingleVector joined_single(std::size_t m, SingleVector key, SingleVector d) {
    if constexpr (norm == Norm::maximum) return m == 0 ? hn::Abs(d) : hn::Max(key, hn::Abs(d));
    if constexpr (norm == Norm::manhattan) return m == 0 ? hn::Abs(d) : hn::Add(key, hn::Abs(d));
    if constexpr (norm == Norm::euclidean) return m == 0 ? hn::Mul(d, d) : hn::MulAdd(d, d, key);
}

/// As many of the eight rows as the lanes hold; sixteen lanes hold them twice.
HWY_INLINE SingleVector eight_rows(const float* rows) {
    const Singles tag;
#if HWY_MAX_BYTES >= 64
    const auto half = hn::LoadU(hn::Half<Singles>(), rows);
    return hn::Combine(tag, half, half);
#else
    return hn::LoadU(tag, rows);
#endif
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
