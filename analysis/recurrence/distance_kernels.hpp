// The inner loops over distances, compiled for several instruction sets and chosen at run time (Highway). Single IEEE
// operations in a fixed order, no fused ones: the keys are the same bits on all of them.
#pragma once

#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <cstdint>

namespace swirl::analysis::recurrence::detail {

/// Distances are computed in chunks of this many points.
constexpr std::size_t chunk_size = 1024;

/// One point against the points begin ... begin + count - 1 of coordinate arrays: their keys (metric.hpp).
struct KeyTask {
    const double* const* coordinates;  ///< `dimension` arrays
    const double* centre;              ///< the point, `dimension` values
    const double* periods;             ///< `dimension` values, 0: not an angle
    int dimension;
    Norm norm;
};
void compute_keys(const KeyTask& task, std::size_t begin, std::size_t count, double* keys);

/// Bit t of `words` = (keys[t] <= bound), bits from `count` to the end of the last word 0: (count + 63) / 64 words.
/// Reads keys up to the next multiple of 64: a buffer of chunk_size has room for that.
void mask_keys(const double* keys, std::size_t count, double bound, std::uint64_t* words);

/// How many of the keys are <= bound. Reads like mask_keys.
std::size_t count_keys(const double* keys, std::size_t count, double bound);

}  // namespace swirl::analysis::recurrence::detail
