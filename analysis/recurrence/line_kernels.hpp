// The inner loops over bits, compiled for several instruction sets and chosen at run time (Highway). Integers only.
//
// Frame. Column c of the matrix is kept as bits, row r at bit q = r + offset. Line counting uses
// offset = origin - c, so that q - origin = r - c is the diagonal: consecutive columns align without shifts.
#pragma once

#include "analysis/recurrence/settings.hpp"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// Sets bit order[k] + offset for k = begin ... end - 1.
void scatter_rows(const std::uint32_t* order, std::size_t begin, std::size_t end, std::size_t offset,
                  std::uint64_t* words);

/// A histogram that many threads add to: short lengths in a private table, long ones (rare) straight to the shared one.
struct Tally {
    static constexpr std::size_t small = 4096;
    std::vector<std::uint64_t> near = std::vector<std::uint64_t>(small, 0);
    std::span<std::uint64_t> shared;

    void add(std::size_t length) {
        if (length < small)
            ++near[length];
        else
            std::atomic_ref(shared[length]).fetch_add(1, std::memory_order_relaxed);
    }
    void remove(std::size_t length) {
        if (length < small)
            --near[length];  // may wrap: the sum over all tallies, modulo 2^64, is what counts
        else
            std::atomic_ref(shared[length]).fetch_sub(1, std::memory_order_relaxed);
    }
    void flush() {
        for (std::size_t i = 0; i < small; ++i)
            if (near[i] != 0) std::atomic_ref(shared[i]).fetch_add(near[i], std::memory_order_relaxed);
    }
};

/// Vertical lines and recurrence times of one column whose rows are the bits first ... last - 1. Returns its points.
struct VerticalOptions {
    RecurrenceTime recurrence_time;
    bool border_white_lines;
    bool discard_border_lines;
    std::uint32_t* changes;  ///< work space for last - first + 72 positions
};
std::size_t vertical_lines(const std::uint64_t* words, std::size_t first, std::size_t last,
                           const VerticalOptions& options, Tally& lines, Tally& times);

/// Where the bits of words[0] ... words[count - 1] differ from those of the word before (words[-1] is read): bit k of
/// words[c] as 64 c + k, in order. How many; `turns` has room for all bits and four more.
std::size_t list_turns(const std::uint64_t* words, std::size_t count, std::uint32_t* turns);

/// A diagonal line: bit q of the frame, columns first ... last.
struct DiagonalLine {
    std::uint32_t q;
    std::uint32_t first;
    std::uint32_t last;
};

/// One step of the diagonal line count: column `column` with its neighbours, all as bits of the same frame.
/// Lines of one and two points that certainly end inside the block are counted by population count (singles, doubles);
/// all others are entered in `open` when they begin, and come out in `ended` when they end.
struct DiagonalStep {
    const std::uint64_t* previous;
    const std::uint64_t* current;
    const std::uint64_t* next;
    const std::uint64_t* after_next;
    std::uint64_t* open;                ///< bits of the lines entered and not yet ended
    std::uint32_t* begun;               ///< begun[q - frame_begin]: the column where the open line began
    std::size_t frame_begin;            ///< first bit of the frame that can hold a line (a multiple of 64)
    std::size_t first_word, last_word;  ///< words to look at, both included
    std::uint32_t column;
    bool enter_all;    ///< enter every line that begins here, however short (next to the block's border)
    bool last_column;  ///< the block's last column: lines stay open
};
struct ShortLines {
    std::uint64_t singles = 0, doubles = 0;
};
void diagonal_step(const DiagonalStep& step, ShortLines& shorts, std::vector<DiagonalLine>& ended);

/// Adds the bits of words first ... last (both included) of four columns to bit-sliced counters: plane p holds bit p of
/// every count.
constexpr std::size_t plane_count = 16;
void add_to_planes(const std::array<const std::uint64_t*, 4>& columns, std::size_t first, std::size_t last,
                   std::uint64_t* planes, std::size_t plane_stride);

}  // namespace swirl::analysis::recurrence::detail
