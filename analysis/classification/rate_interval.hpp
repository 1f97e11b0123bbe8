// How often something happens that happened k times in n trials.
#pragma once

#include <cstdint>

namespace swirl::analysis {

/// A rate per trial with its interval at 95 %.
struct RateInterval {
    double rate = 0;   ///< k/n
    double least = 0;  ///< 0 for k = 0
    double most = 1;   ///< 1 for k = n
};

/// Clopper and Pearson's exact interval: [B(α/2; k, n − k + 1), B(1 − α/2; k + 1, n − k)], B the quantile of the beta
/// distribution, α = 0.05. For k = 0 and k = n one of its ends is known, and all of α goes to the other: 0 of n means
/// below 1 − 0.05^{1/n}, nearly 3/n. Of independent trials it holds the true rate in at least 95 % of all cases.
/// NaN, 0 and 1 for n = 0. Source: C. J. Clopper, E. S. Pearson, Biometrika 26 (1934) 404.
/// @throws std::invalid_argument unless 0 ≤ k ≤ n
RateInterval rate_interval(std::int64_t k, std::int64_t n);

/// The upper end alone, B(c; k + 1, n − k): with this confidence c the rate is no larger. 1 for k = n, and so for n =
/// 0. Of k among n drawn without replacement it bounds the share among all, too.
/// @throws std::invalid_argument unless 0 ≤ k ≤ n and 0 < c < 1
double most_rate(std::int64_t k, std::int64_t n, double confidence);

}  // namespace swirl::analysis
