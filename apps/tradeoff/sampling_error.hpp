// The standard error of a time mean over impacts that are correlated.
#pragma once

#include "analysis/lyapunov/block_sums.hpp"

#include <numeric>
#include <span>

namespace swirl::apps::tradeoff {

/// Time mean Σ integrals / Σ durations, and its standard error: of the sums of (integral − mean · duration) over 32 to
/// 64 blocks, with what correlation remains between neighbours. NaN below 4 blocks.
struct TimeMean {
    double mean = 0, error = 0;
};

inline TimeMean time_mean(std::span<const double> integrals, std::span<const double> durations) {
    TimeMean found;
    const double time = std::accumulate(durations.begin(), durations.end(), 0.0);
    found.mean = std::accumulate(integrals.begin(), integrals.end(), 0.0) / time;
    analysis::BlockSums blocks(1);
    for (std::size_t i = 0; i < integrals.size(); ++i) blocks.add({integrals[i] - found.mean * durations[i]});
    found.error = analysis::block_error(blocks.sums(0)).standard_error * static_cast<double>(blocks.blocks()) / time;
    return found;
}

}  // namespace swirl::apps::tradeoff
