// Columns of the recurrence matrix of a smooth trajectory. Points that follow one another lie close together: eight
// rows against eight columns, a tile, are passed over together where the boxes around them are farther apart than the
// bound, and compared pair by pair where not; in single precision first, which decides all pairs but those at the
// bound.
#pragma once

#include "analysis/recurrence/metric.hpp"
#include "analysis/recurrence/tile_kernels.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// The matrix whose tiles are compared, and what is prepared once for all threads.
struct TiledMatrix {
    const Points* rows = nullptr;
    const Points* columns = nullptr;
    Norm norm = Norm::euclidean;
    std::span<const double> bounds;                   ///< key bounds (metric.hpp)
    std::size_t blocks = 0;                           ///< of eight rows each, the last of what is left
    std::vector<std::vector<double>> least, largest;  ///< their boxes, [coordinate][block], up to a multiple of 64
    std::vector<float> single_rows;                   ///< rows->values, rounded; empty where single precision is no use
    std::vector<SingleBound> single_bounds;           ///< one per bound, or none
};
/// Cost: O(n dimension).
TiledMatrix tiled_matrix(const Points& rows, const Points& columns, Norm norm, std::span<const double> bounds);

/// Work space of one thread for fill_column_by_tiles: the columns of a few groups, as bits.
struct TileScratch {
    static constexpr std::size_t groups_kept = 4, columns_kept = groups_kept * tile_side;
    std::size_t first_group = static_cast<std::size_t>(-1);  ///< first of the groups that `words` holds; none at first
    std::size_t words_per_column = 0;
    std::vector<std::uint64_t> words;  ///< [bound][column][word]
    std::vector<std::uint64_t> near;   ///< the row blocks near the group at hand, a bit each

    std::uint64_t* column(std::size_t bound, std::size_t c) {
        return words.data() + (bound * columns_kept + c) * words_per_column;
    }
};

/// What fill_column (columns.hpp) does, for columns asked for in ascending order: columns_kept are found at a time.
/// Cost: O(n / 8) boxes and the near tiles, of 64 pairs each, for eight columns.
void fill_column_by_tiles(const TiledMatrix& matrix, std::size_t c, std::size_t offset,
                          std::span<std::uint64_t* const> frames, TileScratch& scratch);

/// The share of all tiles that must be compared, from some groups of columns at equal distances. Cost: O(n).
double near_share(const TiledMatrix& matrix);

}  // namespace swirl::analysis::recurrence::detail
