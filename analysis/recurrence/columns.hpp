// The columns of a recurrence matrix R_ij = [ key(x_i, y_j) <= bound ], made one at a time, as bits: never the matrix.
#pragma once

#include "analysis/recurrence/metric.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis::recurrence::detail {

/// Points that lie together: ranks begin ... end - 1, first coordinates least ... largest.
struct Slab {
    std::size_t begin, end;
    double least, largest;
};

/// The rows x in an order in which the candidates of a column are a few runs of consecutive ranks: in one dimension by
/// value, else cut by the first coordinate into slabs of equal numbers, each sorted by the second coordinate.
/// For more than max_sorted_dimension coordinates nothing is sorted (two of many hardly narrow the search, and the
/// copies would cost memory): columns are then compared with all rows.
struct SortedRows {
    static constexpr int max_sorted_dimension = 4;
    const Points* rows = nullptr;
    Norm norm = Norm::euclidean;
    std::vector<std::uint32_t> order;              ///< row of each rank; empty if nothing is sorted
    std::vector<std::vector<double>> coordinates;  ///< by rank
    std::vector<Slab> slabs;                       ///< one in one dimension
};
SortedRows sort_rows(const Points& rows, Norm norm);

/// Ranks begin ... end - 1.
struct RankRange {
    std::size_t begin, end;
};

/// Where |a - b| (or its wrapped form) lies within reach of b: at most three runs of ranks, in order and disjoint
/// (around b, and across the cut of an angle on either side). Cost: O(log n).
std::array<RankRange, 3> ranks_within(std::span<const double> sorted, double b, double period, double bound,
                                      bool squared);

/// Work space of one thread for fill_column.
struct ColumnScratch {
    std::vector<double> keys;
    std::vector<std::uint64_t> masks;
    std::vector<double> centre;
    std::vector<const double*> in_time, by_rank;
    std::vector<RankRange> candidates;
};
ColumnScratch make_scratch(const SortedRows& rows);

/// The share of all rows, which are sorted, that are compared with a column: from some columns at equal distances.
/// Cost: O(log n).
double candidate_share(const SortedRows& rows, const Points& columns, double bound);

/// Sets, for every bound k, bit i + offset of frames[k] for each row i with key(x_i, y_c) <= bounds[k], y_c the point c
/// of `columns`. The bits offset ... offset + n - 1 must be 0 before. Cost: O(log n + candidates), at worst O(n).
void fill_column(const SortedRows& rows, const Points& columns, std::size_t c, std::span<const double> bounds,
                 std::size_t offset, std::span<std::uint64_t* const> frames, ColumnScratch& scratch);

}  // namespace swirl::analysis::recurrence::detail
