#include "analysis/recurrence/pair_census.hpp"

#include "analysis/recurrence/distance_kernels.hpp"

#include <tbb/blocked_range.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_reduce.h>
#include <algorithm>
#include <bit>
#include <cstddef>
#include <functional>
#include <limits>

namespace swirl::analysis::recurrence::detail {
namespace {

// Keys of point c with all points from c + gap on, chunk by chunk: visit(keys, count).
template <class Visit>
void visit_pairs(const Points& points, Norm norm, std::size_t gap, std::size_t c, const Visit& visit) {
    const auto d = static_cast<std::size_t>(points.dimension);
    std::vector<double> centre(d), keys(chunk_size);
    std::vector<const double*> coordinates(d);
    for (std::size_t m = 0; m < d; ++m) {
        coordinates[m] = points.coordinate(static_cast<int>(m));
        centre[m] = coordinates[m][c];
    }
    const KeyTask task{coordinates.data(), centre.data(), points.periods.data(), points.dimension, norm};
    for (std::size_t begin = points.point_from(points.row(c) + gap); begin < points.count; begin += chunk_size) {
        const std::size_t count = std::min(chunk_size, points.count - begin);
        compute_keys(task, begin, count, keys.data());
        visit(keys.data(), count);
    }
}

// Non-negative doubles are ordered as their bits are.
std::uint64_t bits_of(double key) {
    return std::bit_cast<std::uint64_t>(key);
}
double key_of(std::uint64_t bits) {
    return std::bit_cast<double>(bits);
}

struct Interval {
    std::uint64_t low, high;  // bits of keys, both included
};
constexpr Interval everything{0, std::bit_cast<std::uint64_t>(std::numeric_limits<double>::infinity())};

struct Census {
    std::uint64_t below = 0;
    std::vector<std::uint64_t> bins;
};

// How many keys lie below the interval, and how many in each of its parts of 2^shift doubles.
Census take_census(const Points& points, Norm norm, std::size_t gap, Interval interval, int shift) {
    const std::size_t bins = static_cast<std::size_t>((interval.high - interval.low) >> shift) + 1;
    const double high = key_of(interval.high);
    const double under = interval.low == 0 ? -1.0 : key_of(interval.low - 1);
    tbb::enumerable_thread_specific<Census> censuses([&] { return Census{0, std::vector<std::uint64_t>(bins, 0)}; });
    tbb::parallel_for(std::size_t{0}, points.count, [&](std::size_t c) {
        Census& census = censuses.local();
        std::vector<std::uint64_t> to_high(chunk_size / 64), to_under(chunk_size / 64);
        visit_pairs(points, norm, gap, c, [&](const double* keys, std::size_t count) {
            mask_keys(keys, count, high, to_high.data());
            mask_keys(keys, count, under, to_under.data());
            for (std::size_t w = 0; w < (count + 63) / 64; ++w) {
                census.below += static_cast<std::uint64_t>(std::popcount(to_under[w]));
                for (std::uint64_t in = to_high[w] & ~to_under[w]; in != 0; in &= in - 1) {
                    const std::size_t t = w * 64 + static_cast<std::size_t>(std::countr_zero(in));
                    ++census.bins[static_cast<std::size_t>((bits_of(keys[t]) - interval.low) >> shift)];
                }
            }
        });
    });
    Census total{0, std::vector<std::uint64_t>(bins, 0)};
    for (const Census& census : censuses) {
        total.below += census.below;
        for (std::size_t b = 0; b < bins; ++b) total.bins[b] += census.bins[b];
    }
    return total;
}

// Where the key of that rank probably lies, from about 1000 of the points. A wrong guess costs one pass, no more.
Interval guess_interval(const Points& points, Norm norm, std::size_t gap, std::uint64_t rank) {
    const std::size_t step = points.count / 1024;
    if (step < 2) return everything;
    std::vector<double> keys;
    for (std::size_t i = 0; i < points.count; i += step)
        for (std::size_t j = i + (gap + step - 1) / step * step; j < points.count; j += step)
            keys.push_back(pair_key(points, i, points, j, norm));
    if (keys.empty()) return everything;
    std::sort(keys.begin(), keys.end());
    const double pairs = 0.5 * static_cast<double>(points.count - gap) * static_cast<double>(points.count - gap + 1);
    const double centre = static_cast<double>(rank) / pairs * static_cast<double>(keys.size());
    const double margin = 0.005 * static_cast<double>(keys.size()) + 1;
    const auto at = [&](double where) {
        return bits_of(keys[static_cast<std::size_t>(std::clamp(where, 0.0, static_cast<double>(keys.size() - 1)))]);
    };
    return {centre < margin ? 0 : at(centre - margin), at(centre + margin)};
}

}  // namespace

std::uint64_t count_sorted_pairs(std::span<const double> sorted, double period, double bound) {
    const std::size_t n = sorted.size();
    std::size_t lo = 0, hi = 0, low_end = 0, high_begin = 0;
    std::uint64_t total = 0;
    for (const double b : sorted) {
        while (lo < n && sorted[lo] < b && b - sorted[lo] > bound) ++lo;
        hi = std::max(hi, lo);
        while (hi < n && (sorted[hi] <= b ? b - sorted[hi] : sorted[hi] - b) <= bound) ++hi;
        total += hi - lo;
        if (!(period > 0)) continue;
        // Across the cut of the circle: values far below b, and values far above it.
        while (low_end < n && sorted[low_end] < b && period - (b - sorted[low_end]) <= bound) ++low_end;
        if (high_begin < hi) high_begin = hi;
        while (high_begin < n && (sorted[high_begin] < b || period - (sorted[high_begin] - b) > bound)) ++high_begin;
        total += std::min(low_end, lo) + (n - std::max(high_begin, hi));
    }
    return total;
}

std::vector<std::uint64_t> count_pairs(const Points& points, Norm norm, std::size_t gap,
                                       std::span<const double> bounds) {
    using Counts = std::vector<std::uint64_t>;
    const tbb::blocked_range<std::size_t> all(0, points.count);
    return tbb::parallel_reduce(
        all, Counts(bounds.size(), 0),
        [&](const tbb::blocked_range<std::size_t>& range, Counts counts) {
            for (std::size_t c = range.begin(); c < range.end(); ++c)
                visit_pairs(points, norm, gap, c, [&](const double* keys, std::size_t count) {
                    for (std::size_t k = 0; k < bounds.size(); ++k) counts[k] += count_keys(keys, count, bounds[k]);
                });
            return counts;
        },
        [](Counts a, const Counts& b) {
            std::transform(a.begin(), a.end(), b.begin(), a.begin(), std::plus<>());
            return a;
        });
}

double select_key(const Points& points, Norm norm, std::size_t gap, std::uint64_t rank) {
    Interval interval = guess_interval(points, norm, gap, rank);
    // Each pass keeps one part of the interval, or starts over once if the guess was wrong.
    while (true) {
        const int shift = std::max(0, static_cast<int>(std::bit_width(interval.high - interval.low)) - 16);
        const Census census = take_census(points, norm, gap, interval, shift);
        std::uint64_t seen = census.below;
        std::size_t bin = 0;
        if (rank > seen)
            while (bin < census.bins.size() && seen + census.bins[bin] < rank) seen += census.bins[bin++];
        if (rank <= census.below || bin == census.bins.size()) {
            interval = everything;
            continue;
        }
        const std::uint64_t low = interval.low + (static_cast<std::uint64_t>(bin) << shift);
        if (shift == 0) return key_of(low);
        interval = {low, std::min(interval.high, low + (std::uint64_t{1} << shift) - 1)};
    }
}

}  // namespace swirl::analysis::recurrence::detail
