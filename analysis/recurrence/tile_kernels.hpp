// The inner loops over tiles: eight consecutive rows against eight consecutive columns. Compiled for several
// instruction sets and chosen at run time (Highway). Single IEEE operations in a fixed order, no fused ones: the keys
// are the very ones of metric.hpp on all of them.
#pragma once

#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>

namespace swirl::analysis::recurrence::detail {

constexpr std::size_t tile_side = 8;

/// The smallest box around some points: `dimension` values each.
struct Box {
    const double* least;
    const double* largest;
};

/// How a key is formed (metric.hpp).
struct KeyRule {
    const double* periods;  ///< `dimension` values, 0: not an angle
    int dimension;
    Norm norm;
};

/// Boxes around the row blocks: least[m][b], largest[m][b] of coordinate m of block b, readable up to the next multiple
/// of 64.
struct Boxes {
    const double* const* least;
    const double* const* largest;
    std::size_t count;
};

/// Bit b of `near` is set if a point of box b may lie within `bound` of a point of `box`; bits from boxes.count to the
/// end of the last word are 0: (count + 63) / 64 words. No box is left out that has such a point: the key of the gaps
/// between the two boxes is at most that of any two points, rounding included, for each of its operations is monotone.
/// Cost: O(count dimension).
void near_boxes(const KeyRule& rule, const Box& box, double bound, const Boxes& boxes, std::uint64_t* near);

/// What single precision needs to decide most pairs: a key formed in it is surely within bounds[q] if <= surely, surely
/// not if > perhaps; in between double precision decides. Empty `bounds`: all pairs are left to double precision.
/// Of two coordinates up to most_in_single, none an angle.
constexpr int most_in_single = 3;
struct SingleBound {
    float surely, perhaps;
};
struct SingleTask {
    const float* const* rows;
    const float* const* columns;
    std::span<const SingleBound> bounds;
};

/// Tiles of one group of columns.
struct TileTask {
    const double* const* rows;     ///< rows[m][i]: coordinate m of row i
    const double* const* columns;  ///< columns[m][k]: coordinate m of the group's column k
    std::size_t column_count;      ///< 1 ... tile_side
    std::span<const double> bounds;
    SingleTask single;
    std::uint8_t* const*
        bytes;  ///< bytes[q * tile_side + k][b]: bit j is set if row 8 b + j is within bounds[q] of column k
};
/// Sets the bits, 0 before, of the tiles whose row block b is a bit of `near`; each has eight rows. Cost: 64 keys a
/// tile.
void compare_tiles(const KeyRule& rule, const TileTask& task, std::span<const std::uint64_t> near);

/// Adds the bits of words[0] ... words[count - 1] to a frame from its bit `offset` on.
void add_shifted(const std::uint64_t* words, std::size_t count, std::size_t offset, std::uint64_t* frame);

}  // namespace swirl::analysis::recurrence::detail
