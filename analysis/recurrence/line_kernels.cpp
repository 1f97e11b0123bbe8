#include "analysis/recurrence/line_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/line_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <algorithm>
#include <bit>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void scatter_rows(const std::uint32_t* order, std::size_t begin, std::size_t end, std::size_t offset,
                  std::uint64_t* words) {
    for (std::size_t k = begin; k < end; ++k) {
        const std::size_t q = order[k] + offset;
        words[q >> 6] |= std::uint64_t{1} << (q & 63);
    }
}

// Appends base + k for every bit k of `bits`, which is not 0. Four positions are written whether or not there are so
// many, and the next call overwrites the excess: at a few per cent of points, a branch per bit would nearly always be
// mispredicted (as in simdjson).
std::uint32_t* list_bits(std::uint64_t bits, std::uint32_t base, std::uint32_t* out) {
    std::uint32_t* const end = out + std::popcount(bits);
    for (std::size_t k = 0; k < 4; ++k, bits &= bits - 1)  // the top bit keeps the count defined without a branch
        out[k] = base + static_cast<std::uint32_t>(__builtin_ctzll(bits | (std::uint64_t{1} << 63)));
    for (std::size_t k = 4; bits != 0; ++k, bits &= bits - 1)
        out[k] = base + static_cast<std::uint32_t>(__builtin_ctzll(bits));
    return end;
}

// Writes where the colour changes along the bits of words first ... last: the begin of a line, the first bit after it,
// and so on. 64 words at a time: first which of them have a change at all, as the bits of one word.
std::size_t list_changes(const std::uint64_t* words, std::size_t first, std::size_t last, std::uint32_t* changes,
                         std::size_t& points) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::uint64_t change[64];
    std::uint32_t* out = changes;
    points = static_cast<std::size_t>(std::popcount(words[first]));
    if (const std::uint64_t x = words[first] ^ (words[first] << 1); x != 0)
        out = list_bits(x, static_cast<std::uint32_t>(first << 6), out);
    auto set = hn::Zero(tag);
    for (std::size_t begin = first + 1; begin <= last; begin += 64) {
        const std::size_t count = std::min<std::size_t>(64, last + 1 - begin);
        std::uint64_t changed = 0;
        std::size_t k = 0;
        for (; k + lanes <= count; k += lanes) {
            const auto x = hn::LoadU(tag, words + begin + k);
            const auto carry = hn::ShiftRight<63>(hn::LoadU(tag, words + begin + k - 1));
            const auto difference = hn::Xor(x, hn::Or(hn::ShiftLeft<1>(x), carry));
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(tag, hn::Ne(difference, hn::Zero(tag)), bits);
            changed |= static_cast<std::uint64_t>(bits[0]) << k;
            hn::StoreU(difference, tag, change + k);
            set = hn::Add(set, hn::PopulationCount(x));
        }
        for (; k < count; ++k) {
            const std::uint64_t x = words[begin + k];
            change[k] = x ^ ((x << 1) | (words[begin + k - 1] >> 63));
            changed |= static_cast<std::uint64_t>(change[k] != 0) << k;
            points += static_cast<std::size_t>(std::popcount(x));
        }
        for (; changed != 0; changed &= changed - 1) {
            const auto which = static_cast<std::size_t>(std::countr_zero(changed));
            out = list_bits(change[which], static_cast<std::uint32_t>((begin + which) << 6), out);
        }
    }
    if (words[last] >> 63 != 0) *out++ = static_cast<std::uint32_t>((last + 1) << 6);
    points += static_cast<std::size_t>(hn::GetLane(hn::SumOfLanes(tag, set)));
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
std::size_t scan_column(const std::uint64_t* words, std::size_t first, std::size_t last, const VerticalOptions& options,
                        Tally& lines, Tally& times) {
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

HWY_EXPORT(scatter_rows);
HWY_EXPORT(vertical_lines);
HWY_EXPORT(diagonal_step);
HWY_EXPORT(add_to_planes);

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
