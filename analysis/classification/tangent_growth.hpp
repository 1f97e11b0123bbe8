// How fast a tangent vector grows along an orbit: the cheapest sign of chaos.
#pragma once

#include "analysis/classification/tail.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace swirl::analysis {

/// Mean of ln growth per step, and its standard error from blocks.
struct TangentGrowth {
    double mean = 0;
    double error = 0;
    bool whole = false;  ///< false: the map ended, or a derivative lost its rank, on the way

    /// More than 5 standard errors above zero, and more than a neutral vector's growth n^0 … n^1 could feign.
    bool is_positive(std::int64_t steps) const {
        return whole && mean > 5 * error &&
               mean * static_cast<double>(steps) > 3 * std::log(static_cast<double>(steps));
    }
};

/// Follows a generic vector from `z` for `align` + `steps` steps; the first ones only turn it. Cost: one derivative a
/// step. The vector's growth over the blocks is the largest Lyapunov exponent's estimate (Benettin et al. 1980).
template <SectionMap M>
TangentGrowth tangent_growth(const M& map, Vector<M::dimension> z, std::int64_t align, std::int64_t steps) {
    constexpr std::int64_t blocks = 8;
    Vector<M::dimension> v;
    for (int i = 0; i < M::dimension; ++i) v[i] = std::cos(1.0 + i);  // no direction of any of our maps
    std::array<double, blocks> sums{};
    const std::int64_t length = steps / blocks;
    for (std::int64_t i = 0; i < align + blocks * length; ++i) {
        const auto step = map.linearise(z);
        if (!step.alive) return {};
        v = step.derivative * v;
        const double norm = v.norm();
        if (!(norm > 0) || !std::isfinite(norm)) return {};
        v /= norm;
        if (i >= align) sums[static_cast<std::size_t>((i - align) / length)] += std::log(norm);
        z = step.state;
    }
    TangentGrowth growth;
    for (const double sum : sums) growth.mean += sum / static_cast<double>(blocks * length);
    double square = 0;
    for (const double sum : sums) square += std::pow(sum / static_cast<double>(length) - growth.mean, 2);
    growth.error = std::sqrt(square / (blocks * (blocks - 1)));
    growth.whole = true;
    return growth;
}

}  // namespace swirl::analysis
