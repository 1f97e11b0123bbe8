// Diagonal lines that cross from one block of columns into the next.
#pragma once

#include "analysis/recurrence/line_kernels.hpp"

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// Lines of a block that may go on outside it: those that touch its first column and end inside (heads), and those that
/// reach its last column (tails).
struct BlockBorder {
    std::size_t begin = 0;  ///< the block's first column
    std::vector<DiagonalLine> heads, tails;
};

/// Puts the pieces together and hands every whole line to `record`. `blocks` in order; all bits lie in
/// first_bit ... end_bit - 1. Cost: O(bits + pieces).
void join_blocks(std::span<const BlockBorder* const> blocks, std::size_t first_bit, std::size_t end_bit,
                 const std::function<void(const DiagonalLine&)>& record);

}  // namespace swirl::analysis::recurrence::detail
