#include "analysis/recurrence/lag_lines.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/lag_line_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

// Bit k is set if words[k] is not 0, of up to 64 words.
std::uint64_t words_in_use(const std::uint64_t* words, std::size_t count) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::uint64_t in_use = 0;
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes) {
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(tag, hn::Ne(hn::LoadU(tag, words + k), hn::Zero(tag)), bits);
        in_use |= std::uint64_t{bits[0]} << k;
    }
    for (; k < count; ++k) in_use |= std::uint64_t{words[k] != 0} << k;
    return in_use;
}

// The time between two lines of one column is, in lags,
//     midpoints    farther.begin + floor(its length / 2) - nearer.end + floor(nearer length / 2)
//     white lines  farther.begin - nearer.end
//     line starts  farther.begin - nearer.begin below the main diagonal, farther.end - nearer.end above it
// The mark of the farther line is what stands for it there.
template <RecurrenceTime kind, Half half>
std::uint32_t mark_of(const LagLine& line) {
    if (kind == RecurrenceTime::line_starts && half == Half::upper) return line.end;
    return line.begin + (kind == RecurrenceTime::midpoints ? (line.end - line.begin) / 2 : 0);
}
template <RecurrenceTime kind, Half half>
std::uint32_t time_of(const LagLine& line) {
    if (kind == RecurrenceTime::line_starts && half == Half::lower) return line.mark - line.begin;
    return line.mark - line.end + (kind == RecurrenceTime::midpoints ? (line.end - line.begin) / 2 : 0);
}

// The lag that lies beyond the border of the matrix.
template <Half half>
std::size_t end_of_lags(std::size_t points, std::size_t index) {
    return half == Half::lower ? points - index : index + 1;
}

// What the border of the matrix adds: white lines that touch it, and lines that do, which may be discarded.
template <Half half>
void look_at_border(const LagLineTask& task, std::size_t index, const LagLine& line, std::size_t farthest) {
    const std::size_t end_of_lags = half == Half::lower ? task.points - index : index + 1;
    if (task.settings->border_lines == BorderLines::discarded && exists(line) && line.end == end_of_lags)
        task.tallies->lines.remove(line.end - line.begin);
    if (task.settings->border_white_lines && !exists(line) && farthest < end_of_lags)
        task.tallies->times.add(end_of_lags - farthest);
}

std::uint32_t highest_bit(std::uint64_t bits) {  // not 0
    return 63 - static_cast<std::uint32_t>(__builtin_clzll(bits));
}

// One column of a half, of which bits != 0 are 64 lags; `table`: where its tallies begin. Whether a line goes on, or a
// new one has come, no processor foresees: what goes on is entered as a line, and a time, of 0, and so is a line that
// does not exist.
template <RecurrenceTime kind, Half half, bool looks_at_border>
LagLine add_word(const LagLineTask& task, std::size_t index, std::uint64_t bits, std::uint32_t first_lag, LagLine line,
                 std::size_t table) {
    do {  // from the highest run of ones down
        const std::uint32_t top = highest_bit(bits);
        const std::uint64_t zeros = ~bits & ((std::uint64_t{2} << top) - 1);
        const std::uint32_t bottom = highest_bit(2 * zeros + 1), end = first_lag + top + 1;
        bits &= (std::uint64_t{1} << bottom) - 1;
        const bool goes_on = line.begin == end;
        const std::uint32_t ended = goes_on ? 0 : line.end - line.begin;
        const std::uint32_t time = goes_on ? 0 : time_of<kind, half>(line);
        if ((ended | time) < LineTallies::shortest) {
            ++task.tallies->near_lines[table + ended];
            ++task.tallies->near_times[table + time];
        } else {
            task.tallies->lines.add(ended);
            if (line.mark != no_line.mark) task.tallies->times.add(time);
        }
        if (looks_at_border && !goes_on) look_at_border<half>(task, index, line, end);
        line = {first_lag + bottom, goes_on ? line.end : end, goes_on ? line.mark : mark_of<kind, half>(line)};
    } while (bits != 0);
    return line;
}

// Neighbouring columns, whose lines are much the same, are entered in two tables by turns: one count need not wait for
// the one before.
template <RecurrenceTime kind, Half half, bool looks_at_border>
void add_lines(const LagLineTask& task, const std::uint64_t* words, std::size_t count, std::size_t first,
               std::size_t first_lag, LagLine* nearest) {
    for (std::size_t begin = 0; begin < count; begin += 64) {
        std::uint64_t left = words_in_use(words + begin, std::min<std::size_t>(64, count - begin));
        for (; left != 0; left &= left - 1) {
            const std::size_t i = begin + static_cast<std::size_t>(__builtin_ctzll(left));
            nearest[i] =
                add_word<kind, half, looks_at_border>(task, first + i, words[i], static_cast<std::uint32_t>(first_lag),
                                                      nearest[i], i % LineTallies::tables * LineTallies::shortest);
        }
    }
}

template <RecurrenceTime kind, Half half>
void add_lines_of_half(const LagLineTask& task, const std::uint64_t* words, std::size_t count, std::size_t first,
                       std::size_t first_lag, LagLine* nearest) {
    if (task.settings->border_lines == BorderLines::discarded || task.settings->border_white_lines)
        return add_lines<kind, half, true>(task, words, count, first, first_lag, nearest);
    add_lines<kind, half, false>(task, words, count, first, first_lag, nearest);
}

template <RecurrenceTime kind>
void add_lines_of(const LagLineTask& task, Half half, const std::uint64_t* words, std::size_t count, std::size_t first,
                  std::size_t first_lag, LagLine* nearest) {
    return half == Half::lower ? add_lines_of_half<kind, Half::lower>(task, words, count, first, first_lag, nearest)
                               : add_lines_of_half<kind, Half::upper>(task, words, count, first, first_lag, nearest);
}

}  // namespace

void add_lag_lines(const LagLineTask& task, Half half, const std::uint64_t* words, std::size_t count, std::size_t first,
                   std::size_t first_lag, LagLine* nearest) {
    switch (task.settings->recurrence_time) {
        case RecurrenceTime::midpoints:
            return add_lines_of<RecurrenceTime::midpoints>(task, half, words, count, first, first_lag, nearest);
        case RecurrenceTime::white_lines:
            return add_lines_of<RecurrenceTime::white_lines>(task, half, words, count, first, first_lag, nearest);
        case RecurrenceTime::line_starts:
            return add_lines_of<RecurrenceTime::line_starts>(task, half, words, count, first, first_lag, nearest);
    }
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(add_lag_lines);

void add_lag_lines(const LagLineTask& task, Half half, const std::uint64_t* words, std::size_t count, std::size_t first,
                   std::size_t first_lag, LagLine* nearest) {
    HWY_DYNAMIC_DISPATCH(add_lag_lines)(task, half, words, count, first, first_lag, nearest);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
