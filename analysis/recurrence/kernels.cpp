#include "analysis/recurrence/kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Adds coordinate m to keys (or starts them). Kind: how coordinates combine.
enum class Combine { first, maximum, sum, square, first_square };

template <Combine combine, bool angle>
double combine_one(double key, double d, double period) {
    if constexpr (angle) d = std::min(d, period - d);
    if constexpr (combine == Combine::first) return d;
    if constexpr (combine == Combine::first_square) return d * d;
    if constexpr (combine == Combine::maximum) return std::max(key, d);
    if constexpr (combine == Combine::sum) return key + d;
    if constexpr (combine == Combine::square) return key + d * d;
}

template <Combine combine, bool angle>
void add_coordinate(const double* x, double centre, double period, std::size_t count, double* keys) {
    const hn::ScalableTag<double> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto c = hn::Set(tag, centre);
    const auto p = hn::Set(tag, period);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        auto d = hn::Abs(hn::Sub(hn::LoadU(tag, x + i), c));
        if constexpr (angle) d = hn::Min(d, hn::Sub(p, d));
        if constexpr (combine == Combine::first_square) d = hn::Mul(d, d);
        if constexpr (combine == Combine::maximum) d = hn::Max(hn::LoadU(tag, keys + i), d);
        if constexpr (combine == Combine::sum) d = hn::Add(hn::LoadU(tag, keys + i), d);
        if constexpr (combine == Combine::square) d = hn::Add(hn::LoadU(tag, keys + i), hn::Mul(d, d));
        hn::StoreU(d, tag, keys + i);
    }
    for (; i < count; ++i) keys[i] = combine_one<combine, angle>(keys[i], std::fabs(x[i] - centre), period);
}

template <Combine combine>
void add_any(const double* x, double centre, double period, std::size_t count, double* keys) {
    if (period > 0)
        add_coordinate<combine, true>(x, centre, period, count, keys);
    else
        add_coordinate<combine, false>(x, centre, period, count, keys);
}

// The commonest case in one sweep instead of three: a Euclidean distance of three plain coordinates. Same operations,
// same order.
void euclidean_3(const KeyTask& task, std::size_t begin, std::size_t count, double* keys) {
    const hn::ScalableTag<double> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const double* x = task.coordinates[0] + begin;
    const double* y = task.coordinates[1] + begin;
    const double* z = task.coordinates[2] + begin;
    const auto cx = hn::Set(tag, task.centre[0]);
    const auto cy = hn::Set(tag, task.centre[1]);
    const auto cz = hn::Set(tag, task.centre[2]);
    std::size_t i = 0;
    for (; i + lanes <= count; i += lanes) {
        const auto dx = hn::Sub(hn::LoadU(tag, x + i), cx);
        const auto dy = hn::Sub(hn::LoadU(tag, y + i), cy);
        const auto dz = hn::Sub(hn::LoadU(tag, z + i), cz);
        hn::StoreU(hn::Add(hn::Add(hn::Mul(dx, dx), hn::Mul(dy, dy)), hn::Mul(dz, dz)), tag, keys + i);
    }
    for (; i < count; ++i) {
        const double dx = x[i] - task.centre[0], dy = y[i] - task.centre[1], dz = z[i] - task.centre[2];
        keys[i] = dx * dx + dy * dy + dz * dz;
    }
}

void compute_keys(const KeyTask& task, std::size_t begin, std::size_t count, double* keys) {
    const bool squares = task.norm == Norm::euclidean && task.dimension > 1;
    if (squares && task.dimension == 3 && task.periods[0] == 0 && task.periods[1] == 0 && task.periods[2] == 0)
        return euclidean_3(task, begin, count, keys);
    for (int m = 0; m < task.dimension; ++m) {
        const double* x = task.coordinates[m] + begin;
        if (m == 0 && squares)
            add_any<Combine::first_square>(x, task.centre[m], task.periods[m], count, keys);
        else if (m == 0)
            add_any<Combine::first>(x, task.centre[m], task.periods[m], count, keys);
        else if (squares)
            add_any<Combine::square>(x, task.centre[m], task.periods[m], count, keys);
        else if (task.norm == Norm::maximum)
            add_any<Combine::maximum>(x, task.centre[m], task.periods[m], count, keys);
        else
            add_any<Combine::sum>(x, task.centre[m], task.periods[m], count, keys);
    }
}

// 64 keys to 64 bits.
std::uint64_t word_of_keys(const double* keys, double bound) {
    const hn::ScalableTag<double> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto b = hn::Set(tag, bound);
    std::uint64_t word = 0;
    for (std::size_t i = 0; i < 64; i += lanes) {
        alignas(8) std::uint8_t bits[8] = {};
        hn::StoreMaskBits(tag, hn::Le(hn::LoadU(tag, keys + i), b), bits);
        word |= static_cast<std::uint64_t>(bits[0]) << i;
    }
    return word;
}

void mask_keys(const double* keys, std::size_t count, double bound, std::uint64_t* words) {
    std::size_t i = 0;
    for (; i + 64 <= count; i += 64) words[i / 64] = word_of_keys(keys + i, bound);
    if (i < count) {
        std::uint64_t word = 0;
        for (std::size_t k = 0; i + k < count; ++k) word |= static_cast<std::uint64_t>(keys[i + k] <= bound) << k;
        words[i / 64] = word;
    }
}

std::size_t count_keys(const double* keys, std::size_t count, double bound) {
    std::size_t total = 0, i = 0;
    for (; i + 64 <= count; i += 64) total += static_cast<std::size_t>(std::popcount(word_of_keys(keys + i, bound)));
    for (; i < count; ++i) total += keys[i] <= bound;
    return total;
}

void scatter_rows(const std::uint32_t* order, std::size_t begin, std::size_t end, std::size_t offset,
                  std::uint64_t* words) {
    for (std::size_t k = begin; k < end; ++k) {
        const std::size_t q = order[k] + offset;
        words[q >> 6] |= std::uint64_t{1} << (q & 63);
    }
}

// Writes where the colour changes along the bits of words first_word ... last_word: the begin of a line, the first bit
// after it, and so on. Four positions are written per word whether or not there are so many and the next word overwrites
// the excess: at a few per cent of points, branches on the bits would nearly all be mispredicted (as in simdjson).
std::size_t list_changes(const std::uint64_t* words, std::size_t first_word, std::size_t last_word,
                         std::uint32_t* changes, std::size_t& points) {
    std::uint32_t* out = changes;
    std::uint64_t carry = 0;
    std::size_t set = 0;
    for (std::size_t w = first_word; w <= last_word; ++w) {
        const std::uint64_t x = words[w];
        std::uint64_t change = x ^ ((x << 1) | carry);
        carry = x >> 63;
        set += static_cast<std::size_t>(std::popcount(x));
        const auto count = static_cast<std::size_t>(std::popcount(change));
        const auto base = static_cast<std::uint32_t>(w << 6);
        for (std::size_t k = 0; k < 4; ++k, change &= change - 1)  // the top bit keeps the count defined without a branch
            out[k] = base + static_cast<std::uint32_t>(__builtin_ctzll(change | (std::uint64_t{1} << 63)));
        for (std::size_t k = 4; change != 0; ++k, change &= change - 1)
            out[k] = base + static_cast<std::uint32_t>(std::countr_zero(change));
        out += count;
    }
    if (carry != 0) *out++ = static_cast<std::uint32_t>((last_word + 1) << 6);
    points = set;
    return static_cast<std::size_t>(out - changes);
}

// Most lines are very short. Four tables by turns, so that one count need not wait for the one before.
void tally_lengths(const std::uint32_t* changes, std::size_t count, Tally& lines) {
    constexpr std::size_t tables = 4, shortest = 64;
    std::uint32_t counts[tables][shortest] = {};
    for (std::size_t k = 0; k < count; k += 2) {
        const std::size_t length = changes[k + 1] - changes[k];
        if (length < shortest)
            ++counts[(k >> 1) % tables][length];
        else
            lines.add(length);
    }
    for (std::size_t l = 1; l < shortest; ++l)
        lines.near[l] += std::uint64_t{counts[0][l]} + counts[1][l] + counts[2][l] + counts[3][l];
}

template <RecurrenceTime kind>
std::size_t scan_column(const std::uint64_t* words, std::size_t first, std::size_t last,
                        const VerticalOptions& options, Tally& lines, Tally& times) {
    std::size_t points = 0;
    const std::size_t count = list_changes(words, first >> 6, (last - 1) >> 6, options.changes, points);
    const std::uint32_t* changes = options.changes;
    tally_lengths(changes, count, lines);
    for (std::size_t k = 2; k < count; k += 2) {
        std::size_t time = changes[k] - changes[k - 1];
        if constexpr (kind == RecurrenceTime::midpoints)
            time += (changes[k - 1] - changes[k - 2]) / 2 + (changes[k + 1] - changes[k]) / 2;
        if constexpr (kind == RecurrenceTime::line_starts) time = changes[k] - changes[k - 2];
        times.add(time);
    }
    const bool at_first = count > 0 && changes[0] == first, at_last = count > 0 && changes[count - 1] == last;
    if (options.discard_border_lines) {
        if (at_first) lines.remove(changes[1] - changes[0]);
        if (at_last && !(at_first && count == 2)) lines.remove(changes[count - 1] - changes[count - 2]);
    }
    if (options.border_white_lines) {
        if (count == 0) times.add(last - first);
        if (count > 0 && !at_first) times.add(changes[0] - first);
        if (count > 0 && !at_last) times.add(last - changes[count - 1]);
    }
    return points;
}

std::size_t vertical_lines(const std::uint64_t* words, std::size_t first, std::size_t last,
                           const VerticalOptions& options, Tally& lines, Tally& times) {
    switch (options.recurrence_time) {
        case RecurrenceTime::midpoints:
            return scan_column<RecurrenceTime::midpoints>(words, first, last, options, lines, times);
        case RecurrenceTime::white_lines:
            return scan_column<RecurrenceTime::white_lines>(words, first, last, options, lines, times);
        case RecurrenceTime::line_starts:
            return scan_column<RecurrenceTime::line_starts>(words, first, last, options, lines, times);
    }
    return 0;
}

// Enters the lines that begin in word w and takes out those that end.
void enter_and_end(const DiagonalStep& s, std::size_t w, std::uint64_t enter, std::uint64_t next,
                   std::vector<DiagonalLine>& ended) {
    std::uint64_t open = s.open[w] | enter;
    const std::size_t base = w << 6;
    for (; enter != 0; enter &= enter - 1)
        s.begun[base - s.frame_begin + static_cast<std::size_t>(std::countr_zero(enter))] = s.column;
    if (!s.last_column) {
        std::uint64_t ends = open & ~next;
        open &= next;
        for (; ends != 0; ends &= ends - 1) {
            const std::size_t q = base + static_cast<std::size_t>(std::countr_zero(ends));
            ended.push_back({static_cast<std::uint32_t>(q), s.begun[q - s.frame_begin], s.column});
        }
    }
    s.open[w] = open;
}

void diagonal_step(const DiagonalStep& s, ShortLines& shorts, std::vector<DiagonalLine>& ended) {
    std::size_t w = s.first_word;
    if (s.enter_all) {
        for (; w <= s.last_word; ++w)
            if (s.current[w] != 0) enter_and_end(s, w, s.current[w] & ~s.previous[w], s.next[w], ended);
        return;
    }
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    auto singles = hn::Zero(tag), doubles = hn::Zero(tag);
    for (; w + lanes <= s.last_word + 1; w += lanes) {
        const auto now = hn::LoadU(tag, s.current + w), next = hn::LoadU(tag, s.next + w);
        const auto starts = hn::AndNot(hn::LoadU(tag, s.previous + w), now);
        const auto two = hn::And(starts, next), after = hn::LoadU(tag, s.after_next + w);
        singles = hn::Add(singles, hn::PopulationCount(hn::AndNot(next, starts)));
        doubles = hn::Add(doubles, hn::PopulationCount(hn::AndNot(after, two)));
        const auto enter = hn::And(two, after);
        const auto changed = hn::Or(enter, hn::AndNot(next, hn::LoadU(tag, s.open + w)));
        if (hn::AllTrue(tag, hn::Eq(changed, hn::Zero(tag)))) continue;
        HWY_ALIGN std::uint64_t entered[HWY_MAX_BYTES / 8], work[HWY_MAX_BYTES / 8];
        hn::Store(enter, tag, entered);
        hn::Store(changed, tag, work);
        for (std::size_t k = 0; k < lanes; ++k)
            if (work[k] != 0) enter_and_end(s, w + k, entered[k], s.next[w + k], ended);
    }
    shorts.singles += hn::GetLane(hn::SumOfLanes(tag, singles));
    shorts.doubles += hn::GetLane(hn::SumOfLanes(tag, doubles));
    for (; w <= s.last_word; ++w) {
        const std::uint64_t next = s.next[w], starts = s.current[w] & ~s.previous[w], two = starts & next;
        shorts.singles += static_cast<std::uint64_t>(std::popcount(starts & ~next));
        shorts.doubles += static_cast<std::uint64_t>(std::popcount(two & ~s.after_next[w]));
        enter_and_end(s, w, two & s.after_next[w], next, ended);
    }
}

void add_to_planes(const std::uint64_t* words, std::size_t first, std::size_t last, std::uint64_t* planes,
                   std::size_t plane_stride) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::size_t w = first;
    for (; w + lanes <= last + 1; w += lanes) {
        auto carry = hn::LoadU(tag, words + w);
        // Carries rarely reach the seventh plane, so the branch there is well predicted; lower down it would not be.
        for (std::size_t p = 0; p < plane_count; ++p) {
            if (p >= 6 && hn::AllTrue(tag, hn::Eq(carry, hn::Zero(tag)))) break;
            std::uint64_t* plane = planes + p * plane_stride + w;
            const auto old = hn::LoadU(tag, plane);
            hn::StoreU(hn::Xor(old, carry), tag, plane);
            carry = hn::And(old, carry);
        }
    }
    for (; w <= last; ++w) {
        std::uint64_t carry = words[w];
        for (std::size_t p = 0; p < plane_count && carry != 0; ++p) {
            std::uint64_t& plane = planes[p * plane_stride + w];
            const std::uint64_t both = plane & carry;
            plane ^= carry;
            carry = both;
        }
    }
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(compute_keys);
HWY_EXPORT(mask_keys);
HWY_EXPORT(count_keys);
HWY_EXPORT(scatter_rows);
HWY_EXPORT(vertical_lines);
HWY_EXPORT(diagonal_step);
HWY_EXPORT(add_to_planes);

void compute_keys(const KeyTask& task, std::size_t begin, std::size_t count, double* keys) {
    HWY_DYNAMIC_DISPATCH(compute_keys)(task, begin, count, keys);
}
void mask_keys(const double* keys, std::size_t count, double bound, std::uint64_t* words) {
    HWY_DYNAMIC_DISPATCH(mask_keys)(keys, count, bound, words);
}
std::size_t count_keys(const double* keys, std::size_t count, double bound) {
    return HWY_DYNAMIC_DISPATCH(count_keys)(keys, count, bound);
}
void scatter_rows(const std::uint32_t* order, std::size_t begin, std::size_t end, std::size_t offset,
                  std::uint64_t* words) {
    HWY_DYNAMIC_DISPATCH(scatter_rows)(order, begin, end, offset, words);
}
std::size_t vertical_lines(const std::uint64_t* words, std::size_t first, std::size_t last,
                           const VerticalOptions& options, Tally& lines, Tally& times) {
    return HWY_DYNAMIC_DISPATCH(vertical_lines)(words, first, last, options, lines, times);
}
void diagonal_step(const DiagonalStep& step, ShortLines& shorts, std::vector<DiagonalLine>& ended) {
    HWY_DYNAMIC_DISPATCH(diagonal_step)(step, shorts, ended);
}
void add_to_planes(const std::uint64_t* words, std::size_t first, std::size_t last, std::uint64_t* planes,
                   std::size_t plane_stride) {
    HWY_DYNAMIC_DISPATCH(add_to_planes)(words, first, last, planes, plane_stride);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
