#include "analysis/recurrence/column_finder.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

namespace swirl::analysis::recurrence::detail {
namespace {

// Measured (README.md, "Cost"): a candidate costs six times a pair of a near tile, for its bits are scattered one by
// one; to pass over the other tiles costs what 0.012 candidates a row do. Where nothing is sorted, all rows are
// compared in their order, which costs half as much again as the pairs of a tile.
bool tiles_are_cheaper(const SortedRows& sorted, const TiledMatrix& tiled) {
    const double near = near_share(tiled);
    if (sorted.order.empty()) return near < 0.5;
    const double widest = *std::max_element(tiled.bounds.begin(), tiled.bounds.end());
    return candidate_share(sorted, *tiled.columns, widest) > 0.012 + near / 6;
}

// Points at equal distances, as many as tell the share of candidates: to sort all is a twentieth of the work.
Points some_points(const Points& points) {
    constexpr std::size_t most = 8192;
    const std::size_t count = std::min(points.count, most);
    Points some{{}, count, points.dimension, count, points.periods};
    for (int m = 0; m < points.dimension; ++m)
        for (std::size_t k = 0; k < count; ++k) some.values.push_back(points.coordinate(m)[k * points.count / count]);
    return some;
}

}  // namespace

ColumnFinder find_columns(const Points& rows, const Points& columns, Norm norm, std::span<const double> bounds) {
    ColumnFinder finder{&columns, bounds, {}, {}, false};
    if (rows.dimension > 1) {
        finder.tiled = tiled_matrix(rows, columns, norm, bounds);
        const Points some = some_points(rows);
        finder.by_tiles = tiles_are_cheaper(sort_rows(some, norm), finder.tiled);
    }
    if (finder.by_tiles) return finder;
    finder.tiled = {};
    finder.sorted = sort_rows(rows, norm);
    return finder;
}

ColumnSource source_of(const ColumnFinder& finder) {
    if (finder.by_tiles)
        return [&finder, scratch = TileScratch()](std::size_t c, std::size_t offset,
                                                  std::span<std::uint64_t* const> frames) mutable {
            fill_column_by_tiles(finder.tiled, c, offset, frames, scratch);
        };
    return [&finder, scratch = make_scratch(finder.sorted)](std::size_t c, std::size_t offset,
                                                            std::span<std::uint64_t* const> frames) mutable {
        fill_column(finder.sorted, *finder.columns, c, finder.bounds, offset, frames, scratch);
    };
}

}  // namespace swirl::analysis::recurrence::detail
