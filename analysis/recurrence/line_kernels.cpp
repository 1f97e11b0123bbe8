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

// Appends base + k for every bit k of `bits`, which is not 0. Mostly there are one or two, the lowest and the highest;
// else four positions are written whether or not there are so many, and the next call overwrites the excess: a branch
// per bit would often be mispredicted (as in simdjson).
HWY_INLINE std::uint32_t* list_bits(std::uint64_t bits, std::uint32_t base, std::uint32_t* out) {
    const int count = std::popcount(bits);
    if (count <= 2) {
        out[0] = base + static_cast<std::uint32_t>(std::countr_zero(bits));
        out[1] = base + 63 - static_cast<std::uint32_t>(std::countl_zero(bits));
        return out + count;
    }
    for (std::size_t k = 0; k < 4; ++k, bits &= bits - 1)  // the top bit keeps the count defined without a branch
        out[k] = base + static_cast<std::uint32_t>(__builtin_ctzll(bits | (std::uint64_t{1} << 63)));
    for (std::size_t k = 4; bits != 0; ++k, bits &= bits - 1)
        out[k] = base + static_cast<std::uint32_t>(__builtin_ctzll(bits));
    return out + count;
}

// Writes where the colour changes along the bits of words first ... last: the begin of a line, the first bit after it,
// and so on. 64 words at a time: first which of them have a change at all, as the bits of one word.
std::size_t list_changes(const std::uint64_t* words, std::size_t first, std::size_t last, std::uint32_t* changes) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    std::uint64_t change[64];
    std::uint32_t* out = changes;
    if (const std::uint64_t x = words[first] ^ (words[first] << 1); x != 0)
        out = list_bits(x, static_cast<std::uint32_t>(first << 6), out);
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
        }
        for (; k < count; ++k) {
            const std::uint64_t x = words[begin + k];
            change[k] = x ^ ((x << 1) | (words[begin + k - 1] >> 63));
            changed |= static_cast<std::uint64_t>(change[k] != 0) << k;
        }
        for (; changed != 0; changed &= changed - 1) {
            const auto which = static_cast<std::size_t>(std::countr_zero(changed));
            out = list_bits(change[which], static_cast<std::uint32_t>((begin + which) << 6), out);
        }
    }
    if (words[last] >> 63 != 0) *out++ = static_cast<std::uint32_t>((last + 1) << 6);
    return static_cast<std::size_t>(out - changes);
}

std::size_t list_turns(const std::uint64_t* words, std::size_t count, std::uint32_t* turns) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const std::uint64_t* const before = words - 1;  // there is a word before the first
    std::uint32_t* out = turns;
    for (std::size_t begin = 0; begin < count; begin += 64) {
        const std::size_t end = std::min(begin + 64, count);
        std::uint64_t turned = 0;
        std::size_t c = begin;
        for (; c + lanes <= end; c += lanes) {
            std::uint8_t bits[8] = {};
            hn::StoreMaskBits(tag, hn::Ne(hn::LoadU(tag, words + c), hn::LoadU(tag, before + c)), bits);
            turned |= std::uint64_t{bits[0]} << (c - begin);
        }
        for (; c < end; ++c) turned |= std::uint64_t{words[c] != before[c]} << (c - begin);
        for (; turned != 0; turned &= turned - 1) {
            const std::size_t at = begin + static_cast<std::size_t>(std::countr_zero(turned));
            out = list_bits(words[at] ^ before[at], static_cast<std::uint32_t>(at * 64), out);
        }
    }
    return static_cast<std::size_t>(out - turns);
}

// Most lines are very short. Four tables by turns, so that one count need not wait for the one before. How many points.
std::size_t tally_lengths(const std::uint32_t* changes, std::size_t count, Tally& lines) {
    constexpr std::size_t tables = 4, shortest = 64;
    std::uint32_t counts[tables][shortest] = {};
    std::size_t points = 0;
    for (std::size_t k = 0; k < count; k += 2) {
        const std::size_t length = changes[k + 1] - changes[k];
        points += length;
        if (length < shortest)
            ++counts[(k >> 1) % tables][length];
        else
            lines.add(length);
    }
    for (std::size_t l = 1; l < shortest; ++l)
        lines.near[l] += std::uint64_t{counts[0][l]} + counts[1][l] + counts[2][l] + counts[3][l];
    return points;
}

template <RecurrenceTime kind>
std::size_t scan_column(const std::uint64_t* words, std::size_t first, std::size_t last, const VerticalOptions& options,
                        Tally& lines, Tally& times) {
    const std::size_t count = list_changes(words, first >> 6, (last - 1) >> 6, options.changes);
    const std::uint32_t* changes = options.changes;
    const std::size_t points = tally_lengths(changes, count, lines);
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

// Lines that begin at, or end at, the bits of one word.
void enter(const DiagonalStep& s, std::size_t w, std::uint64_t bits) {
    std::uint32_t* const begun = s.begun + ((w << 6) - s.frame_begin);
    for (; bits != 0; bits &= bits - 1) begun[std::countr_zero(bits)] = s.column;
}
void end(const DiagonalStep& s, std::size_t w, std::uint64_t bits, std::vector<DiagonalLine>& ended) {
    const std::uint32_t* const begun = s.begun + ((w << 6) - s.frame_begin);
    for (; bits != 0; bits &= bits - 1) {
        const int k = std::countr_zero(bits);
        ended.push_back({static_cast<std::uint32_t>((w << 6) + static_cast<std::size_t>(k)), begun[k], s.column});
    }
}

// Next to the block's border: every line is entered.
void border_step(const DiagonalStep& s, std::vector<DiagonalLine>& ended) {
    for (std::size_t w = s.first_word; w <= s.last_word; ++w) {
        const std::uint64_t begins = s.current[w] & ~s.previous[w];
        enter(s, w, begins);
        s.open[w] |= begins;
        if (s.last_column) continue;
        end(s, w, s.open[w] & ~s.next[w], ended);
        s.open[w] &= s.next[w];
    }
}

// The lines that begin (three points and more) and end in up to 64 words from `begin` on: `entered` and `ending` hold
// their bits, word by word, and the result's bits say which of these words are not 0.
struct Busy {
    std::uint64_t entered = 0, ending = 0;
};
Busy step_words(const DiagonalStep& s, std::size_t begin, std::size_t count, std::uint64_t* entered,
                std::uint64_t* ending, ShortLines& shorts) {
    const hn::ScalableTag<std::uint64_t> tag;
    const std::size_t lanes = hn::Lanes(tag);
    const auto zero = hn::Zero(tag);
    auto singles = zero, doubles = zero;
    Busy busy;
    std::size_t k = 0;
    for (; k + lanes <= count; k += lanes) {
        const std::size_t w = begin + k;
        const auto now = hn::LoadU(tag, s.current + w), next = hn::LoadU(tag, s.next + w);
        const auto open = hn::LoadU(tag, s.open + w);
        const auto starts = hn::AndNot(hn::LoadU(tag, s.previous + w), now), two = hn::And(starts, next);
        const auto single = hn::AndNot(next, starts);
        const auto after = hn::LoadU(tag, s.after_next + w);
        const auto twin = hn::AndNot(after, two), three = hn::And(two, after), ends = hn::AndNot(next, open);
        // Counting bits costs more than all the rest, and where lines are long there are few of these.
        if (!hn::AllTrue(tag, hn::Eq(hn::Or(single, twin), zero))) {
            singles = hn::Add(singles, hn::PopulationCount(single));
            doubles = hn::Add(doubles, hn::PopulationCount(twin));
        }
        hn::StoreU(hn::Or(hn::And(open, next), three), tag, s.open + w);
        hn::StoreU(three, tag, entered + k);
        hn::StoreU(ends, tag, ending + k);
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(tag, hn::Ne(three, zero), bits);
        busy.entered |= std::uint64_t{bits[0]} << k;
        hn::StoreMaskBits(tag, hn::Ne(ends, zero), bits);
        busy.ending |= std::uint64_t{bits[0]} << k;
    }
    shorts.singles += hn::GetLane(hn::SumOfLanes(tag, singles));
    shorts.doubles += hn::GetLane(hn::SumOfLanes(tag, doubles));
    for (; k < count; ++k) {
        const std::size_t w = begin + k;
        const std::uint64_t next = s.next[w], starts = s.current[w] & ~s.previous[w], two = starts & next;
        shorts.singles += static_cast<std::uint64_t>(std::popcount(starts & ~next));
        shorts.doubles += static_cast<std::uint64_t>(std::popcount(two & ~s.after_next[w]));
        entered[k] = two & s.after_next[w];
        ending[k] = s.open[w] & ~next;
        s.open[w] = (s.open[w] & next) | entered[k];
        busy.entered |= std::uint64_t{entered[k] != 0} << k;
        busy.ending |= std::uint64_t{ending[k] != 0} << k;
    }
    return busy;
}

void diagonal_step(const DiagonalStep& s, ShortLines& shorts, std::vector<DiagonalLine>& ended) {
    if (s.enter_all) return border_step(s, ended);
    std::uint64_t entered[64], ending[64];
    for (std::size_t begin = s.first_word; begin <= s.last_word; begin += 64) {
        const std::size_t count = std::min<std::size_t>(64, s.last_word + 1 - begin);
        Busy busy = step_words(s, begin, count, entered, ending, shorts);
        for (; busy.ending != 0; busy.ending &= busy.ending - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(busy.ending));
            end(s, begin + k, ending[k], ended);
        }
        for (; busy.entered != 0; busy.entered &= busy.entered - 1) {
            const auto k = static_cast<std::size_t>(std::countr_zero(busy.entered));
            enter(s, begin + k, entered[k]);
        }
    }
}

// Adds the carry to planes from `plane` on. It rarely reaches the seventh, so the branch there is well predicted; lower
// down it would not be.
template <class Tag, class Words>
void carry_on(Tag tag, Words carry, std::uint64_t* planes, std::size_t plane, std::size_t stride) {
    for (std::size_t p = plane; p < plane_count; ++p) {
        if (p >= 6 && hn::AllTrue(tag, hn::Eq(carry, hn::Zero(tag)))) break;
        const auto old = hn::LoadU(tag, planes + p * stride);
        hn::StoreU(hn::Xor(old, carry), tag, planes + p * stride);
        carry = hn::And(old, carry);
    }
}

// a + b + c, bit by bit: the sum is left in a, the carry returned.
template <class Words>
Words add_three(Words& a, Words b, Words c) {
    const auto either = hn::Xor(a, b), carry = hn::Or(hn::And(a, b), hn::And(either, c));
    a = hn::Xor(either, c);
    return carry;
}

template <class Tag>
std::size_t add_four(Tag tag, const std::array<const std::uint64_t*, 4>& columns, std::size_t w, std::size_t end,
                     std::uint64_t* planes, std::size_t stride) {
    const std::size_t lanes = hn::Lanes(tag);
    for (; w + lanes <= end; w += lanes) {
        auto ones = hn::LoadU(tag, planes + w), twos = hn::LoadU(tag, planes + stride + w);
        const auto first = add_three(ones, hn::LoadU(tag, columns[0] + w), hn::LoadU(tag, columns[1] + w));
        const auto second = add_three(ones, hn::LoadU(tag, columns[2] + w), hn::LoadU(tag, columns[3] + w));
        const auto fours = add_three(twos, first, second);
        hn::StoreU(ones, tag, planes + w);
        hn::StoreU(twos, tag, planes + stride + w);
        carry_on(tag, fours, planes + w, 2, stride);
    }
    return w;
}

void add_to_planes(const std::array<const std::uint64_t*, 4>& columns, std::size_t first, std::size_t last,
                   std::uint64_t* planes, std::size_t plane_stride) {
    const std::size_t w = add_four(hn::ScalableTag<std::uint64_t>(), columns, first, last + 1, planes, plane_stride);
    add_four(hn::CappedTag<std::uint64_t, 1>(), columns, w, last + 1, planes, plane_stride);
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(scatter_rows);
HWY_EXPORT(list_turns);
HWY_EXPORT(vertical_lines);
HWY_EXPORT(diagonal_step);
HWY_EXPORT(add_to_planes);

void scatter_rows(const std::uint32_t* order, std::size_t begin, std::size_t end, std::size_t offset,
                  std::uint64_t* words) {
    HWY_DYNAMIC_DISPATCH(scatter_rows)(order, begin, end, offset, words);
}
std::size_t list_turns(const std::uint64_t* words, std::size_t count, std::uint32_t* turns) {
    return HWY_DYNAMIC_DISPATCH(list_turns)(words, count, turns);
}
std::size_t vertical_lines(const std::uint64_t* words, std::size_t first, std::size_t last,
                           const VerticalOptions& options, Tally& lines, Tally& times) {
    return HWY_DYNAMIC_DISPATCH(vertical_lines)(words, first, last, options, lines, times);
}
void diagonal_step(const DiagonalStep& step, ShortLines& shorts, std::vector<DiagonalLine>& ended) {
    HWY_DYNAMIC_DISPATCH(diagonal_step)(step, shorts, ended);
}
void add_to_planes(const std::array<const std::uint64_t*, 4>& columns, std::size_t first, std::size_t last,
                   std::uint64_t* planes, std::size_t plane_stride) {
    HWY_DYNAMIC_DISPATCH(add_to_planes)(columns, first, last, planes, plane_stride);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
