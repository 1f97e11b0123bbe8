// Where the bits of a column lie while lines are counted.
#pragma once

#include "analysis/recurrence/line_counter.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis::recurrence::detail {

/// Where things lie in a frame. Row r of column c is bit origin - c + r, so bit q is the diagonal r - c = q - origin.
struct Frame {
    std::size_t rows, columns, origin, words;
    std::size_t lines_begin;  // first bit whose diagonal is followed, a multiple of 64

    explicit Frame(const Shape& shape)
        : rows(shape.rows),
          columns(shape.columns),
          origin((shape.columns - 1) | 63),
          words((origin + rows) / 64 + 2),
          lines_begin(shape.symmetric ? origin + 1 : 0) {}
    std::size_t offset(std::size_t c) const { return origin - c; }
    std::size_t first_word(std::size_t c) const { return offset(c) >> 6; }
    std::size_t last_word(std::size_t c) const { return (offset(c) + rows - 1) >> 6; }
    std::size_t line_words() const { return words - lines_begin / 64; }
};

/// The frame last held column c - 4, whose bits lie at most one word above those of c.
inline void clear_column(const Frame& frame, std::size_t c, std::uint64_t* words) {
    const std::size_t clamped = std::min(c, frame.columns - 1);
    std::fill(words + frame.first_word(clamped), words + std::min(frame.last_word(clamped) + 2, frame.words), 0);
}

/// Clears the bits of the Theiler window, which lie at the same place in every column; how many were set.
inline std::size_t clear_window(const Frame& frame, int theiler, std::uint64_t* words) {
    std::size_t removed = 0;
    const auto reach = static_cast<std::size_t>(theiler);
    const std::size_t last = std::min(frame.origin + reach, frame.words * 64);
    for (std::size_t q = frame.origin + 1 - std::min(reach, frame.origin + 1); q < last;) {
        const std::size_t bits = std::min(64 - (q & 63), last - q);
        const std::uint64_t mask = (~std::uint64_t{0} >> (64 - bits)) << (q & 63);
        removed += static_cast<std::size_t>(std::popcount(words[q >> 6] & mask));
        words[q >> 6] &= ~mask;
        q += bits;
    }
    return removed;
}

}  // namespace swirl::analysis::recurrence::detail
