#include "analysis/recurrence/distance_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/distance_kernels.cpp"
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
        std::uint8_t bits[8] = {};
        hn::StoreMaskBits(tag, hn::Le(hn::LoadU(tag, keys + i), b), bits);
        word |= static_cast<std::uint64_t>(bits[0]) << i;
    }
    return word;
}

std::uint64_t first_bits(std::size_t count) {
    return ~std::uint64_t{0} >> (64 - count);
}  // 1 <= count <= 64

void mask_keys(const double* keys, std::size_t count, double bound, std::uint64_t* words) {
    std::size_t i = 0;
    for (; i + 64 <= count; i += 64) words[i / 64] = word_of_keys(keys + i, bound);
    if (i < count) words[i / 64] = word_of_keys(keys + i, bound) & first_bits(count - i);
}

std::size_t count_keys(const double* keys, std::size_t count, double bound) {
    std::size_t total = 0, i = 0;
    for (; i + 64 <= count; i += 64) total += static_cast<std::size_t>(std::popcount(word_of_keys(keys + i, bound)));
    if (i < count)
        total += static_cast<std::size_t>(std::popcount(word_of_keys(keys + i, bound) & first_bits(count - i)));
    return total;
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(compute_keys);
HWY_EXPORT(mask_keys);
HWY_EXPORT(count_keys);

void compute_keys(const KeyTask& task, std::size_t begin, std::size_t count, double* keys) {
    HWY_DYNAMIC_DISPATCH(compute_keys)(task, begin, count, keys);
}
void mask_keys(const double* keys, std::size_t count, double bound, std::uint64_t* words) {
    HWY_DYNAMIC_DISPATCH(mask_keys)(keys, count, bound, words);
}
std::size_t count_keys(const double* keys, std::size_t count, double bound) {
    return HWY_DYNAMIC_DISPATCH(count_keys)(keys, count, bound);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
