// Line histograms of recurrence matrices: all that recurrence quantification needs, counted exactly.
//
// R_ij = 1 when points i and j are recurrent (metric.hpp); rows are i, columns j. A diagonal line is a maximal run
// (i, j), (i+1, j+1), ...; a vertical line is a maximal run along a column. Everything is an integer count, so the
// result is the same on any number of threads (the caller's TBB arena) and any instruction set.
//
// Cost of the functions below, n rows and columns: O(n log n) to sort, then O(n^2 / 64) word operations for the
// diagonal lines and the work of finding the recurrence points: O(RR n^2) in one dimension; above, of smooth
// trajectories the n^2 / 64 tests of tiles and the pairs of near ones (README.md, "Tiles"), of others O(candidates by
// the first two coordinates) up to dimension 4 and n^2 distances above. One smooth trajectory in two or three
// coordinates takes half of the tests and pairs, one pass for each threshold (README.md, "Diagonals of a smooth
// trajectory"). Vertical lines of a plain scalar series with a
// Theiler window of at most 16 take O(n W log n), others O(RR n^2). Memory O(n) per threshold and thread, never O(n^2).
#pragma once

#include "analysis/recurrence/metric.hpp"
#include "analysis/recurrence/settings.hpp"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence {

/// Histograms are indexed by length: diagonal[l] lines of l points; entry 0 is unused; the last entry is not 0.
struct LineHistograms {
    std::size_t rows = 0, columns = 0;
    int theiler = 0;                             ///< the window that was applied
    bool symmetric = false;                      ///< one trajectory against itself
    std::uint64_t points = 0;                    ///< recurrence points of the whole matrix
    std::uint64_t points_outside_window = 0;     ///< those with |i - j| >= theiler
    std::vector<std::uint64_t> diagonal;         ///< diagonal lines outside the window
    std::vector<std::uint64_t> vertical;         ///< vertical lines
    std::vector<std::uint64_t> recurrence_time;  ///< recurrence times (settings.recurrence_time)
    /// Points with |i - j| = k, k = 0 ... min(rows, columns) - 1, within the largest square (i, j < min). Entries with
    /// k < theiler are 0.
    std::vector<std::uint64_t> diagonal_points;
    /// Of points with gaps between them (Points::row_numbers): the pairs of points, those with |i - j| >= theiler, and
    /// those with |i - j| = k within the largest square. Without gaps 0, 0 and empty: all pairs of rows and columns.
    std::uint64_t pairs = 0, pairs_outside_window = 0;
    std::vector<std::uint64_t> diagonal_pairs = {};
};

/// Gaps (Points::row_numbers) are to lines what the border of the matrix is: the stretches of rows between them against
/// those of the columns are matrices of their own, whose lines are added up. Rows and columns, and the lengths of the
/// diagonals, count those of gaps, too.

/// A matrix given entry by entry, row after row; not 0 means recurrent.
struct BinaryMatrix {
    std::size_t rows = 0, columns = 0;
    std::vector<std::uint8_t> entries;
};

/// Lines of the recurrence matrix of one trajectory at several thresholds, in one pass over the pairs.
/// thresholds >= 0, in the units of the distance. Default Theiler window 1.
std::vector<LineHistograms> count_lines(const Points& points, std::span<const double> thresholds,
                                        const Settings& settings = {});
LineHistograms count_lines(const Points& points, double threshold, const Settings& settings = {});

/// Lines of the cross recurrence matrix of two trajectories (rows from the first). Default Theiler window 0.
std::vector<LineHistograms> count_cross_lines(const Points& rows, const Points& columns,
                                              std::span<const double> thresholds, const Settings& settings = {});

/// Lines of a matrix that is given (as a cross recurrence matrix: both triangles are counted).
LineHistograms count_lines(const BinaryMatrix& matrix, const Settings& settings = {});

}  // namespace swirl::analysis::recurrence
