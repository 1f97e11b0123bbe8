#include "analysis/recurrence/tiled_columns.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace swirl::analysis::recurrence::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

double largest_value(const Points& points) {
    double largest = 0;
    for (const double x : points.values) largest = std::max(largest, std::fabs(x));
    return largest;
}

// What lies between a threshold and single precision's verdict. With u = 2^-24, coordinates up to X and a distance r,
// it finds r but for 8 dimension u (X + r) (README.md, "Tiles"); twice that is left on either side.
struct Margin {
    double threshold, width;
    Margin(double bound, const TiledMatrix& matrix, double largest)
        : threshold(distance_of_key(bound, matrix.norm, matrix.rows->dimension)),
          width(16 * matrix.rows->dimension * std::ldexp(largest + threshold, -24)) {}
};

SingleBound single_bound(const Margin& margin, Norm norm) {
    const auto key = [&](double r) { return static_cast<float>(norm == Norm::euclidean ? r * r : r); };
    return {std::nextafter(key(margin.threshold - margin.width), 0.0f),
            std::nextafter(key(margin.threshold + margin.width), std::numeric_limits<float>::infinity())};
}

// Where the kernels have it, few pairs are left open, and no square overflows or vanishes.
bool single_is_of_use(const TiledMatrix& matrix, double largest) {
    const std::vector<double>& periods = matrix.rows->periods;
    const int dimension = matrix.rows->dimension;
    return dimension >= 2 && dimension <= most_in_single &&
           std::all_of(periods.begin(), periods.end(), [](double period) { return period == 0; }) &&
           std::all_of(matrix.bounds.begin(), matrix.bounds.end(), [&](double bound) {
               const Margin margin(bound, matrix, largest);
               return margin.threshold > 1e-15 && largest + margin.threshold < 1e15 &&
                      margin.width < margin.threshold / 1000;
           });
}

KeyRule rule_of(const TiledMatrix& matrix) {
    return {matrix.rows->periods.data(), matrix.rows->dimension, matrix.norm};
}

// Row blocks begin ... end - 1, begin a multiple of 64.
struct BlockRange {
    std::size_t begin, end;
};

// Columns first ... end - 1, at most tile_side of them.
struct ColumnGroup {
    std::size_t first, end;
};

ColumnGroup group_of(const TiledMatrix& matrix, std::size_t group) {
    return {group * tile_side, std::min((group + 1) * tile_side, matrix.columns->count)};
}

// The row blocks of the range that may hold a point within the widest bound of one of the columns, a bit each.
void find_near(const TiledMatrix& matrix, const ColumnGroup& group, const BlockRange& blocks,
               std::vector<std::uint64_t>& near) {
    near.resize((blocks.end - blocks.begin + 63) / 64);
    std::vector<double> least, largest;
    std::vector<const double*> row_least, row_largest;
    for (int m = 0; m < matrix.columns->dimension; ++m) {
        const double* x = matrix.columns->coordinate(m);
        const auto [low, high] = std::minmax_element(x + group.first, x + group.end);
        least.push_back(*low);
        largest.push_back(*high);
        row_least.push_back(matrix.least[static_cast<std::size_t>(m)].data() + blocks.begin);
        row_largest.push_back(matrix.largest[static_cast<std::size_t>(m)].data() + blocks.begin);
    }
    near_boxes(rule_of(matrix), {least.data(), largest.data()},
               *std::max_element(matrix.bounds.begin(), matrix.bounds.end()),
               {row_least.data(), row_largest.data(), blocks.end - blocks.begin}, near.data());
}

// The last block of all, where it has fewer than eight rows: pair by pair. `block`: its number in the task.
void compare_last(const TiledMatrix& matrix, const ColumnGroup& group, const TileTask& task, std::size_t block) {
    const std::size_t begin = (matrix.blocks - 1) * tile_side;
    for (std::size_t k = 0; k < task.column_count; ++k)
        for (std::size_t row = begin; row < matrix.rows->count; ++row) {
            const double key = pair_key(*matrix.rows, row, *matrix.columns, group.first + k, matrix.norm);
            for (std::size_t q = 0; q < task.bounds.size(); ++q)
                if (key <= task.bounds[q])
                    task.bytes[q * tile_side + k][block] |= static_cast<std::uint8_t>(1u << (row - begin));
        }
}

// Rows from row `first_row` on, and the columns, in single precision where it is of use.
struct InSingle {
    std::vector<float> values;
    std::vector<const float*> rows, columns;
    InSingle(const TiledMatrix& matrix, const ColumnGroup& group, std::size_t first_row) {
        if (matrix.single_bounds.empty()) return;
        const auto dimension = static_cast<std::size_t>(matrix.rows->dimension);
        values.resize(dimension * tile_side);
        for (std::size_t m = 0; m < dimension; ++m) {
            const double* x = matrix.columns->coordinate(static_cast<int>(m));
            std::copy(x + group.first, x + group.end, values.data() + m * tile_side);
            rows.push_back(matrix.single_rows.data() + m * matrix.rows->stride + first_row);
            columns.push_back(values.data() + m * tile_side);
        }
    }
};

// The columns of a group, the `place`-th of those kept, against the rows of the range.
void compare_near(const TiledMatrix& matrix, const ColumnGroup& group, std::size_t place, const BlockRange& blocks,
                  TileScratch& scratch) {
    const std::size_t first_row = blocks.begin * tile_side;
    std::vector<std::uint8_t*> bytes;
    for (std::size_t q = 0; q < matrix.bounds.size(); ++q)
        for (std::size_t k = 0; k < tile_side; ++k)
            bytes.push_back(reinterpret_cast<std::uint8_t*>(scratch.column(q, place * tile_side + k)) + blocks.begin);
    std::vector<const double*> rows, columns;
    for (int m = 0; m < matrix.rows->dimension; ++m) {
        rows.push_back(matrix.rows->coordinate(m) + first_row);
        columns.push_back(matrix.columns->coordinate(m) + group.first);
    }
    const InSingle single(matrix, group, first_row);
    const TileTask task{rows.data(),
                        columns.data(),
                        group.end - group.first,
                        matrix.bounds,
                        {single.rows.data(), single.columns.data(), matrix.single_bounds},
                        bytes.data()};
    find_near(matrix, group, blocks, scratch.near);
    if (blocks.end == matrix.blocks && matrix.rows->count % tile_side != 0) {
        const std::size_t block = blocks.end - blocks.begin - 1;
        const std::uint64_t last = std::uint64_t{1} << (block & 63);
        if ((scratch.near.back() & last) != 0) compare_last(matrix, group, task, block);
        scratch.near.back() &= ~last;
    }
    compare_tiles(rule_of(matrix), task, scratch.near);
}

// Several groups take their turn at a range of rows that stays in the cache (32,768 rows: half a megabyte in all).
void fill_groups(const TiledMatrix& matrix, std::size_t first_group, TileScratch& scratch) {
    constexpr std::size_t blocks_at_a_time = 4096;
    scratch.first_group = first_group;
    scratch.words_per_column = (matrix.blocks + 7) / 8;
    scratch.words.assign(matrix.bounds.size() * TileScratch::columns_kept * scratch.words_per_column, 0);
    const std::size_t groups = (matrix.columns->count + tile_side - 1) / tile_side;
    const std::size_t end = std::min(first_group + TileScratch::groups_kept, groups);
    for (std::size_t begin = 0; begin < matrix.blocks; begin += blocks_at_a_time)
        for (std::size_t group = first_group; group < end; ++group)
            compare_near(matrix, group_of(matrix, group), group - first_group,
                         {begin, std::min(begin + blocks_at_a_time, matrix.blocks)}, scratch);
}

}  // namespace

TiledMatrix tiled_matrix(const Points& rows, const Points& columns, Norm norm, std::span<const double> bounds) {
    TiledMatrix matrix{&rows, &columns, norm, bounds, (rows.count + tile_side - 1) / tile_side, {}, {}, {}, {}};
    const std::size_t filled = (matrix.blocks + 63) / 64 * 64;
    for (int m = 0; m < rows.dimension; ++m) {
        const double* x = rows.coordinate(m);
        std::vector<double> least(filled, infinity), largest(filled, -infinity);
        for (std::size_t i = 0; i < rows.count; ++i) {
            least[i / tile_side] = std::min(least[i / tile_side], x[i]);
            largest[i / tile_side] = std::max(largest[i / tile_side], x[i]);
        }
        matrix.least.push_back(std::move(least));
        matrix.largest.push_back(std::move(largest));
    }
    const double largest = std::max(largest_value(rows), largest_value(columns));
    if (!single_is_of_use(matrix, largest)) return matrix;
    matrix.single_rows.assign(rows.values.begin(), rows.values.end());
    for (const double bound : bounds)
        matrix.single_bounds.push_back(single_bound(Margin(bound, matrix, largest), norm));
    return matrix;
}

void fill_column_by_tiles(const TiledMatrix& matrix, std::size_t c, std::size_t offset,
                          std::span<std::uint64_t* const> frames, TileScratch& scratch) {
    const std::size_t kept = c / TileScratch::columns_kept;
    if (scratch.first_group != kept * TileScratch::groups_kept)
        fill_groups(matrix, kept * TileScratch::groups_kept, scratch);
    for (std::size_t q = 0; q < matrix.bounds.size(); ++q)
        add_shifted(scratch.column(q, c % TileScratch::columns_kept), scratch.words_per_column, offset, frames[q]);
}

double near_share(const TiledMatrix& matrix) {
    constexpr std::size_t most_groups = 32;
    const std::size_t groups = (matrix.columns->count + tile_side - 1) / tile_side;
    const std::size_t taken = std::min(groups, most_groups);
    std::vector<std::uint64_t> near;
    std::size_t found = 0;
    for (std::size_t g = 0; g < taken; ++g) {
        find_near(matrix, group_of(matrix, g * groups / taken), {0, matrix.blocks}, near);
        for (const std::uint64_t word : near) found += static_cast<std::size_t>(std::popcount(word));
    }
    return static_cast<double>(found) / static_cast<double>(taken * matrix.blocks);
}

}  // namespace swirl::analysis::recurrence::detail
