#include "analysis/lyapunov/exponent_record.hpp"

#include "analysis/argument_error.hpp"
#include "analysis/enum_name.hpp"
#include "analysis/rotation/weighted_birkhoff.hpp"
#include "analysis/special_values.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

namespace swirl::analysis {

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
