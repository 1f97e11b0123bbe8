#include "analysis/recurrence/line_counter.hpp"

#include "analysis/recurrence/block_join.hpp"
#include "analysis/recurrence/gaps.hpp"
#include "analysis/recurrence/line_block.hpp"

#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace swirl::analysis::recurrence::detail {
namespace {

// Of rows with gaps between them: each run of rows alone. Returns the points.
std::size_t vertical_lines_of_column(const Context& context, std::size_t c, const VerticalOptions& options,
                                     BlockCounter& counter) {
    const std::uint64_t* words = counter.column(c);
    const std::size_t first = context.frame.offset(c);
    const Presences* const presences = context.shape.presences;
    if (presences == nullptr)
        return vertical_lines(words, first, first + context.frame.rows, options, counter.vertical, counter.time);
    if (!presences->columns.has(c)) return 0;
    std::size_t points = 0;
    for (const PointRun& run : presences->rows.runs) {
        counter.stretch.assign(run.count / 64 + 2, 0);
        copy_bits(words, first + run.row, run.count, counter.stretch.data(), 0);
        points += vertical_lines(counter.stretch.data(), 0, run.count, options, counter.vertical, counter.time);
    }
    return points;
}

void add_column(Context& context, std::size_t c, std::size_t k, BlockCounter& counter) {
    const Settings& settings = context.settings;
    const VerticalOptions options{settings.recurrence_time, settings.border_white_lines, context.discard_border(),
                                  counter.changes.data()};
    std::uint64_t* words = counter.column(c);
    if (c == 0) context.totals[k].main_diagonal = (words[context.frame.origin >> 6] >> 63) != 0;
    if (!context.shape.vertical) {
        clear_window(context.frame, context.shape.theiler, words);
        return;
    }
    std::size_t points = 0;
    if (!settings.window_on_vertical) points = vertical_lines_of_column(context, c, options, counter);
    const std::size_t removed = clear_window(context.frame, context.shape.theiler, words);
    if (settings.window_on_vertical) points = vertical_lines_of_column(context, c, options, counter) + removed;
    counter.points += points;
    counter.points_outside += points - removed;
}

// Points per diagonal, within the largest square of the matrix: of columns begin ... c, which the ring holds; of one
// alone where the matrix has rows below the square.
void add_diagonal_points(const Context& context, std::size_t begin, std::size_t c, BlockCounter& counter) {
    const Frame& frame = context.frame;
    const std::size_t square = std::min(frame.rows, frame.columns), base = frame.lines_begin / 64;
    const std::size_t end = std::min(c + 1, square);
    if (begin >= end) return;
    const auto last_bit = [&](std::size_t k) { return frame.offset(k) + square - 1; };
    const std::size_t first = std::max(frame.first_word(end - 1), base), last = last_bit(begin) >> 6;
    if (last < first) return;
    std::array<const std::uint64_t*, 4> columns;
    columns.fill(counter.none.data());
    std::array<std::uint64_t, 4> whole{};
    for (std::size_t k = begin; k < end; ++k) {  // without the rows below the square in its last word
        std::uint64_t* words = counter.column(k);
        columns[k & 3] = words + base;
        whole[k & 3] = words[last_bit(k) >> 6];
        words[last_bit(k) >> 6] &= ~std::uint64_t{0} >> (63 - (last_bit(k) & 63));
    }
    add_to_planes(columns, first - base, last - base, counter.planes.data(), frame.line_words());
    for (std::size_t k = begin; k < end; ++k) counter.column(k)[last_bit(k) >> 6] = whole[k & 3];
}

// diagonal_step() has counted short lines without looking at the border: takes back those that touch it. (Lines in the
// first and the last two columns of the matrix are entered one by one and never come here.)
void take_back_border_lines(const Context& context, const DiagonalStep& step, ShortLines& shorts) {
    const auto bit = [](const std::uint64_t* words, std::size_t q) { return (words[q >> 6] >> (q & 63)) & 1; };
    const std::size_t rows = context.frame.rows, offset = context.frame.offset(step.column);
    const auto length_at = [&](std::size_t row) -> int {
        const std::size_t q = offset + row;
        if (q < context.frame.lines_begin || !bit(step.current, q) || bit(step.previous, q)) return 0;
        return !bit(step.next, q) ? 1 : !bit(step.after_next, q) ? 2 : 0;
    };
    const auto take = [&](int length) {
        shorts.singles -= length == 1;
        shorts.doubles -= length == 2;
    };
    take(length_at(0));
    if (rows > 1) take(length_at(rows - 1));
    if (rows > 2 && length_at(rows - 2) == 2) take(2);
}

void follow_diagonals(const Context& context, std::size_t begin, std::size_t end, std::size_t c, BlockCounter& counter,
                      BlockBorder& border) {
    const Frame& frame = context.frame;
    DiagonalStep step{counter.column(c + 3),
                      counter.column(c),
                      counter.column(c + 1),
                      counter.column(c + 2),
                      counter.open.data(),
                      counter.begun.data(),
                      frame.lines_begin,
                      std::max(frame.first_word(c), frame.lines_begin >> 6),
                      frame.last_word(c),
                      static_cast<std::uint32_t>(c),
                      context.enter_all() || c == begin || c + 2 >= end,
                      c + 1 == end};
    if (step.last_word < step.first_word) return;
    counter.ended.clear();
    diagonal_step(step, counter.shorts, counter.ended);
    if (!step.enter_all && context.discard_border()) take_back_border_lines(context, step, counter.shorts);
    for (const DiagonalLine& line : counter.ended) {
        if (line.first == begin)
            border.heads.push_back(line);
        else if (context.counts(line))
            counter.diagonal.add(line.last - line.first + 1);
    }
}

void collect_tails(const Context& context, std::size_t end, BlockCounter& counter, BlockBorder& border) {
    for (std::size_t w = context.frame.lines_begin >> 6; w < context.frame.words; ++w)
        for (std::uint64_t bits = counter.open[w]; bits != 0; bits &= bits - 1) {
            const std::size_t q = w * 64 + static_cast<std::size_t>(std::countr_zero(bits));
            border.tails.push_back({static_cast<std::uint32_t>(q), counter.begun[q - context.frame.lines_begin],
                                    static_cast<std::uint32_t>(end - 1)});
        }
}

void flush_planes(const Frame& frame, const BlockCounter& counter, Totals& totals) {
    for (std::size_t w = 0; w < frame.line_words(); ++w) {
        std::array<std::uint32_t, 64> counts{};
        for (std::size_t p = 0; p < plane_count; ++p)
            for (std::uint64_t bits = counter.planes[p * frame.line_words() + w]; bits != 0; bits &= bits - 1)
                counts[static_cast<std::size_t>(std::countr_zero(bits))] += 1u << p;
        for (std::size_t b = 0; b < 64; ++b) {
            if (counts[b] == 0) continue;
            const std::size_t q = frame.lines_begin + w * 64 + b;
            const std::size_t k = q > frame.origin ? q - frame.origin : frame.origin - q;
            std::atomic_ref(totals.diagonal_points[k]).fetch_add(counts[b], std::memory_order_relaxed);
        }
    }
}

void flush(const Frame& frame, BlockCounter& counter, Totals& totals) {
    counter.diagonal.near[1] += counter.shorts.singles;
    counter.diagonal.near[2] += counter.shorts.doubles;
    counter.diagonal.flush();
    counter.vertical.flush();
    counter.time.flush();
    std::atomic_ref(totals.points).fetch_add(counter.points, std::memory_order_relaxed);
    std::atomic_ref(totals.points_outside).fetch_add(counter.points_outside, std::memory_order_relaxed);
    flush_planes(frame, counter, totals);
}

// Columns begin ... end - 1. A diagonal is followed at column c once the two columns after it are there.
void count_block(Context& context, std::size_t begin, std::size_t end, const ColumnSource& source,
                 std::span<BlockBorder> borders) {
    const Frame& frame = context.frame;
    std::vector<BlockCounter> counters;
    for (Totals& totals : context.totals) counters.emplace_back(frame, totals);
    std::vector<std::uint64_t*> columns(counters.size());
    for (std::size_t c = begin; c < end + 2; ++c) {
        for (std::size_t k = 0; k < counters.size(); ++k) {
            columns[k] = counters[k].column(c);
            clear_column(frame, c, columns[k]);
        }
        if (c < end) source(c, frame.offset(c), columns);
        for (std::size_t k = 0; k < counters.size(); ++k) {
            if (c < end) {
                add_column(context, c, k, counters[k]);
                const bool below = frame.rows > frame.columns;
                if (below || (c & 3) == 3 || c + 1 == end)
                    add_diagonal_points(context, below ? c : std::max(begin, c & ~std::size_t{3}), c, counters[k]);
            }
            if (c >= begin + 2) follow_diagonals(context, begin, end, c - 2, counters[k], borders[k]);
        }
    }
    for (std::size_t k = 0; k < counters.size(); ++k) {
        borders[k].begin = begin;
        collect_tails(context, end, counters[k], borders[k]);
        flush(frame, counters[k], context.totals[k]);
    }
}

}  // namespace

LineHistograms histograms_of(const Shape& shape, const Settings& settings, Totals& totals) {
    if (shape.symmetric) {
        if (settings.triangles == Triangles::both)
            for (std::uint64_t& count : totals.diagonal) count *= 2;
        for (std::uint64_t& count : totals.diagonal_points) count *= 2;
        if (shape.theiler == 0 && totals.main_diagonal) {
            std::vector<PointRun> runs{{0, 0, shape.rows}};
            if (shape.presences != nullptr) runs = shape.presences->rows.runs;
            for (const PointRun& run : runs) {
                if (settings.border_lines == BorderLines::counted) ++totals.diagonal[run.count];
                totals.diagonal_points[0] += run.count;
            }
        }
    }
    trim_zeros(totals.diagonal);
    trim_zeros(totals.vertical);
    trim_zeros(totals.time);
    return {shape.rows,
            shape.columns,
            shape.theiler,
            shape.symmetric,
            totals.points,
            totals.points_outside,
            std::move(totals.diagonal),
            std::move(totals.vertical),
            std::move(totals.time),
            std::move(totals.diagonal_points),
            0,
            0,
            {}};
}

void trim_zeros(std::vector<std::uint64_t>& histogram) {
    while (histogram.size() > 1 && histogram.back() == 0) histogram.pop_back();
    histogram.shrink_to_fit();
}

std::vector<LineHistograms> count_all_lines(const Shape& shape, std::size_t thresholds, const Settings& settings,
                                            const std::function<ColumnSource()>& make_source) {
    Context context{shape, settings, Frame(shape), {}};
    for (std::size_t k = 0; k < thresholds; ++k) context.totals.emplace_back(shape);
    // Four blocks per thread, so that the lighter columns of a triangle balance; the counters of a block hold 16 bits.
    constexpr std::size_t least = 256, most = (std::size_t{1} << plane_count) - 1;
    const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
    const std::size_t size = std::clamp(shape.columns / (16 * threads) + 1, least, most);
    const std::size_t blocks = (shape.columns + size - 1) / size;
    std::vector<std::vector<BlockBorder>> borders(blocks, std::vector<BlockBorder>(thresholds));
    tbb::parallel_for(
        std::size_t{0}, blocks,
        [&](std::size_t b) {
            count_block(context, b * size, std::min((b + 1) * size, shape.columns), make_source(), borders[b]);
        },
        tbb::simple_partitioner());
    std::vector<LineHistograms> result;
    for (std::size_t k = 0; k < thresholds; ++k) {
        std::vector<const BlockBorder*> of_threshold;
        of_threshold.reserve(borders.size());
        for (const auto& border : borders) of_threshold.push_back(&border[k]);
        std::vector<std::uint64_t>& histogram = context.totals[k].diagonal;
        join_blocks(of_threshold, context.frame.lines_begin, context.frame.words * 64, [&](const DiagonalLine& line) {
            if (context.counts(line)) ++histogram[line.last - line.first + 1];
        });
        result.push_back(histograms_of(shape, settings, context.totals[k]));
    }
    return result;
}

}  // namespace swirl::analysis::recurrence::detail
