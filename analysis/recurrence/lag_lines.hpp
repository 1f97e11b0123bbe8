// Vertical lines of a symmetric matrix whose diagonals come from the farthest to the main one, 64 lags at a time: what
// column c has below the main diagonal, and, by symmetry, what it has above it, which is row c of the lower triangle.
#pragma once

#include "analysis/recurrence/line_kernels.hpp"
#include "analysis/recurrence/settings.hpp"

#include <array>
#include <cstddef>
#include <cstdint>

namespace swirl::analysis::recurrence::detail {

/// Lags begin ... end - 1 of one column, or of one row: the line nearest to the main diagonal so far. It may go on, so
/// that it is counted when the next one is found, and with it the time to the line before it: `mark` says where that
/// one lies, as the kind of time has it (lag_line_kernels.cpp).
struct LagLine {
    std::uint32_t begin, end, mark;
};
/// Its mark, too, is that of no line: what mark_of gives of it.
constexpr LagLine no_line{static_cast<std::uint32_t>(-1), static_cast<std::uint32_t>(-1),
                          static_cast<std::uint32_t>(-1)};
inline bool exists(const LagLine& line) {
    return line.end != no_line.end;
}

/// The two halves of a column. In the upper one rows rise as lags fall.
enum class Half { lower, upper };

/// Lengths of lines and times between them. Short ones lie in small tables, which the first cache holds: two of each,
/// taken by turns. settle() before any count of these can reach 2^32.
struct LineTallies {
    static constexpr std::size_t shortest = 2048, tables = 2;
    std::array<std::uint32_t, tables * shortest> near_lines{}, near_times{};
    Tally lines, times;

    void settle() {
        for (std::size_t k = 0; k < near_lines.size(); ++k) {  // what is entered as 0 has not ended
            if (k % shortest == 0) continue;
            lines.near[k % shortest] += near_lines[k];
            times.near[k % shortest] += near_times[k];
        }
        near_lines = {};
        near_times = {};
    }
};

/// What is counted, and where.
struct LagLineTask {
    std::size_t points;  ///< n
    const Settings* settings;
    LineTallies* tallies;
};

/// words[i], i < count, 64 lags from first_lag on, of column (lower half) or row (upper) first + i, whose nearest line
/// is nearest[i]. Counts the lines that have ended, and the times between consecutive ones. Cost: O(words + lines).
void add_lag_lines(const LagLineTask& task, Half half, const std::uint64_t* words, std::size_t count, std::size_t first,
                   std::size_t first_lag, LagLine* nearest);

/// What is left when all diagonals have been: column c, whose lines nearest to the main diagonal are given, and the
/// main diagonal's point itself, if it is recurrent and outside the window.
void join_halves(const LagLineTask& task, std::size_t c, bool centre, const LagLine& lower, const LagLine& upper);

}  // namespace swirl::analysis::recurrence::detail
