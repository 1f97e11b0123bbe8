// The standard error of a mean along an orbit, whose values are correlated.
#pragma once

#include "analysis/special_values.hpp"

#include <cstdint>
#include <span>
#include <string_view>

namespace swirl::analysis {

enum class SamplingOutcome {
    sampled,   ///< there is a standard error
    too_short  ///< the values remember each other for too long, or are too few: no error can be told
};
std::string_view name_of(SamplingOutcome outcome);

/// How well a mean is known.
struct MeanError {
    SamplingOutcome outcome = SamplingOutcome::too_short;
    double standard_error = nan;    ///< NaN unless sampled; 0 where nothing varies
    std::int64_t block_length = 0;  ///< values in each of the blocks whose scatter gave it
    std::int64_t blocks = 0;
    double correlation_time = nan;  ///< 1 + 2 Σ_k ρ_k in values, as these blocks show it; NaN unless sampled
};

/// Of x̄ = Σ x_i / n. With v_b the variance of sums over b consecutive deviations x_i − x̄, divided by b (b = 1, 2, 4,
/// …), the error is √(v_b (1 + r)/(1 − r) / n), r = v_2b/v_b − 1 the correlation of neighbouring blocks, not below 0.
/// The shortest blocks are taken of which there are at most 63 and whose length has b³ ≥ 2n τ², τ the largest of
/// v_c/v_1 and v_1/v_c for c ≤ b; outcome `too_short` where there are then fewer than 16. Cost: 3n additions. Sources,
/// reasons and limits: analysis/means/README.md.
MeanError error_of_mean(std::span<const double> values);

/// Of R = Σ a_i / Σ b_i, to first order: of the mean of a_i − R b_i, divided by that of b_i.
/// @throws std::invalid_argument unless there are as many b_i as a_i, with a positive sum
MeanError error_of_ratio(std::span<const double> a, std::span<const double> b);

/// A bound for Σ a_i / Σ b_i along an orbit whose sums Σ_{i ≤ k} (a_i − R b_i) stay in the range that they have shown,
/// as on a torus, where they are a function on it: that range, over Σ b_i; up to twice what the limit R would give.
/// @throws as error_of_ratio
double bound_of_ratio(std::span<const double> a, std::span<const double> b);

}  // namespace swirl::analysis
