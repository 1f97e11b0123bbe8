#include "analysis/recurrence/lag_kernels.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "analysis/recurrence/lag_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "analysis/recurrence/single_lanes-inl.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

HWY_BEFORE_NAMESPACE();
namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
namespace {

using Words = hn::CappedTag<std::uint64_t, tile_side>;

std::uint64_t bits_of(hn::Mask<Singles> mask) {
    std::uint8_t bytes[8] = {};
    hn::StoreMaskBits(Singles(), mask, bytes);
    std::uint16_t bits = 0;
    std::memcpy(&bits, bytes, sizeof bits);
    return bits;
}

// The blocks of columns from column_block on, a bit each, that may hold a point near one of the rows of block
// row_block, row_block + 1 ... The gaps between two boxes are rounded like a pair's differences; 2^-20 of the key
// covers what that may add.
template <Norm norm, int dimension>
std::uint64_t near_blocks(const LagTask& task, std::size_t column_block, std::size_t row_block) {
    const Singles tag;
    const auto zero = hn::Zero(tag), limit = hn::Set(tag, task.bound.perhaps * (1 + 0x1p-20f));
    std::uint64_t near = 0;
    for (std::size_t k = 0; k < chunk_blocks; k += hn::Lanes(tag)) {
        auto key = zero;
        for (std::size_t m = 0; m < dimension; ++m) {
            const auto above = hn::Sub(hn::LoadU(tag, task.boxes.least[m] + row_block + k),
                                       hn::LoadU(tag, task.boxes.largest[m] + column_block + k));
            const auto below = hn::Sub(hn::LoadU(tag, task.boxes.least[m] + column_block + k),
                                       hn::LoadU(tag, task.boxes.largest[m] + row_block + k));
            key = joined_single<norm>(m, key, hn::Max(hn::Max(above, below), zero));
        }
        near |= bits_of(hn::Le(key, limit)) << k;
    }
    return near;
}

// A block of columns, each of them as often as a tile has rows.
template <int dimension>
struct RepeatedColumns {
    HWY_ALIGN float of[dimension][tile_side * tile_side];
    RepeatedColumns(const LagTask& task, std::size_t column) {
        const hn::CappedTag<float, tile_side> tag;
        for (std::size_t m = 0; m < dimension; ++m)
            for (std::size_t i = 0; i < tile_side * tile_side; i += hn::Lanes(tag))
                hn::Store(hn::Set(tag, task.coordinates[m][column + i / tile_side]), tag, of[m] + i);
    }
};

// Bit 8 c + i of `found`: row i of column c of the tile is within the bound; whether pairs are left open.
template <Norm norm, int dimension>
bool compare_tile(const LagTask& task, std::size_t row, const RepeatedColumns<dimension>& columns,
                  std::uint64_t& found) {
    const Singles tag;
    constexpr std::size_t rows_at_once = hn::MaxLanes(Singles()) < tile_side ? hn::MaxLanes(Singles()) : tile_side;
    const auto surely = hn::Set(tag, task.bound.surely), perhaps = hn::Set(tag, task.bound.perhaps);
    auto open = hn::Lt(surely, surely);  // none
    found = 0;
    for (std::size_t i = 0; i < tile_side; i += rows_at_once) {
        SingleVector rows[dimension];
        for (std::size_t m = 0; m < dimension; ++m) rows[m] = eight_rows(task.coordinates[m] + row + i);
        for (std::size_t k = i; k < tile_side * tile_side; k += std::max(tile_side, hn::Lanes(tag))) {
            auto key = hn::Zero(tag);
            for (std::size_t m = 0; m < dimension; ++m)
                key = joined_single<norm>(m, key, hn::Sub(rows[m], hn::LoadU(tag, columns.of[m] + k)));
            const auto within = hn::Le(key, surely);
            open = hn::Or(open, hn::AndNot(within, hn::Le(key, perhaps)));
            found |= bits_of(within) << k;
        }
    }
    return !hn::AllFalse(tag, open);
}

// The bits of eight columns, [word][column]: the band's words, and room for what lies outside it.
using BlockBits = std::uint64_t[band_words + 3][tile_side];

// Adds a tile whose first row is that of bit `lag` of the first column; a multiple of eight, at least eight. Column c
// has it at lag - c.
void add_tile(std::uint64_t found, std::size_t lag, BlockBits& bits) {
    const Words tag;
    const hn::Rebind<std::uint32_t, Words> halves;
    const hn::Rebind<std::uint8_t, Words> bytes;
    std::uint8_t columns[tile_side];
    std::memcpy(columns, &found, sizeof found);
    const std::size_t word = (lag - tile_side) / 64;
    const int place = static_cast<int>((lag - tile_side) % 64), rest = 56 - place;
    for (std::size_t c = 0; c < tile_side; c += hn::Lanes(tag)) {
        const auto eight = hn::PromoteTo(tag, hn::PromoteTo(halves, hn::LoadU(bytes, columns + c)));
        const auto shift = hn::Sub(hn::Set(tag, tile_side - c), hn::Iota(tag, 0));
        const auto shifted = hn::Shl(eight, shift);
        hn::StoreU(hn::Or(hn::LoadU(tag, bits[word] + c), hn::ShiftLeftSame(shifted, place)), tag, bits[word] + c);
        const auto above = hn::ShiftRightSame(hn::ShiftRight<8>(shifted), rest);
        hn::StoreU(hn::Or(hn::LoadU(tag, bits[word + 1] + c), above), tag, bits[word + 1] + c);
    }
}

// Bit i of rows[k] becomes bit k of rows[i]: halves, quarters ... change places.
void transpose(std::uint64_t* rows) {
    std::uint64_t low = 0xffffffff;
    for (std::size_t half = 32; half != 0; half >>= 1, low ^= low << half)
        for (std::size_t k = 0; k < 64; k = ((k | half) + 1) & ~half) {
            const std::uint64_t change = ((rows[k] >> half) ^ rows[k | half]) & low;
            rows[k] ^= change << half;
            rows[k | half] ^= change;
        }
}

template <Norm norm, int dimension>
std::size_t compare_band_by(const LagTask& task, std::size_t first_column, std::size_t first_lag, std::size_t blocks,
                            const std::array<std::uint64_t*, band_words>& words, LagTile* open) {
    constexpr std::size_t tiles = band_lags / tile_side + 1;
    static_assert(tiles <= 64 && chunk_blocks <= 64);
    std::uint64_t near[64] = {};
    const std::size_t column_block = first_column / tile_side, row_block = column_block + first_lag / tile_side;
    for (std::size_t g = 0; g < tiles; ++g) near[g] = near_blocks<norm, dimension>(task, column_block, row_block + g);
    transpose(near);
    std::size_t opened = 0;
    for (std::size_t b = 0; b < blocks; ++b) {
        BlockBits bits = {};
        const std::size_t column = first_column + b * tile_side;
        const RepeatedColumns<dimension> columns(task, column);
        for (std::uint64_t left = near[b]; left != 0; left &= left - 1) {
            const auto g = static_cast<std::size_t>(std::countr_zero(left));
            const std::size_t row = (row_block + b + g) * tile_side;
            std::uint64_t found = 0;
            if (compare_tile<norm, dimension>(task, row, columns, found))
                open[opened++] = {static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(column)};
            add_tile(found, word_lags + g * tile_side, bits);
        }
        for (std::size_t w = 0; w < band_words; ++w) std::copy_n(bits[w + 1], tile_side, words[w] + b * tile_side);
    }
    return opened;
}

template <Norm norm>
std::size_t compare_band_in(const LagTask& task, std::size_t first_column, std::size_t first_lag, std::size_t blocks,
                            const std::array<std::uint64_t*, band_words>& words, LagTile* open) {
    return task.dimension == 2 ? compare_band_by<norm, 2>(task, first_column, first_lag, blocks, words, open)
                               : compare_band_by<norm, 3>(task, first_column, first_lag, blocks, words, open);
}

}  // namespace

std::size_t compare_band(const LagTask& task, std::size_t first_column, std::size_t first_lag, std::size_t blocks,
                         const std::array<std::uint64_t*, band_words>& words, LagTile* open) {
    switch (task.norm) {
        case Norm::euclidean:
            return compare_band_in<Norm::euclidean>(task, first_column, first_lag, blocks, words, open);
        case Norm::maximum:
            return compare_band_in<Norm::maximum>(task, first_column, first_lag, blocks, words, open);
        case Norm::manhattan:
            return compare_band_in<Norm::manhattan>(task, first_column, first_lag, blocks, words, open);
    }
    return 0;
}

}  // namespace swirl::analysis::recurrence::detail::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace swirl::analysis::recurrence::detail {

HWY_EXPORT(compare_band);

std::size_t compare_band(const LagTask& task, std::size_t first_column, std::size_t first_lag, std::size_t blocks,
                         const std::array<std::uint64_t*, band_words>& words, LagTile* open) {
    return HWY_DYNAMIC_DISPATCH(compare_band)(task, first_column, first_lag, blocks, words, open);
}

}  // namespace swirl::analysis::recurrence::detail
#endif
