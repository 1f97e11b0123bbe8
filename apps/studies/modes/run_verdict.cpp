#include "apps/studies/modes/run_verdict.hpp"

#include "analysis/special_values.hpp"

#include <cmath>

namespace swirl::studies {

namespace {

/// NaN without a cycle; its multipliers come by falling modulus.
double ln_multiplier_of(const analysis::Classification& verdict) {
    return verdict.multipliers.empty() ? analysis::nan : std::log(std::abs(verdict.multipliers.front()));
}

}  // namespace

RunVerdict run_verdict(std::uint64_t seed, const NamedMode& named) {
    const auto& v = named.verdict;
    return RunVerdict{seed,
                      v.mode,
                      v.kind,
                      named.outcome,
                      std::int64_t{named.impacts},
                      v.period,
                      v.mean,
                      v.mean_per_step,
                      v.recurrence_rate,
                      v.largest_exponent,
                      v.largest_exponent_error,
                      ln_multiplier_of(v),
                      0,
                      v.point,
                      named.mean_errors,
                      named.growth,
                      named.limit_spin};
}

}  // namespace swirl::studies
