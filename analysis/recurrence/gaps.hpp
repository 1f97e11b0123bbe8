// Rows and columns of a recurrence matrix that no point is at: where they lie, and a source that leaves them empty.
#pragma once

#include "analysis/recurrence/line_counter.hpp"
#include "analysis/recurrence/metric.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// Points that follow each other without a gap.
struct PointRun {
    std::size_t point, row, count;
};

/// Which rows, or columns, of a matrix have a point.
struct Presence {
    static constexpr std::uint32_t none = static_cast<std::uint32_t>(-1);
    std::vector<PointRun> runs;
    std::vector<std::uint32_t> point_at;  ///< of each row; none: a gap

    explicit Presence(const Points& points);
    bool has(std::size_t row) const { return row < point_at.size() && point_at[row] != none; }
    /// There is no point before this one, or after it.
    bool begins_at(std::size_t row) const { return row == 0 || !has(row - 1); }
    bool ends_at(std::size_t row) const { return !has(row + 1); }
};

/// Of the rows and the columns of one matrix.
struct Presences {
    Presence rows, columns;
};

/// What `inner` finds of points among themselves, put where their rows and columns are. Cost: that of `inner`, and
/// O(n / 64 + gaps) a column. `presences` must outlive it; `points`: how many rows `inner` knows.
ColumnSource with_gaps(ColumnSource inner, const Presences& presences, std::size_t points, std::size_t thresholds);

/// For k = 0 … min(rows, columns) − 1: pairs of a row and a column that both have a point and are k apart, within the
/// largest square. Cost: O(n²/64).
std::vector<std::uint64_t> pairs_by_distance(const Presences& presences);

/// Pairs of a row and a column that both have a point and are less than `window` apart, of the whole matrix.
std::uint64_t pairs_within(const Presences& presences, std::size_t window);

/// Bits from … from + count − 1 of `source` are added to those of `target` from bit `to` on.
void copy_bits(const std::uint64_t* source, std::size_t from, std::size_t count, std::uint64_t* target, std::size_t to);

}  // namespace swirl::analysis::recurrence::detail
