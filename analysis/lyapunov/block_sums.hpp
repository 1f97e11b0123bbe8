// Sums of several rates over consecutive blocks of equal length, for standard errors of orbits of any length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis {

/// Keeps between 32 and 64 complete blocks however long the orbit: when there are 64, neighbours are merged and the
/// block length doubles. Memory O(64 × channels), cost O(channels) per step.
class BlockSums {
public:
    explicit BlockSums(std::size_t channels);

    /// One step; `values` has one number per channel.
    void add(const std::vector<double>& values);

    std::int64_t block_length() const { return block_length_; }  ///< steps
    std::size_t blocks() const { return sums_.front().size(); }  ///< complete ones
    const std::vector<double>& sums(std::size_t channel) const { return sums_[channel]; }

private:
    std::int64_t block_length_ = 1;
    std::int64_t filled_ = 0;  ///< steps in the incomplete block
    std::vector<double> open_;
    std::vector<std::vector<double>> sums_;  ///< [channel][block]
};

/// Standard error of the mean of block values, with the remaining correlation of neighbouring blocks.
struct BlockError {
    double standard_error = 0;    ///< of the mean of `values`; NaN below 4 blocks
    double effective_blocks = 0;  ///< B (1 − r)/(1 + r), at most B; r: lag-1 correlation of the blocks
};
BlockError block_error(const std::vector<double>& values);

/// The growth of the sum of a series: the root mean square of its sums over blocks of 1, 2, 4, … steps. Memory O(log
/// steps), cost O(1) per step on average.
class DyadicSquares {
public:
    void add(double value);

    /// p in RMS(block sum) ∝ (block length)^p, fitted over the six longest lengths with at least 16 blocks. A sum that
    /// stays bounded has p ≈ 0, a random walk ½, a drift 1. 0 if all sums vanish, NaN below 128 steps.
    double growth_order() const;

private:
    struct Level {
        bool waiting = false;  ///< `half` waits for its neighbour
        double half = 0;
        double squares = 0;
        std::int64_t blocks = 0;
    };
    std::vector<Level> levels_;
};

}  // namespace swirl::analysis
