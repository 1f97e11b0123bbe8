// Counts of pairs by distance, without lines: what rates and order statistics need.
#pragma once

#include "analysis/recurrence/metric.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// Ordered pairs (i, j), i = j included, with |x_i - x_j| (wrapped if period > 0) <= bound; `sorted` ascending.
/// Two pointers on either side of each value; the very comparison of metric.hpp. Cost: O(n).
std::uint64_t count_sorted_pairs(std::span<const double> sorted, double period, double bound);

/// Unordered pairs with j - i >= gap rows (gap >= 1; Points::row_numbers) whose key is <= bounds[k], for each k. Cost:
/// n^2/2 distances.
std::vector<std::uint64_t> count_pairs(const Points& points, Norm norm, std::size_t gap,
                                       std::span<const double> bounds);

/// The `rank`-th smallest key (rank = 1, 2, ...) of the unordered pairs with j - i >= gap. Memory O(n).
/// Narrows an interval of doubles, as integers, 16 bits at a pass; a sample of the points gives the first interval.
/// Cost: about three passes over n^2/2 distances.
double select_key(const Points& points, Norm norm, std::size_t gap, std::uint64_t rank);

}  // namespace swirl::analysis::recurrence::detail
