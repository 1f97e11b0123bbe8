// Counts the lines of a matrix whose columns come one at a time as bits, in blocks of columns on several threads.
//
// Bits are placed so that a diagonal keeps its bit from one column to the next (line_frame.hpp). Lines of one
// or two points, most of them when RR is small, are then counted 64 at a time by population counts; longer ones are
// entered when they begin and tallied when they end. Lines that cross from one block into the next are joined later.
// Of a symmetric matrix only the diagonals below the main one are followed.
#pragma once

#include "analysis/recurrence/lines.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

struct Presences;

struct Shape {
    std::size_t rows, columns;
    bool symmetric;
    int theiler;
    bool vertical = true;  ///< count vertical lines, recurrence times and points as well
    /// Rows and columns that have no point (gaps.hpp); none: all have one. A source leaves them empty, and to lines
    /// they are what the border of the matrix is.
    const Presences* presences = nullptr;
};

/// Sets bit r + offset of frames[k] for every recurrent row r of column c, one frame per threshold.
using ColumnSource = std::function<void(std::size_t c, std::size_t offset, std::span<std::uint64_t* const> frames)>;

/// `make_source` is called once per block of columns, from any thread; a source is used by one thread at a time.
std::vector<LineHistograms> count_all_lines(const Shape& shape, std::size_t thresholds, const Settings& settings,
                                            const std::function<ColumnSource()>& make_source);

/// Drops the zeros at the end of a histogram, but for entry 0.
void trim_zeros(std::vector<std::uint64_t>& histogram);

}  // namespace swirl::analysis::recurrence::detail
