#include "analysis/lyapunov/exponent_record.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/linear_algebra/turned_frame.hpp"
#include "analysis/lyapunov/generic_frame.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "analysis/special_values.hpp"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

namespace swirl::analysis {

namespace {

constexpr std::size_t most_blocks = 64;

std::vector<double> merge_neighbours(const std::vector<double>& sums) {
    std::vector<double> merged(sums.size() / 2);
    for (std::size_t i = 0; i < merged.size(); ++i) merged[i] = sums[2 * i] + sums[2 * i + 1];
    return merged;
}

}  // namespace

BlockSums::BlockSums(std::size_t channels) : open_(channels, 0.0), sums_(channels) {}

void BlockSums::add(const std::vector<double>& values) {
    for (std::size_t c = 0; c < open_.size(); ++c) open_[c] += values[c];
    if (++filled_ < block_length_) return;
    for (std::size_t c = 0; c < open_.size(); ++c) sums_[c].push_back(open_[c]);
    std::fill(open_.begin(), open_.end(), 0.0);
    filled_ = 0;
    if (blocks() < most_blocks) return;
    for (std::vector<double>& sums : sums_) sums = merge_neighbours(sums);
    block_length_ *= 2;
}

BlockError block_error(const std::vector<double>& values) {
    const std::size_t blocks = values.size();
    if (blocks < 4) return {nan, static_cast<double>(blocks)};
    const double variance = gsl_stats_variance(values.data(), 1, blocks);
    if (!(variance > 0)) return {0, static_cast<double>(blocks)};
    const double r = std::clamp(gsl_stats_lag1_autocorrelation(values.data(), 1, blocks), 0.0, 0.99);
    const double effective = std::max(1.0, static_cast<double>(blocks) * (1 - r) / (1 + r));
    return {std::sqrt(variance / effective), effective};
}

void DyadicSquares::add(double value) {
    double sum = value;
    for (std::size_t level = 0;; ++level) {
        if (level == levels_.size()) levels_.emplace_back();
        Level& here = levels_[level];
        here.squares += sum * sum;
        ++here.blocks;
        here.waiting = !here.waiting;
        if (here.waiting) {
            here.half = sum;
            return;
        }
        sum += here.half;
    }
}

double DyadicSquares::growth_order() const {
    constexpr std::int64_t least_blocks = 16;
    constexpr std::size_t most_levels = 6;
    constexpr std::size_t least_levels = 4;
    std::vector<double> log_length;
    std::vector<double> log_rms;
    for (std::size_t level = levels_.size(); level-- > 0 && log_length.size() < most_levels;) {
        if (levels_[level].blocks < least_blocks) continue;
        if (levels_[level].squares == 0) return 0;
        log_length.push_back(static_cast<double>(level) * std::log(2.0));
        log_rms.push_back(0.5 * std::log(levels_[level].squares / static_cast<double>(levels_[level].blocks)));
    }
    if (log_length.size() < least_levels) return nan;
    double intercept = 0, slope = 0, c00 = 0, c01 = 0, c11 = 0, residual = 0;
    gsl_fit_linear(log_length.data(), 1, log_rms.data(), 1, log_length.size(), &intercept, &slope, &c00, &c01, &c11,
                   &residual);
    return slope;
}

Eigen::Index lost_ranks(std::span<const Eigen::MatrixXd> derivatives, double rank_tolerance) {
    const Eigen::Index dimension = derivatives[0].rows();
    Eigen::MatrixXd frame = generic_frame(static_cast<int>(dimension));
    std::vector<bool> lost(dimension, false);
    for (Eigen::Index round = 0; round < dimension; ++round) {
        for (const Eigen::MatrixXd& derivative : derivatives) {
            frame = derivative * frame;
            const Eigen::VectorXd diagonal = turn_frame(frame);
            for (Eigen::Index i = 0; i < dimension; ++i) {
                if (std::abs(diagonal[i]) <= rank_tolerance * derivative.norm()) lost[i] = true;
            }
        }
    }
    return std::count(lost.begin(), lost.end(), true);
}

namespace {

void require(bool valid, const std::string& what, double value, const std::string& allowed) {
    if (!valid) refuse(what, value, allowed);
}

std::vector<std::size_t> falling_order(const std::vector<double>& values) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
    return order;
}

std::vector<double> permuted(const std::vector<double>& values, const std::vector<std::size_t>& order) {
    std::vector<double> result;
    for (const std::size_t i : order) result.push_back(values[i]);
    return result;
}

/// Standard error of Σ growth / Σ duration from the blocks' deviations growth − rate · duration.
double ratio_error(const std::vector<double>& growth, const std::vector<double>& duration, double rate) {
    std::vector<double> deviations(growth.size());
    for (std::size_t b = 0; b < growth.size(); ++b) deviations[b] = growth[b] - rate * duration[b];
    const double total = std::accumulate(duration.begin(), duration.end(), 0.0);
    return block_error(deviations).standard_error * static_cast<double>(growth.size()) / total;
}

}  // namespace

std::string_view name_of(LyapunovOutcome outcome) {
    using enum LyapunovOutcome;
    return name_in<LyapunovOutcome>({{completed, "completed"},
                                     {ended_in_transient, "ended-in-transient"},
                                     {ended_early, "ended-early"},
                                     {not_finite, "not-finite"}},
                                    outcome);
}

ExponentAccumulator::ExponentAccumulator(std::size_t dimension, const LyapunovOptions& options)
    : options_(options),
      sums_(dimension, 0.0),
      compensation_(dimension, 0.0),
      lost_(dimension, 0),
      annihilations_(dimension),
      blocks_(dimension + 1),
      wandering_(dimension),
      channels_(dimension + 1) {
    require(options.steps >= 1, "steps", static_cast<double>(options.steps), "at least 1");
    require(options.transient >= 0, "transient", static_cast<double>(options.transient), "at least 0");
    require(options.checkpoints >= 1, "checkpoints", options.checkpoints, "at least 1");
    require(options.rank_tolerance >= 0 && options.rank_tolerance < 1, "rank_tolerance", options.rank_tolerance,
            "in [0, 1)");
    const std::int64_t half = options.steps / 2;
    const std::vector<double> zeros(dimension, 0.0);
    weighted_ = {{0, options.steps, 0, zeros}, {0, half, 0, zeros}, {options.steps - half, half, 0, zeros}};
    if (options.spacing == CheckpointSpacing::even) {
        next_checkpoint_ = std::max<std::int64_t>(1, options.steps / options.checkpoints);
    }
}

void ExponentAccumulator::add(std::span<const double> log_growth, double duration) {
    ++step_;
    time_ += duration;
    std::size_t losses = 0;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        const bool lost = log_growth[i] == -infinity;
        if (lost) ++lost_[i], ++losses;
        const double growth = lost ? 0 : log_growth[i];
        const double sum = sums_[i] + growth;
        compensation_[i] +=
            std::abs(sums_[i]) >= std::abs(growth) ? (sums_[i] - sum) + growth : (growth - sum) + sums_[i];
        sums_[i] = sum;
        channels_[i] = growth;
        wandering_[i].add(growth);
    }
    if (losses > 0) note_losses(losses);
    channels_.back() = duration;
    blocks_.add(channels_);
    add_weighted(channels_);
    if (step_ == next_checkpoint_) checkpoint();
}

void ExponentAccumulator::note_losses(std::size_t directions) {
    Annihilation& those = annihilations_[directions - 1];
    if (those.steps++ == 0) those.first = step_;
    those.directions = static_cast<std::int64_t>(directions);
    those.last = step_;
}

void ExponentAccumulator::add_weighted(std::span<const double> growth) {
    for (WeightedSum& part : weighted_) {
        const double position = static_cast<double>(step_ - part.first) / (static_cast<double>(part.length) + 1);
        const double weight = birkhoff_weight(position);
        if (weight == 0) continue;
        part.weight += weight;
        for (std::size_t i = 0; i < part.sums.size(); ++i) part.sums[i] += weight * growth[i];
    }
}

std::vector<double> ExponentAccumulator::means() const {
    std::vector<double> result(sums_.size(), nan);
    if (step_ == 0) return result;
    for (std::size_t i = 0; i < sums_.size(); ++i) {
        result[i] = lost_[i] > 0 ? -infinity : (sums_[i] + compensation_[i]) / static_cast<double>(step_);
    }
    return result;
}

void ExponentAccumulator::checkpoint() {
    record_.push_back({step_, time_, means()});
    const double steps = static_cast<double>(options_.steps);
    if (options_.spacing == CheckpointSpacing::even) {
        next_checkpoint_ += std::max<std::int64_t>(1, options_.steps / options_.checkpoints);
    } else {
        const double ratio = std::pow(steps, 1.0 / options_.checkpoints);
        next_checkpoint_ = std::max(step_ + 1, static_cast<std::int64_t>(static_cast<double>(step_) * ratio));
    }
}

LyapunovSpectrum ExponentAccumulator::finish(LyapunovOutcome outcome) const {
    LyapunovSpectrum result;
    result.outcome = outcome;
    result.steps = step_;
    result.time = time_;
    const std::vector<double> mean = means();
    const std::vector<std::size_t> order = falling_order(mean);
    result.exponents = permuted(mean, order);
    result.block_length = blocks_.block_length();
    const std::vector<double>& durations = blocks_.sums(sums_.size());
    for (const std::size_t i : order) {
        const bool lost = lost_[i] > 0;
        const std::vector<double>& growth = blocks_.sums(i);
        const double per_time = mean[i] * static_cast<double>(step_) / time_;
        const BlockError error = block_error(growth);
        result.per_time.push_back(per_time);
        result.standard_errors.push_back(lost ? nan : error.standard_error / static_cast<double>(result.block_length));
        result.per_time_standard_errors.push_back(lost ? nan : ratio_error(growth, durations, per_time));
        result.effective_blocks.push_back(error.effective_blocks);
        result.growth_orders.push_back(lost ? nan : wandering_[i].growth_order());
        result.lost_ranks.push_back(lost_[i]);
        const std::int64_t kept = step_ - lost_[i];
        result.without_losses.push_back(kept > 0 ? (sums_[i] + compensation_[i]) / static_cast<double>(kept) : nan);
        result.block_sums.push_back(lost ? std::vector<double>{} : growth);
        const bool weighted = outcome == LyapunovOutcome::completed && weighted_[1].weight > 0;
        const auto average = [&](const WeightedSum& part) { return part.sums[i] / part.weight; };
        result.weighted_exponents.push_back(!weighted ? nan : lost ? -infinity : average(weighted_[0]));
        result.weighted_half_difference.push_back(
            !weighted || lost ? nan : std::abs(average(weighted_[1]) - average(weighted_[2])));
    }
    for (const Annihilation& those : annihilations_)
        if (those.steps > 0) result.annihilations.push_back(those);
    result.record = record_;
    if (step_ > 0 && (record_.empty() || record_.back().step != step_)) result.record.push_back({step_, time_, mean});
    for (Checkpoint& point : result.record) point.exponents = permuted(point.exponents, order);
    return result;
}

}  // namespace swirl::analysis
