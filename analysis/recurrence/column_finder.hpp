// How the columns of a matrix are found: through sorted rows (columns.hpp) or through tiles (tiled_columns.hpp).
#pragma once

#include "analysis/recurrence/columns.hpp"
#include "analysis/recurrence/line_counter.hpp"
#include "analysis/recurrence/tiled_columns.hpp"

#include <span>

namespace swirl::analysis::recurrence::detail {

/// One of the two, prepared; `bounds` and the points must outlive it.
struct ColumnFinder {
    const Points* columns = nullptr;
    std::span<const double> bounds;
    SortedRows sorted;
    TiledMatrix tiled;
    bool by_tiles = false;
};
/// Chooses what is estimated to be cheaper. Cost: O(n log n).
ColumnFinder find_columns(const Points& rows, const Points& columns, Norm norm, std::span<const double> bounds);

/// A source with work space of its own, for one block of columns.
ColumnSource source_of(const ColumnFinder& finder);

}  // namespace swirl::analysis::recurrence::detail
