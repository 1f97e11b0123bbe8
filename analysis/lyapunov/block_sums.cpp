#include "analysis/lyapunov/block_sums.hpp"

#include "analysis/special_values.hpp"

#include <gsl/gsl_fit.h>
#include <gsl/gsl_statistics_double.h>

#include <algorithm>
#include <cmath>

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

}  // namespace swirl::analysis
