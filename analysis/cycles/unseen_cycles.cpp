#include "analysis/cycles/unseen_cycles.hpp"

#include <cmath>

namespace swirl::analysis {

namespace {

/// The variance of f₀ (Chao & Colwell 2005, for all f₂ ≥ 0).
double variance_of(double share, double once, double twice) {
    const double pairs = once * (once - 1), more = twice + 1, odd = 2 * once - 1;
    return share * pairs / (2 * more) + share * share * once * odd * odd / (4 * more * more) +
           share * share * once * once * twice * (once - 1) * (once - 1) / (4 * std::pow(more, 4));
}

}  // namespace

UnseenCycles unseen_cycles(std::span<const std::int64_t> times) {
    constexpr double normal = 1.96;  // standard deviations that hold 95 %
    UnseenCycles unseen;
    for (const std::int64_t n : times) {
        ++unseen.found;
        unseen.samples += n;
        unseen.once += n == 1 ? 1 : 0;
        unseen.twice += n == 2 ? 1 : 0;
    }
    if (unseen.samples == 0) return unseen;
    const auto n = static_cast<double>(unseen.samples), once = static_cast<double>(unseen.once);
    const auto twice = static_cast<double>(unseen.twice);
    const double share = (n - 1) / n;
    unseen.missed = share * once * (once - 1) / (2 * (twice + 1));
    if (unseen.missed == 0) return unseen;
    const double spread = variance_of(share, once, twice) / (unseen.missed * unseen.missed);
    const double factor = std::exp(normal * std::sqrt(std::log1p(spread)));
    unseen.least_missed = unseen.missed / factor;
    unseen.most_missed = unseen.missed * factor;
    return unseen;
}

}  // namespace swirl::analysis
