#include "analysis/recurrence/gaps.hpp"

#include <tbb/parallel_for.h>
#include <algorithm>
#include <bit>
#include <utility>

namespace swirl::analysis::recurrence::detail {
namespace {

/// `count` bits, at most 64, from bit `from` on.
std::uint64_t bits_from(const std::uint64_t* words, std::size_t from, std::size_t count) {
    const std::size_t w = from >> 6, shift = from & 63;
    std::uint64_t bits = words[w] >> shift;
    if (shift + count > 64) bits |= words[w + 1] << (64 - shift);
    return count < 64 ? bits & ((std::uint64_t{1} << count) - 1) : bits;
}

/// A bit a row, of the first `count`, and a word of zeros.
std::vector<std::uint64_t> bits_of(const Presence& presence, std::size_t count) {
    std::vector<std::uint64_t> words(count / 64 + 2, 0);
    for (std::size_t i = 0; i < count; ++i)
        if (presence.has(i)) words[i >> 6] |= std::uint64_t{1} << (i & 63);
    return words;
}

/// How many i < count − shift have bit i of a and bit i + shift of b.
std::uint64_t common_bits(const std::vector<std::uint64_t>& a, const std::vector<std::uint64_t>& b, std::size_t count,
                          std::size_t shift) {
    std::uint64_t total = 0;
    for (std::size_t i = 0; i + shift < count; i += 64) {
        const std::size_t bits = std::min<std::size_t>(64, count - shift - i);
        total += static_cast<std::uint64_t>(
            std::popcount(bits_from(a.data(), i, bits) & bits_from(b.data(), i + shift, bits)));
    }
    return total;
}

}  // namespace

Presence::Presence(const Points& points) : point_at(points.rows(), none) {
    for (std::size_t i = 0; i < points.count; ++i) {
        const std::size_t row = points.row(i);
        point_at[row] = static_cast<std::uint32_t>(i);
        if (runs.empty() || runs.back().row + runs.back().count != row) runs.push_back({i, row, 0});
        ++runs.back().count;
    }
}

void copy_bits(const std::uint64_t* source, std::size_t from, std::size_t count, std::uint64_t* target,
               std::size_t to) {
    while (count > 0) {
        const std::size_t bits = std::min<std::size_t>(64 - (to & 63), count);
        target[to >> 6] |= bits_from(source, from, bits) << (to & 63);
        from += bits;
        to += bits;
        count -= bits;
    }
}

ColumnSource with_gaps(ColumnSource inner, const Presences& presences, std::size_t points, std::size_t thresholds) {
    std::vector<std::vector<std::uint64_t>> found(thresholds, std::vector<std::uint64_t>(points / 64 + 2));
    return [inner = std::move(inner), &presences, found = std::move(found)](
               std::size_t c, std::size_t offset, std::span<std::uint64_t* const> frames) mutable {
        if (!presences.columns.has(c)) return;
        std::vector<std::uint64_t*> words;
        for (auto& of_threshold : found) {
            std::fill(of_threshold.begin(), of_threshold.end(), 0);
            words.push_back(of_threshold.data());
        }
        inner(presences.columns.point_at[c], 0, words);
        for (std::size_t k = 0; k < words.size(); ++k)
            for (const PointRun& run : presences.rows.runs)
                copy_bits(words[k], run.point, run.count, frames[k], run.row + offset);
    };
}

std::vector<std::uint64_t> pairs_by_distance(const Presences& presences) {
    const std::size_t square = std::min(presences.rows.point_at.size(), presences.columns.point_at.size());
    const auto rows = bits_of(presences.rows, square), columns = bits_of(presences.columns, square);
    std::vector<std::uint64_t> pairs(square);
    tbb::parallel_for(std::size_t{0}, square, [&](std::size_t k) {
        pairs[k] = common_bits(rows, columns, square, k) + (k > 0 ? common_bits(columns, rows, square, k) : 0);
    });
    return pairs;
}

std::uint64_t pairs_within(const Presences& presences, std::size_t window) {
    std::uint64_t pairs = 0;
    const Presence &rows = presences.rows, &columns = presences.columns;
    for (std::size_t i = 0; i < rows.point_at.size(); ++i) {
        if (!rows.has(i)) continue;
        const std::size_t first = i + 1 > window ? i + 1 - window : 0;
        for (std::size_t j = first; j < std::min(i + window, columns.point_at.size()); ++j)
            pairs += columns.has(j) ? 1 : 0;
    }
    return pairs;
}

}  // namespace swirl::analysis::recurrence::detail
