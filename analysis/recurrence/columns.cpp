#include "analysis/recurrence/columns.hpp"

#include "analysis/recurrence/kernels.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>
#include <tbb/parallel_sort.h>

namespace swirl::analysis::recurrence::detail {
namespace {

// Above these shares of candidates it is cheaper to compare all rows in time order than to scatter bits.
constexpr std::size_t dense_share_scalar = 3;  // 1 in 3
constexpr std::size_t dense_share_vector = 2;  // 1 in 2

bool is_squared(const SortedRows& rows) { return rows.norm == Norm::euclidean && rows.rows->dimension > 1; }

void scatter_masks(const SortedRows& rows, std::size_t begin, std::size_t count, std::size_t offset,
                   const std::uint64_t* masks, std::uint64_t* frame) {
    for (std::size_t w = 0; w < (count + 63) / 64; ++w)
        for (std::uint64_t bits = masks[w]; bits != 0; bits &= bits - 1) {
            const std::size_t rank = begin + w * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            const std::size_t q = rows.order[rank] + offset;
            frame[q >> 6] |= std::uint64_t{1} << (q & 63);
        }
}

// More than one coordinate: the candidates by the first coordinate are compared in full, in rank order.
void fill_candidates(const SortedRows& rows, const KeyTask& task, std::span<const RankRange> ranges,
                     std::span<const double> bounds, std::size_t offset, std::span<std::uint64_t* const> frames,
                     ColumnScratch& scratch) {
    for (const RankRange& range : ranges)
        for (std::size_t begin = range.begin; begin < range.end; begin += chunk_size) {
            const std::size_t count = std::min(chunk_size, range.end - begin);
            compute_keys(task, begin, count, scratch.keys.data());
            for (std::size_t k = 0; k < bounds.size(); ++k) {
                mask_keys(scratch.keys.data(), count, bounds[k], scratch.masks.data());
                scatter_masks(rows, begin, count, offset, scratch.masks.data(), frames[k]);
            }
        }
}

// All rows in time order. Row i is bit i + offset: chunks begin where a word of the frame begins.
void fill_all(std::size_t n, const KeyTask& task, std::span<const double> bounds, std::size_t offset,
              std::span<std::uint64_t* const> frames, ColumnScratch& scratch) {
    std::size_t row = 0;
    while (row < n) {
        const std::size_t shift = (row + offset) & 63;  // not 0 only for the first, partial word
        const std::size_t count = std::min(shift != 0 ? 64 - shift : chunk_size, n - row);
        compute_keys(task, row, count, scratch.keys.data());
        for (std::size_t k = 0; k < bounds.size(); ++k) {
            std::uint64_t* words = frames[k] + ((row + offset) >> 6);
            if (shift != 0) {
                mask_keys(scratch.keys.data(), count, bounds[k], scratch.masks.data());
                words[0] |= scratch.masks[0] << shift;
            } else {
                mask_keys(scratch.keys.data(), count, bounds[k], words);
            }
        }
        row += count;
    }
}

}  // namespace

SortedRows sort_rows(const Points& rows, Norm norm) {
    SortedRows sorted{&rows, norm, {}, {}};
    if (rows.dimension > SortedRows::max_sorted_dimension) return sorted;
    sorted.order.resize(rows.count);
    std::iota(sorted.order.begin(), sorted.order.end(), 0u);
    const double* x = rows.coordinate(0);
    tbb::parallel_sort(sorted.order.begin(), sorted.order.end(), [x](std::uint32_t a, std::uint32_t b) {
        return x[a] < x[b] || (x[a] == x[b] && a < b);
    });
    for (int m = 0; m < rows.dimension; ++m) {
        auto& by_rank = sorted.coordinates.emplace_back(rows.count);
        const double* in_time = rows.coordinate(m);
        for (std::size_t k = 0; k < rows.count; ++k) by_rank[k] = in_time[sorted.order[k]];
    }
    return sorted;
}

std::array<RankRange, 3> ranks_within(std::span<const double> sorted, double b, double period, double bound,
                                      bool squared) {
    const auto key = [squared](double d) { return squared ? d * d : d; };
    const auto begin = sorted.begin();
    // Rounding is monotone, so each of these predicates changes once along the sorted values.
    const auto middle = std::lower_bound(begin, sorted.end(), b);
    const auto lo = std::partition_point(begin, middle, [&](double a) { return key(b - a) > bound; });
    const auto hi = std::partition_point(middle, sorted.end(), [&](double a) { return key(a - b) <= bound; });
    RankRange around{static_cast<std::size_t>(lo - begin), static_cast<std::size_t>(hi - begin)};
    if (!(period > 0)) return {around, {around.end, around.end}, {around.end, around.end}};
    const auto low_end = std::partition_point(begin, lo, [&](double a) { return key(period - (b - a)) <= bound; });
    const auto high_begin = std::partition_point(hi, sorted.end(), [&](double a) { return key(period - (a - b)) > bound; });
    return {RankRange{0, static_cast<std::size_t>(low_end - begin)}, around,
            RankRange{static_cast<std::size_t>(high_begin - begin), sorted.size()}};
}

ColumnScratch make_scratch(const SortedRows& rows) {
    ColumnScratch scratch;
    scratch.keys.resize(chunk_size);
    scratch.masks.resize(chunk_size / 64);
    scratch.centre.resize(static_cast<std::size_t>(rows.rows->dimension));
    for (int m = 0; m < rows.rows->dimension; ++m) scratch.in_time.push_back(rows.rows->coordinate(m));
    for (const auto& c : rows.coordinates) scratch.by_rank.push_back(c.data());
    return scratch;
}

void fill_column(const SortedRows& rows, const Points& columns, std::size_t c, std::span<const double> bounds,
                 std::size_t offset, std::span<std::uint64_t* const> frames, ColumnScratch& scratch) {
    const Points& x = *rows.rows;
    for (int m = 0; m < x.dimension; ++m) scratch.centre[static_cast<std::size_t>(m)] = columns.coordinate(m)[c];
    KeyTask task{scratch.in_time.data(), scratch.centre.data(), x.periods.data(), x.dimension, rows.norm};
    if (rows.order.empty()) return fill_all(x.count, task, bounds, offset, frames, scratch);

    const double widest = *std::max_element(bounds.begin(), bounds.end());
    const auto find = [&](double bound) {
        return ranks_within(rows.coordinates[0], scratch.centre[0], x.periods[0], bound, is_squared(rows));
    };
    const auto ranges = find(widest);
    std::size_t candidates = 0;
    for (const RankRange& r : ranges) candidates += r.end - r.begin;
    if (candidates * (x.dimension == 1 ? dense_share_scalar : dense_share_vector) > x.count)
        return fill_all(x.count, task, bounds, offset, frames, scratch);
    if (x.dimension > 1) {
        task.coordinates = scratch.by_rank.data();
        return fill_candidates(rows, task, ranges, bounds, offset, frames, scratch);
    }
    for (std::size_t k = 0; k < bounds.size(); ++k)
        for (const RankRange& r : bounds[k] == widest ? ranges : find(bounds[k]))
            scatter_rows(rows.order.data(), r.begin, r.end, offset, frames[k]);
}

}  // namespace swirl::analysis::recurrence::detail
