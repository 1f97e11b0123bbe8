// A set of small integers with the next and the previous member of any: bits, and above them bits that say which words
// are not 0, and so on. Cost of every operation: O(log_64 size).
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis::recurrence::detail {

class BitTree {
public:
    static constexpr std::size_t none = ~std::size_t{0};

    /// Members 0 ... size - 1 can be held; all of them are if `full`.
    BitTree(std::size_t size, bool full) {
        for (std::size_t bits = size;; bits = (bits + 63) / 64) {
            levels_.emplace_back((bits + 63) / 64, 0);
            if (full)
                for (std::size_t i = 0; i < bits; ++i) levels_.back()[i >> 6] |= std::uint64_t{1} << (i & 63);
            if (bits <= 64) break;
        }
    }

    bool contains(std::size_t i) const { return (levels_[0][i >> 6] >> (i & 63)) & 1; }

    void insert(std::size_t i) {
        for (auto& level : levels_) {
            const std::uint64_t before = level[i >> 6];
            level[i >> 6] = before | std::uint64_t{1} << (i & 63);
            if (before != 0) return;
            i >>= 6;
        }
    }

    void erase(std::size_t i) {
        for (auto& level : levels_) {
            level[i >> 6] &= ~(std::uint64_t{1} << (i & 63));
            if (level[i >> 6] != 0) return;
            i >>= 6;
        }
    }

    /// The smallest member > i, or none.
    std::size_t after(std::size_t i) const {
        for (std::size_t l = 0; l < levels_.size(); ++l, i >>= 6) {
            const std::uint64_t above = (i & 63) == 63 ? 0 : levels_[l][i >> 6] >> ((i & 63) + 1);
            if (above == 0) continue;
            i += 1 + static_cast<std::size_t>(std::countr_zero(above));
            while (l-- > 0) i = i << 6 | static_cast<std::size_t>(std::countr_zero(levels_[l][i]));
            return i;
        }
        return none;
    }

    /// The largest member < i, or none.
    std::size_t before(std::size_t i) const {
        for (std::size_t l = 0; l < levels_.size(); ++l, i >>= 6) {
            const std::uint64_t below = levels_[l][i >> 6] & ((std::uint64_t{1} << (i & 63)) - 1);
            if (below == 0) continue;
            i = (i & ~std::size_t{63}) + 63 - static_cast<std::size_t>(std::countl_zero(below));
            while (l-- > 0) i = i << 6 | (63 - static_cast<std::size_t>(std::countl_zero(levels_[l][i])));
            return i;
        }
        return none;
    }

private:
    std::vector<std::vector<std::uint64_t>> levels_;
};

}  // namespace swirl::analysis::recurrence::detail
