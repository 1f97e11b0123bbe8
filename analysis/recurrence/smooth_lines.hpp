// Lines of the recurrence matrix of a smooth trajectory against itself, diagonal by diagonal: along a diagonal the
// distance of two points changes slowly, so that a line of it is known by where it begins and where it ends.
#pragma once

#include "analysis/recurrence/lines.hpp"
#include "analysis/recurrence/tiled_columns.hpp"

#include <cstddef>

namespace swirl::analysis::recurrence::detail {

/// Whether the lines of `matrix`, one trajectory's without gaps, can be counted this way: single precision decides it.
bool can_follow_diagonals(const TiledMatrix& matrix);

/// What count_all_lines (line_counter.hpp) gives for the bound number `which`. Only the lower triangle is looked at:
/// its columns and its rows are the two halves of the matrix's columns. Cost: a test of two boxes for 64 pairs of the
/// triangle and the keys of those that are near, O(n^2 / 64) words that are not 0, the beginnings and ends of diagonal
/// lines, and the vertical lines. Memory: O(n).
LineHistograms count_smooth_lines(const TiledMatrix& matrix, std::size_t which, int theiler, const Settings& settings);

}  // namespace swirl::analysis::recurrence::detail
