// Vertical lines of scalar series in O(n log n), without visiting the recurrence points.
//
// Taken in the order of their values, two consecutive columns of the recurrence matrix differ by the few rows that
// enter or leave the interval [y - threshold, y + threshold]: over all columns every row enters once and leaves once.
// A row that enters or leaves changes only the lines next to it, so the histogram of one column follows from that of
// the last in O(log n). A change made before column t of T counts in all T - t columns from there on.
#pragma once

#include "analysis/recurrence/columns.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

struct VerticalCounts {
    std::vector<std::uint64_t> lines, times;
    std::uint64_t points = 0, points_outside = 0;
};

/// Whether vertical lines can be counted this way: one plain coordinate, and a Theiler window so narrow that taking its
/// rows out of each column and putting them back costs less than scanning the column.
bool can_slide(const Points& rows, int theiler);

/// `column_order`: the columns by rising value. Cost: O((n + columns (1 + W)) log n), memory O(n).
VerticalCounts count_vertical_sliding(const SortedRows& rows, const Points& columns,
                                      std::span<const std::uint32_t> column_order, double bound, int theiler,
                                      const Settings& settings);

}  // namespace swirl::analysis::recurrence::detail
