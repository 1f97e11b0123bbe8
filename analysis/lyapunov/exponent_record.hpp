// What a Lyapunov computation returns, and the sums over blocks that its standard errors come from.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>
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

// How many multipliers of a cycle are zero because DFᵏ loses rank, and not because they are small.

/// The dimension of the generalised null space of DFᵏ = D_k … D₁, the derivatives in the order in which they are
/// passed. A frame in general position is carried round n times, n the matrices' size, since a nilpotent part of size
/// m ≤ n vanishes at the mth power; after each derivative the frame is orthonormalised, and a direction whose length
/// fell to `rank_tolerance` ‖D_i‖ or less is lost. O(k n⁴).
Eigen::Index lost_ranks(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance);

// What a Lyapunov computation returns, and the accumulator that makes it from the growth of each step.

enum class LyapunovOutcome {
    completed,
    ended_in_transient,  ///< the map ended before the first counted step: no exponents
    ended_early,         ///< the map ended; the exponents are those of the `steps` reached
    not_finite,          ///< state or derivative overflowed; the same
};
std::string_view name_of(LyapunovOutcome outcome);

enum class CheckpointSpacing { geometric, even };

struct LyapunovOptions {
    std::int64_t steps = 100'000;    ///< counted steps, ≥ 1
    std::int64_t transient = 1'000;  ///< steps before, which settle the orbit and the frame, ≥ 0
    int checkpoints = 64;            ///< wanted in the record, ≥ 1
    CheckpointSpacing spacing = CheckpointSpacing::geometric;
    /// A step loses a rank when a diagonal element of R is at most this times the Frobenius norm of DF: the rounding of
    /// a D × D derivative, with room for its own condition. In [0, 1).
    double rank_tolerance = 1e-13;
};

struct Checkpoint {
    std::int64_t step = 0;          ///< counted steps so far
    double time = 0;                ///< their duration
    std::vector<double> exponents;  ///< per step, means up to here; −∞ once a rank is lost
};

/// The steps that annihilated this many directions at once.
struct Annihilation {
    std::int64_t directions = 0, steps = 0;
    std::int64_t first = 0, last = 0;  ///< counted steps, from 1
};

/// Exponents by falling size; vectors of length D (of length 1 from `largest_exponent`).
struct LyapunovSpectrum {
    LyapunovOutcome outcome = LyapunovOutcome::completed;
    std::int64_t steps = 0;                        ///< counted
    double time = 0;                               ///< duration of the counted steps
    std::vector<double> exponents;                 ///< per step; −∞ where a rank was lost; NaN if steps = 0
    std::vector<double> per_time;                  ///< per unit of time
    std::vector<double> standard_errors;           ///< per step; NaN for −∞ and below 4 blocks
    std::vector<double> per_time_standard_errors;  ///< per unit of time (ratio estimator)
    std::vector<double> effective_blocks;
    /// p in RMS(Σ ln growth over ℓ steps) ∝ ℓ^p: ≈ 0 bounded (neutral), ½ a random walk, 1 a drift.
    std::vector<double> growth_orders;
    /// Weighted Birkhoff means, per step: on periodic and quasi-periodic orbits they converge faster than any power of
    /// 1/steps, where the plain means are off by O(1/steps). NaN unless completed.
    std::vector<double> weighted_exponents;
    std::vector<double> weighted_half_difference;  ///< |first half − second half| of them: evidence of convergence
    std::vector<std::int64_t> lost_ranks;          ///< steps on which this direction was annihilated
    std::vector<Annihilation> annihilations;       ///< by rising number of directions; empty without lost ranks
    /// Per step, over the steps that did not annihilate this direction; `exponents` where none did. NaN if all did.
    std::vector<double> without_losses;
    std::vector<Checkpoint> record;               ///< the last one is where the computation ended
    std::vector<std::vector<double>> block_sums;  ///< [exponent][block], sums of ln growth; without lost directions
    std::int64_t block_length = 0;                ///< steps
};

/// Turns the growth ln R_ii of every step into a LyapunovSpectrum. O(D) per step, O(D (64 + checkpoints)) memory.
class ExponentAccumulator {
public:
    /// Throws std::invalid_argument, naming option and range, if an option is out of range.
    ExponentAccumulator(std::size_t dimension, const LyapunovOptions& options);

    /// One counted step: ln of the growth of each direction (−∞: annihilated), and its duration.
    void add(std::span<const double> log_growth, double duration);

    LyapunovSpectrum finish(LyapunovOutcome outcome) const;

private:
    void checkpoint();
    void note_losses(std::size_t directions);
    void add_weighted(std::span<const double> growth);
    std::vector<double> means() const;

    struct WeightedSum {
        std::int64_t first = 0;  ///< step that the bump begins after
        std::int64_t length = 0;
        double weight = 0;
        std::vector<double> sums;
    };

    LyapunovOptions options_;
    std::int64_t step_ = 0;
    std::int64_t next_checkpoint_ = 1;
    double time_ = 0;
    std::vector<double> sums_;
    std::vector<double> compensation_;  ///< of the sums' rounding (Neumaier)
    std::vector<std::int64_t> lost_;
    std::vector<Annihilation> annihilations_;  ///< [directions − 1]
    BlockSums blocks_;                         ///< channels: the exponents, then the duration
    std::vector<DyadicSquares> wandering_;
    std::vector<WeightedSum> weighted_;  ///< whole orbit, first half, second half
    std::vector<Checkpoint> record_;
    std::vector<double> channels_;  ///< scratch
};

}  // namespace swirl::analysis
