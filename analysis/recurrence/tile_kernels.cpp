#include "analysis/recurrence/tile_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/tile_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "analysis/recurrence/single_lanes-inl.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <type_traits>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// A vector of at most eight doubles: one column of a tile is 8 / lanes of them.
using Doubles = hn::CappedTag<double, tile_side>;
using Vector = hn::Vec<Doubles>;

template <class Mask>
std::uint64_t bits_of(Mask mask) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(Doubles(), mask, bits);
    return bits[0];
}

// Coordinate m joins the key.
template <Norm norm>
Vector joined(int m, Vector key, Vector d) {
    if constexpr (norm == Norm::maximum) return m == 0 ? d : hn::Max(key, d);
    if constexpr (norm == Norm::manhattan) return m == 0 ? d : hn::Add(key, d);
    if constexpr (norm == Norm::euclidean) return m == 0 ? hn::Mul(d, d) : hn::Add(key, hn::Mul(d, d));
}

template <class Action>
void for_each_bit(std::span<const std::uint64_t> words, const Action& action) {
    for (std::size_t w = 0; w < words.size(); ++w)
        for (std::uint64_t bits = words[w]; bits != 0; bits &= bits - 1)
            action(w * 64 + static_cast<std::size_t>(std::countr_zero(bits)));
}

// Where coordinates lie. Of a dimension that the compiler knows a copy, which no store can change behind its back.
template <int fixed>
struct Coordinates {
    const double* arrays[fixed];
    explicit Coordinates(const double* const* given) { std::copy_n(given, fixed, arrays); }
    const double* operator[](int m) const { return arrays[m]; }
};
template <>
struct Coordinates<0> {
    const double* const* arrays;
    explicit Coordinates(const double* const* given) : arrays(given) {}
    const double* operator[](int m) const { return arrays[m]; }
};

// fixed: the dimension where the compiler knows it and no coordinate is an angle, else 0.
template <Norm norm, int fixed>
void near_boxes_by(const KeyRule& rule, const Box& box, double bound, const Boxes& boxes, std::uint64_t* near) {
    const Doubles tag;
    const std::size_t lanes = hn::Lanes(tag);
    const int dimension = fixed > 0 ? fixed : rule.dimension;
    const Coordinates<fixed> least(boxes.least), largest(boxes.largest);
    const auto zero = hn::Zero(tag), limit = hn::Set(tag, bound);
    for (std::size_t b = 0; b < boxes.count; b += 64) {
        std::uint64_t within = 0;
        for (std::size_t k = 0; k < 64; k += lanes) {
            auto key = zero;
            for (int m = 0; m < dimension; ++m) {
                const auto above = hn::Sub(hn::LoadU(tag, largest[m] + b + k), hn::Set(tag, box.least[m]));
                const auto below = hn::Sub(hn::Set(tag, box.largest[m]), hn::LoadU(tag, least[m] + b + k));
                auto gap = hn::Neg(hn::Min(hn::Min(above, below), zero));
                if (fixed == 0 && rule.periods[m] > 0) {  // or the other way round: P - d, d the largest difference
                    const auto round = hn::Sub(hn::Set(tag, rule.periods[m]), hn::Max(above, below));
                    gap = hn::Max(hn::Min(gap, round), zero);
                }
                key = joined<norm>(m, key, gap);
            }
            within |= bits_of(hn::Le(key, limit)) << k;
        }
        const std::size_t left = boxes.count - b;
        near[b / 64] = left >= 64 ? within : within & ((std::uint64_t{1} << left) - 1);
    }
}

constexpr std::size_t pairs = tile_side * tile_side;

// Keys of a tile, column after column.
template <Norm norm, int fixed>
void keys_of_tile(const KeyRule& rule, const Coordinates<fixed>& rows, const Coordinates<fixed>& columns,
                  std::size_t column_count, std::size_t block, double* keys) {
    const Doubles tag;
    const std::size_t lanes = hn::Lanes(tag), row = block * tile_side;
    const int dimension = fixed > 0 ? fixed : rule.dimension;
    for (std::size_t k = 0; k < column_count; ++k)
        for (std::size_t j = 0; j < tile_side; j += lanes) {
            auto key = hn::Zero(tag);
            for (int m = 0; m < dimension; ++m) {
                auto d = hn::Sub(hn::LoadU(tag, rows[m] + row + j), hn::Set(tag, columns[m][k]));
                if (fixed == 0 || norm != Norm::euclidean) d = hn::Abs(d);
                if (fixed == 0 && rule.periods[m] > 0) d = hn::Min(d, hn::Sub(hn::Set(tag, rule.periods[m]), d));
                key = joined<norm>(m, key, d);
            }
            hn::Store(key, tag, keys + k * tile_side + j);
        }
}

// Which keys of a tile are <= bound.
template <class Tag, class T>
std::uint64_t within(const Tag tag, const T* keys, T bound) {
    const auto limit = hn::Set(tag, bound);
    std::uint64_t found = 0;
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(tag)) {
        std::uint8_t bytes[8] = {};
        hn::StoreMaskBits(tag, hn::Le(hn::Load(tag, keys + i), limit), bytes);
        std::uint16_t bits = 0;
        std::memcpy(&bits, bytes, sizeof bits);
        found |= std::uint64_t{bits} << i;
    }
    return found;
}

void store_tile(const TileTask& task, std::size_t q, std::size_t block, std::uint64_t found) {
    for (std::size_t k = 0; k < tile_side; ++k)
        task.bytes[q * tile_side + k][block] = static_cast<std::uint8_t>(found >> (k * tile_side));
}

// Each column of the group eight times over.
template <int fixed>
struct RepeatedColumns {
    HWY_ALIGN float of[fixed][pairs];
    explicit RepeatedColumns(const TileTask& task) {
        for (int m = 0; m < fixed; ++m)
            for (std::size_t i = 0; i < pairs; ++i)
                of[m][i] = task.single.columns[m][std::min(i / tile_side, task.column_count - 1)];
    }
};

template <Norm norm, int fixed>
void keys_in_single(const std::array<const float*, fixed>& rows, const RepeatedColumns<fixed>& columns,
                    std::size_t block, float* keys) {
    static_assert(fixed == 2 || fixed == 3);
    const Singles tag;
    const auto x = eight_rows(rows[0] + block * tile_side), y = eight_rows(rows[1] + block * tile_side);
    const auto z = eight_rows(rows[fixed - 1] + block * tile_side);
    for (std::size_t i = 0; i < pairs; i += hn::Lanes(tag)) {
        auto key = joined_single<norm>(0, x, hn::Sub(x, hn::Load(tag, columns.of[0] + i)));
        key = joined_single<norm>(1, key, hn::Sub(y, hn::Load(tag, columns.of[1] + i)));
        if (fixed == 3) key = joined_single<norm>(2, key, hn::Sub(z, hn::Load(tag, columns.of[fixed - 1] + i)));
        hn::Store(key, tag, keys + i);
    }
}

template <Norm norm, int fixed>
void compare_tiles_by(const KeyRule& rule, const TileTask& task, std::span<const std::uint64_t> near) {
    const Coordinates<fixed> rows(task.rows), columns(task.columns);
    HWY_ALIGN double keys[pairs] = {};
    const auto in_double = [&](std::size_t block) {
        keys_of_tile<norm, fixed>(rule, rows, columns, task.column_count, block, keys);
        for (std::size_t q = 0; q < task.bounds.size(); ++q)
            store_tile(task, q, block, within(Doubles(), keys, task.bounds[q]));
    };
    if constexpr (fixed > 0 && hn::MaxLanes(Singles()) >= tile_side) {
        if (!task.single.bounds.empty()) {
            std::array<const float*, fixed> single_rows;
            std::copy_n(task.single.rows, fixed, single_rows.begin());
            const RepeatedColumns<fixed> single_columns(task);
            HWY_ALIGN float single_keys[pairs];
            return for_each_bit(near, [&](std::size_t block) {
                keys_in_single<norm, fixed>(single_rows, single_columns, block, single_keys);
                for (std::size_t q = 0; q < task.bounds.size(); ++q) {
                    const std::uint64_t surely = within(Singles(), single_keys, task.single.bounds[q].surely);
                    const std::uint64_t perhaps = within(Singles(), single_keys, task.single.bounds[q].perhaps);
                    if (surely != perhaps) return in_double(block);
                    store_tile(task, q, block, surely);
                }
            });
        }
    }
    for_each_bit(near, in_double);
}

bool has_angles(const KeyRule& rule) {
    return std::any_of(rule.periods, rule.periods + rule.dimension, [](double period) { return period > 0; });
}

// Calls loop(norm, dimension) with both known to the compiler; the dimension 0: any, angles among them.
template <class Loop>
void with_rule(const KeyRule& rule, const Loop& loop) {
    const auto with_dimension = [&](auto norm) {
        if (rule.dimension == 2 && !has_angles(rule)) return loop(norm, std::integral_constant<int, 2>());
        if (rule.dimension == 3 && !has_angles(rule)) return loop(norm, std::integral_constant<int, 3>());
        return loop(norm, std::integral_constant<int, 0>());
    };
    if (rule.dimension == 1 || rule.norm == Norm::maximum)
        return with_dimension(std::integral_constant<Norm, Norm::maximum>());
    if (rule.norm == Norm::manhattan) return with_dimension(std::integral_constant<Norm, Norm::manhattan>());
    return with_dimension(std::integral_constant<Norm, Norm::euclidean>());
}

void near_boxes(const KeyRule& rule, const Box& box, double bound, const Boxes& boxes, std::uint64_t* near) {
    with_rule(rule, [&](auto norm, auto dimension) {
        near_boxes_by<decltype(norm)::value, decltype(dimension)::value>(rule, box, bound, boxes, near);
    });
}

void compare_tiles(const KeyRule& rule, const TileTask& task, std::span<const std::uint64_t> near) {
    with_rule(rule, [&](auto norm, auto dimension) {
        compare_tiles_by<decltype(norm)::value, decltype(dimension)::value>(rule, task, near);
    });
}

void add_shifted(const std::uint64_t* words, std::size_t count, std::size_t offset, std::uint64_t* frame) {
    if (count == 0) return;
    std::uint64_t* out = frame + (offset >> 6);
    const int shift = static_cast<int>(offset & 63);
    if (shift == 0) {
        for (std::size_t w = 0; w < count; ++w) out[w] |= words[w];
        return;
    }
    out[0] |= words[0] << shift;
    for (std::size_t w = 1; w < count; ++w) out[w] |= (words[w] << shift) | (words[w - 1] >> (64 - shift));
    if (const std::uint64_t rest = words[count - 1] >> (64 - shift); rest != 0) out[count] |= rest;
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(near_boxes);
HWY_EXPORT(compare_tiles);
HWY_EXPORT(add_shifted);

void near_boxes(const KeyRule& rule, const Box& box, double bound, const Boxes& boxes, std::uint64_t* near) {
    HWY_DYNAMIC_DISPATCH(near_boxes)(rule, box, bound, boxes, near);
}
void compare_tiles(const KeyRule& rule, const TileTask& task, std::span<const std::uint64_t> near) {
    HWY_DYNAMIC_DISPATCH(compare_tiles)(rule, task, near);
}
void add_shifted(const std::uint64_t* words, std::size_t count, std::size_t offset, std::uint64_t* frame) {
    HWY_DYNAMIC_DISPATCH(add_shifted)(words, count, offset, frame);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
