#include "analysis/recurrence/smooth_lines.hpp"

#include "analysis/recurrence/lag_kernels.hpp"
#include "analysis/recurrence/lag_lines.hpp"
#include "analysis/recurrence/line_block.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <thread>
#include <vector>

namespace swirl::analysis::recurrence::detail {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();

// Boxes around points, rounded outwards, and the points; beyond the last one points and boxes that are near none.
struct SmoothPoints {
    std::vector<float> values;
    std::array<std::vector<float>, 3> least, largest;

    explicit SmoothPoints(const TiledMatrix& matrix) : values(matrix.single_rows) {
        values.resize(values.size() + point_padding, infinite);
        for (std::size_t m = 0; m < static_cast<std::size_t>(matrix.rows->dimension); ++m) {
            least[m].assign(matrix.blocks + box_padding, infinite);
            largest[m].assign(matrix.blocks + box_padding, -infinite);
            for (std::size_t b = 0; b < matrix.blocks; ++b) {
                least[m][b] = std::nextafter(static_cast<float>(matrix.least[m][b]), -infinite);
                largest[m][b] = std::nextafter(static_cast<float>(matrix.largest[m][b]), infinite);
            }
        }
    }

    LagTask task(const TiledMatrix& matrix, std::size_t which) const {
        LagTask task{{}, matrix.rows->dimension, matrix.norm, matrix.single_bounds[which], {}};
        for (std::size_t m = 0; m < static_cast<std::size_t>(task.dimension); ++m) {
            task.coordinates[m] = values.data() + m * matrix.rows->stride;
            task.boxes.least[m] = least[m].data();
            task.boxes.largest[m] = largest[m].data();
        }
        return task;
    }
};

// What all threads share. The lines nearest to the main diagonal, of columns and of rows, pass from band to band, the
// farthest band first: a thread follows its band chunk by chunk of columns, always behind the band before.
struct Matrix {
    const TiledMatrix& tiled;
    std::size_t which;
    std::size_t points, theiler;
    const Settings& settings;
    LagTask lags;
    Totals& totals;
    std::vector<LagLine> columns, rows;
    std::vector<std::atomic<std::uint32_t>> done;  // chunks of each band; of the one beyond the farthest, all

    std::size_t bands() const { return (points + band_lags - 1) / band_lags; }
};

// One word of diagonals.
struct DiagonalWord {
    std::size_t first_lag;
    std::uint64_t inside, diagonal, vertical;  // lags that exist, whose diagonals count, and whose vertical lines do
    std::uint64_t column = 0, row = 0;         // the bits of the last column, and of the last row
    std::array<std::uint32_t, word_lags> turned{};  // the column where the bit changed last
    std::array<std::uint64_t, word_lags> points{};
    std::array<std::uint64_t, chunk_columns + word_lags> turns{};  // bits that change from one row to the next

    DiagonalWord(const Matrix& matrix, std::size_t lag)
        : first_lag(lag),
          inside(from_lag(1)),
          diagonal(inside & from_lag(matrix.theiler)),
          vertical(matrix.settings.window_on_vertical ? diagonal : inside) {}
    std::uint64_t from_lag(std::size_t lag) const {
        if (lag <= first_lag) return ~std::uint64_t{0};
        return lag >= first_lag + word_lags ? 0 : ~std::uint64_t{0} << (lag - first_lag);
    }
};

// What a thread counts.
struct Counter {
    std::array<Tally, 2> stretches;  // along diagonals: without recurrence, which nobody asks for, and lines
    LineTallies columns;
    std::uint64_t points = 0, points_outside = 0;
    std::uint64_t pairs = 0;                                                     // since the tallies were settled
    std::array<std::array<std::uint64_t, 1 + chunk_columns>, band_words> words;  // of a chunk, and of the column before
    std::array<std::uint64_t, chunk_columns> rows;
    std::vector<std::uint32_t> turns = std::vector<std::uint32_t>(chunk_columns * word_lags + 4);
    std::vector<LagTile> open = std::vector<LagTile>(most_open_tiles);
    std::vector<DiagonalWord> diagonals;  // of a band; nothing is allocated while other threads may wait for it

    explicit Counter(Totals& totals) {
        diagonals.reserve(band_words);
        stretches[1].shared = totals.diagonal;
        columns.lines.shared = totals.vertical;
        columns.times.shared = totals.time;
    }
    void settle() {
        columns.settle();
        pairs = 0;
    }
    void flush(Totals& totals) {
        settle();
        stretches[1].flush();
        columns.lines.flush();
        columns.times.flush();
        std::atomic_ref(totals.points).fetch_add(points, std::memory_order_relaxed);
        std::atomic_ref(totals.points_outside).fetch_add(points_outside, std::memory_order_relaxed);
    }
};

// What single precision leaves open is decided by the rule itself.
void decide_tile(const Matrix& matrix, const LagTile& tile, std::size_t first, std::size_t first_lag,
                 Counter& counter) {
    const Points& points = *matrix.tiled.rows;
    for (std::size_t column = tile.column; column < tile.column + tile_side; ++column)
        for (std::size_t row = tile.row; row < std::min<std::size_t>(tile.row + tile_side, matrix.points); ++row) {
            if (row < column + first_lag || row >= column + first_lag + band_lags) continue;
            const std::size_t lag = row - column - first_lag;
            const std::uint64_t bit = std::uint64_t{1} << (lag % word_lags);
            std::uint64_t& word = counter.words[lag / word_lags][1 + column - first];
            word &= ~bit;
            if (pair_key(points, row, points, column, matrix.tiled.norm) <= matrix.tiled.bounds[matrix.which])
                word |= bit;
        }
}

// The bits of `count` columns from `first` on.
void find_bits(const Matrix& matrix, std::size_t first_lag, std::size_t first, std::size_t count, Counter& counter) {
    const std::size_t blocks = (count + tile_side - 1) / tile_side;
    std::array<std::uint64_t*, band_words> words;
    for (std::size_t w = 0; w < band_words; ++w) words[w] = counter.words[w].data() + 1;
    const std::size_t open = compare_band(matrix.lags, first, first_lag, blocks, words, counter.open.data());
    for (std::size_t k = 0; k < open; ++k) decide_tile(matrix, counter.open[k], first, first_lag, counter);
}

// A line of `length` points has ended at column end - 1, or a stretch without recurrence.
void end_stretch(const Matrix& matrix, DiagonalWord& word, std::size_t k, bool is_line, std::size_t length,
                 std::size_t end, Counter& counter) {
    word.points[k] += is_line ? length : 0;
    if (((word.diagonal >> k) & 1) == 0) return;
    const bool at_border = end == length || end + word.first_lag + k == matrix.points;
    if (is_line && matrix.settings.border_lines == BorderLines::discarded && at_border) return;
    if (is_line || length < Tally::small) counter.stretches[is_line ? 1 : 0].add(length);
}

// Diagonal lines that begin and end in these columns. Whether it is the one or the other no processor foresees: both
// are counted the same way. A bit that changes at a column changes at row column + lag.
void follow_diagonals(const Matrix& matrix, DiagonalWord& word, const std::uint64_t* words, std::size_t first,
                      std::size_t count, Counter& counter) {
    const std::size_t turns = list_turns(words, count, counter.turns.data());
    const bool plain = matrix.settings.border_lines == BorderLines::counted && ~word.diagonal == 0;
    for (std::size_t i = 0; i < turns; ++i) {
        const std::size_t c = counter.turns[i] / word_lags, k = counter.turns[i] % word_lags;
        const std::uint64_t bit = std::uint64_t{1} << k, has_ended = ((words[c] >> k) & 1) ^ 1;
        word.turns[c + k] ^= bit & word.vertical;
        const std::size_t length = first + c - word.turned[k];
        word.turned[k] = static_cast<std::uint32_t>(first + c);
        if (plain && length < Tally::small) {
            word.points[k] += length & (std::uint64_t{0} - has_ended);
            ++counter.stretches[has_ended].near[length];
        } else {
            end_stretch(matrix, word, k, has_ended != 0, length, first + c, counter);
        }
    }
    word.column = words[count - 1];
}

void add_vertical_lines(Matrix& matrix, DiagonalWord& word, std::uint64_t* words, std::size_t first, std::size_t count,
                        Counter& counter) {
    const LagLineTask task{matrix.points, &matrix.settings, &counter.columns};
    std::uint64_t bits = word.row;
    for (std::size_t c = 0; c < count; ++c) {
        bits ^= word.turns[c];
        counter.rows[c] = bits;
    }
    word.row = bits;
    if (~word.vertical != 0)
        for (std::size_t c = 0; c < count; ++c) words[c] &= word.vertical;
    std::copy(word.turns.begin() + chunk_columns, word.turns.end(), word.turns.begin());
    std::fill(word.turns.begin() + word_lags, word.turns.end(), 0);
    const std::size_t row = first + word.first_lag;
    add_lag_lines(task, Half::lower, words, count, first, word.first_lag, matrix.columns.data() + first);
    add_lag_lines(task, Half::upper, counter.rows.data(), count, row, word.first_lag, matrix.rows.data() + row);
}

// Lines that are still open end at the border; the points of every diagonal are known.
void end_word(const Matrix& matrix, DiagonalWord& word, Counter& counter) {
    for (std::size_t k = 0; k < word_lags; ++k) {
        const std::size_t lag = word.first_lag + k;
        if (((word.column >> k) & 1) != 0)
            end_stretch(matrix, word, k, true, matrix.points - lag - word.turned[k], matrix.points - lag, counter);
        if (word.points[k] == 0) continue;
        counter.points += 2 * word.points[k];
        if (lag < matrix.theiler) continue;
        counter.points_outside += 2 * word.points[k];
        matrix.totals.diagonal_points[lag] = word.points[k];
    }
}

void follow_band(Matrix& matrix, std::size_t band, Counter& counter) {
    std::vector<DiagonalWord>& words = counter.diagonals;
    words.clear();
    for (std::size_t lag = band * band_lags; lag < std::min((band + 1) * band_lags, matrix.points); lag += word_lags)
        words.emplace_back(matrix, lag);
    const std::size_t columns = matrix.points - words.front().first_lag;
    for (std::size_t first = 0; first < columns; first += chunk_columns) {
        const auto chunk = static_cast<std::uint32_t>(first / chunk_columns);
        while (matrix.done[band + 1].load(std::memory_order_acquire) <= chunk) std::this_thread::yield();
        find_bits(matrix, words.front().first_lag, first, std::min(chunk_columns, columns - first), counter);
        for (std::size_t w = words.size(); w-- > 0;) {
            if (first + words[w].first_lag >= matrix.points) continue;
            const std::size_t count = std::min(chunk_columns, matrix.points - words[w].first_lag - first);
            std::uint64_t* const bits = counter.words[w].data() + 1;
            bits[-1] = words[w].column;
            if (~words[w].inside != 0)
                for (std::size_t c = 0; c < count; ++c) bits[c] &= words[w].inside;
            follow_diagonals(matrix, words[w], bits, first, count, counter);
            add_vertical_lines(matrix, words[w], bits, first, count, counter);
        }
        counter.pairs += chunk_columns * band_lags;
        if (counter.pairs > std::uint64_t{1} << 31) counter.settle();
        matrix.done[band].store(chunk + 1, std::memory_order_release);
    }
    matrix.done[band].store(std::numeric_limits<std::uint32_t>::max(), std::memory_order_release);
    for (DiagonalWord& word : words) end_word(matrix, word, counter);
}

// The main diagonal's points, whose distance is 0 and within any bound that is followed here, and the columns it joins.
void join_columns(Matrix& matrix) {
    Counter counter(matrix.totals);
    counter.points = matrix.points;
    if (matrix.theiler == 0) counter.points_outside = matrix.points;
    const LagLineTask task{matrix.points, &matrix.settings, &counter.columns};
    const bool centre = matrix.theiler == 0 || !matrix.settings.window_on_vertical;
    for (std::size_t c = 0; c < matrix.points; ++c) join_halves(task, c, centre, matrix.columns[c], matrix.rows[c]);
    counter.flush(matrix.totals);
}

}  // namespace

bool can_follow_diagonals(const TiledMatrix& matrix) {
    return matrix.rows == matrix.columns && matrix.rows->row_numbers.empty() && !matrix.single_bounds.empty();
}

LineHistograms count_smooth_lines(const TiledMatrix& tiled, std::size_t which, int theiler, const Settings& settings) {
    const std::size_t n = tiled.rows->count;
    const Shape shape{n, n, true, theiler};
    Totals totals(shape);
    totals.main_diagonal = true;
    const SmoothPoints points(tiled);
    Matrix matrix{tiled,
                  which,
                  n,
                  static_cast<std::size_t>(theiler),
                  settings,
                  points.task(tiled, which),
                  totals,
                  std::vector<LagLine>(n, no_line),
                  std::vector<LagLine>(n, no_line),
                  std::vector<std::atomic<std::uint32_t>>((n + band_lags - 1) / band_lags + 1)};
    matrix.done.back() = std::numeric_limits<std::uint32_t>::max();
    // Bands are taken in order, so that a thread waits only for one that another thread is at.
    std::atomic<std::size_t> left{matrix.bands()};
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    tbb::parallel_for(
        std::size_t{0}, threads,
        [&](std::size_t) {
            Counter counter(totals);
            for (std::size_t band = left.fetch_sub(1); band > 0 && band <= matrix.bands(); band = left.fetch_sub(1))
                follow_band(matrix, band - 1, counter);
            counter.flush(totals);
        },
        tbb::simple_partitioner());
    join_columns(matrix);
    return histograms_of(shape, settings, totals);
}

}  // namespace swirl::analysis::recurrence::detail
