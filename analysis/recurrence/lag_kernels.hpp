// The inner loop over a band of diagonals of a trajectory against itself: which pairs are recurrent, as bits that keep
// their place along a diagonal. In single precision, of two or three coordinates. Compiled for several instruction sets
// and chosen at run time (Highway).
#pragma once

#include "analysis/recurrence/settings.hpp"
#include "analysis/recurrence/tile_kernels.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis::recurrence::detail {

/// A band is 256 lags (row minus column), four words of 64. Its columns are taken in chunks of 64 blocks of eight, and
/// compared with blocks of eight rows.
constexpr std::size_t word_lags = 64, band_words = 4, band_lags = band_words * word_lags;
constexpr std::size_t chunk_blocks = 64, chunk_columns = tile_side * chunk_blocks;

/// What is kept beyond the last point, as points that are near none: coordinates, and boxes.
constexpr std::size_t point_padding = chunk_columns + 2 * band_lags, box_padding = 4 * chunk_blocks;

/// Boxes around the points 8 b ... 8 b + 7, rounded outwards.
struct LagBoxes {
    std::array<const float*, 3> least, largest;
};

/// Points and the bound of their keys (tile_kernels.hpp, SingleBound).
struct LagTask {
    std::array<const float*, 3> coordinates;
    int dimension;  ///< 2 or 3
    Norm norm;
    SingleBound bound;
    LagBoxes boxes;
};

/// Rows row ... row + 7 of columns column ... column + 7.
struct LagTile {
    std::uint32_t row, column;
};
constexpr std::size_t most_open_tiles = chunk_blocks * (band_lags / tile_side + 1);

/// The lags from first_lag on, a multiple of band_lags, of the columns first_column ... first_column + 8 blocks - 1;
/// first_column is a multiple of chunk_columns, blocks <= chunk_blocks. Bit k of words[w][c] is set if the pair
/// (row first_column + c + first_lag + 64 w + k, column first_column + c) is surely within the bound. Tiles that hold
/// pairs that single precision leaves open are listed in `open`, with room for most_open_tiles; how many.
/// Cost: 33 tests of boxes for eight columns, and the keys of the tiles that are near.
std::size_t compare_band(const LagTask& task, std::size_t first_column, std::size_t first_lag, std::size_t blocks,
                         const std::array<std::uint64_t*, band_words>& words, LagTile* open);

}  // namespace swirl::analysis::recurrence::detail
