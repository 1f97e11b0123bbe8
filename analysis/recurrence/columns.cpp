#include "analysis/recurrence/columns.hpp"

#include "analysis/recurrence/distance_kernels.hpp"
#include "analysis/recurrence/line_kernels.hpp"

#include <tbb/parallel_sort.h>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace swirl::analysis::recurrence::detail {
namespace {

// Above these shares of candidates it is cheaper to compare all rows in time order than to scatter bits.
constexpr std::size_t dense_share_scalar = 3;  // 1 in 3
constexpr std::size_t dense_share_vector = 2;  // 1 in 2

// Slabs: enough that a threshold spans several, few enough that looking into each of them costs little.
constexpr std::size_t points_per_slab = 256, most_slabs = 32;

bool is_squared(const SortedRows& rows) {
    return rows.norm == Norm::euclidean && rows.rows->dimension > 1;
}

double coordinate_key(double d, double period, bool squared) {
    if (period > 0) d = std::min(d, period - d);
    return squared ? d * d : d;
}

// No value between least and largest is nearer to b than b itself, if it lies there, or one of the two ends.
bool slab_within(const Slab& slab, double b, double period, double bound, bool squared) {
    return (slab.least <= b && b <= slab.largest) ||
           coordinate_key(std::fabs(slab.least - b), period, squared) <= bound ||
           coordinate_key(std::fabs(slab.largest - b), period, squared) <= bound;
}

// Runs of ranks that hold every row within the bound of the point scratch.centre; how many rows they are.
std::size_t find_candidates(const SortedRows& rows, double bound, ColumnScratch& scratch) {
    const std::vector<double>& periods = rows.rows->periods;
    const std::size_t axis = rows.rows->dimension == 1 ? 0 : 1;
    const bool squared = is_squared(rows);
    std::size_t count = 0;
    scratch.candidates.clear();
    for (const Slab& slab : rows.slabs) {
        if (axis == 1 && !slab_within(slab, scratch.centre[0], periods[0], bound, squared)) continue;
        const std::span<const double> sorted(rows.coordinates[axis].data() + slab.begin, slab.end - slab.begin);
        for (const RankRange& r : ranks_within(sorted, scratch.centre[axis], periods[axis], bound, squared)) {
            if (r.begin == r.end) continue;
            scratch.candidates.push_back({slab.begin + r.begin, slab.begin + r.end});
            count += r.end - r.begin;
        }
    }
    return count;
}

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
    SortedRows sorted{&rows, norm, {}, {}, {}};
    if (rows.dimension > SortedRows::max_sorted_dimension) return sorted;
    const std::size_t n = rows.count;
    sorted.order.resize(n);
    std::iota(sorted.order.begin(), sorted.order.end(), 0u);
    const auto sort_by = [&](int m, std::size_t begin, std::size_t end) {
        const double* x = rows.coordinate(m);
        const auto at = [&](std::size_t k) { return sorted.order.begin() + static_cast<std::ptrdiff_t>(k); };
        tbb::parallel_sort(at(begin), at(end),
                           [x](std::uint32_t a, std::uint32_t b) { return x[a] < x[b] || (x[a] == x[b] && a < b); });
    };
    sort_by(0, 0, n);
    const std::size_t slabs = rows.dimension == 1 ? 1 : std::clamp<std::size_t>(n / points_per_slab, 1, most_slabs);
    for (std::size_t s = 0; s < slabs; ++s) {
        const std::size_t begin = n * s / slabs, end = n * (s + 1) / slabs;
        const double* x = rows.coordinate(0);
        sorted.slabs.push_back({begin, end, x[sorted.order[begin]], x[sorted.order[end - 1]]});
        if (rows.dimension > 1) sort_by(1, begin, end);
    }
    for (int m = 0; m < rows.dimension; ++m) {
        auto& by_rank = sorted.coordinates.emplace_back(n);
        const double* in_time = rows.coordinate(m);
        for (std::size_t k = 0; k < n; ++k) by_rank[k] = in_time[sorted.order[k]];
    }
    return sorted;
}

std::array<RankRange, 3> ranks_within(std::span<const double> sorted, double b, double period, double bound,
                                      bool squared) {
    const auto key = [squared](double d) { return squared ? d * d : d; };
    const auto begin = sorted.begin();
    // Rounding is monotone, so each of these predicates changes once along the sorted values.
    const auto lo = std::partition_point(begin, sorted.end(), [&](double a) { return a < b && key(b - a) > bound; });
    const auto hi = std::partition_point(lo, sorted.end(), [&](double a) { return key(std::fabs(a - b)) <= bound; });
    RankRange around{static_cast<std::size_t>(lo - begin), static_cast<std::size_t>(hi - begin)};
    if (!(period > 0)) return {around, {around.end, around.end}, {around.end, around.end}};
    const auto low_end = std::partition_point(begin, lo, [&](double a) { return key(period - (b - a)) <= bound; });
    const auto high_begin =
        std::partition_point(hi, sorted.end(), [&](double a) { return key(period - (a - b)) > bound; });
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

double candidate_share(const SortedRows& rows, const Points& columns, double bound) {
    constexpr std::size_t most = 64;
    ColumnScratch scratch = make_scratch(rows);
    const std::size_t taken = std::min(columns.count, most);
    std::size_t found = 0;
    for (std::size_t k = 0; k < taken; ++k) {
        for (int m = 0; m < columns.dimension; ++m)
            scratch.centre[static_cast<std::size_t>(m)] = columns.coordinate(m)[k * columns.count / taken];
        found += find_candidates(rows, bound, scratch);
    }
    return static_cast<double>(found) / static_cast<double>(taken * rows.rows->count);
}

void fill_column(const SortedRows& rows, const Points& columns, std::size_t c, std::span<const double> bounds,
                 std::size_t offset, std::span<std::uint64_t* const> frames, ColumnScratch& scratch) {
    const Points& x = *rows.rows;
    for (int m = 0; m < x.dimension; ++m) scratch.centre[static_cast<std::size_t>(m)] = columns.coordinate(m)[c];
    KeyTask task{scratch.in_time.data(), scratch.centre.data(), x.periods.data(), x.dimension, rows.norm};
    if (rows.order.empty()) return fill_all(x.count, task, bounds, offset, frames, scratch);

    const double widest = *std::max_element(bounds.begin(), bounds.end());
    const std::size_t candidates = find_candidates(rows, widest, scratch);
    if (candidates * (x.dimension == 1 ? dense_share_scalar : dense_share_vector) > x.count)
        return fill_all(x.count, task, bounds, offset, frames, scratch);
    if (x.dimension > 1) {
        task.coordinates = scratch.by_rank.data();
        return fill_candidates(rows, task, scratch.candidates, bounds, offset, frames, scratch);
    }
    for (std::size_t k = 0; k < bounds.size(); ++k) {
        if (k > 0 || bounds[k] != widest) find_candidates(rows, bounds[k], scratch);
        for (const RankRange& r : scratch.candidates)
            scatter_rows(rows.order.data(), r.begin, r.end, offset, frames[k]);
    }
}

}  // namespace swirl::analysis::recurrence::detail
