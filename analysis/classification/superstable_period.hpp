// The period of an orbit on a superstable cycle.
#pragma once

#include "analysis/classification/period.hpp"
#include "analysis/lyapunov/lyapunov_spectrum.hpp"

#include <cmath>
#include <cstdint>

namespace swirl::analysis {

/// The cycle of an orbit whose derivatives annihilate every direction: one return is enough, so that periods up to the
/// tail's length are found. The last 64 states must come back to `closure`, and the annihilation must lie within the
/// period: else it may be an unstable cycle in passing. Period 0 if not so. O(n), k derivatives.
template <SectionMap M>
FoundCycle<M> find_superstable_period(const M& map, const Tail<M>& tail, const PeriodOptions& options = {}) {
    constexpr std::int64_t states = 64;
    FoundCycle<M> found;
    const auto n = static_cast<std::int64_t>(tail.points.size());
    for (std::int64_t k = 1; k <= n - states; ++k) {
        const double returned = classification_detail::return_distance(map, tail, k, states, options.closure);
        if (returned > options.closure) continue;
        LyapunovOptions once;
        once.transient = 0;
        once.steps = k;
        const auto growth = largest_exponent(map, tail.last, once);
        if (growth.outcome != LyapunovOutcome::completed || !std::isinf(growth.exponents.front())) break;
        found.period = k;
        found.point = tail.points.back();
        found.state = tail.last;
        found.closure = found.residual = returned;
        found.closure_persists = found.approached = found.superstable = true;
        found.rounding = rounding_growth(map, found.state, k);
        break;
    }
    return found;
}

}  // namespace swirl::analysis
