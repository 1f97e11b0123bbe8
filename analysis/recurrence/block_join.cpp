#include "analysis/recurrence/block_join.hpp"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace swirl::analysis::recurrence::detail {

void join_blocks(std::span<const BlockBorder* const> blocks, std::size_t first_bit, std::size_t end_bit,
                 const std::function<void(const DiagonalLine&)>& record) {
    // start[q - first_bit] - 1 is the column where the line that is open at bit q began; 0: none is open.
    std::vector<std::uint32_t> start(end_bit - first_bit, 0);
    const auto take_start = [&](const DiagonalLine& line) {  // where a line that touches the block's begin truly began
        const std::uint32_t began = std::exchange(start[line.q - first_bit], 0);
        return began != 0 ? began - 1 : line.first;
    };
    std::vector<DiagonalLine> open;
    for (const BlockBorder* block : blocks) {
        for (const DiagonalLine& line : block->heads) record({line.q, take_start(line), line.last});
        std::vector<DiagonalLine> still_open = block->tails;
        for (DiagonalLine& line : still_open)
            if (line.first == block->begin) line.first = take_start(line);
        for (const DiagonalLine& line : open)  // those that did not go on into this block
            if (std::exchange(start[line.q - first_bit], 0) != 0) record(line);
        for (const DiagonalLine& line : still_open) start[line.q - first_bit] = line.first + 1;
        open = std::move(still_open);
    }
    for (const DiagonalLine& line : open) record(line);
}

}  // namespace swirl::analysis::recurrence::detail
