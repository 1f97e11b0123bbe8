// How often something happens that happened k times in n trials, and how fast orbits leave chaos.
#pragma once

#include "analysis/special_values.hpp"

#include <cstdint>
#include <span>

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

// How fast orbits leave chaos, from when some of several did and how long the others have been in it.
//
// A chaotic transient forgets how long it has lasted: the times at which orbits leave are exponential. With k orbits
// that left and T all the time that was spent in chaos, by those and by the others (censored), the rate is k/T, its
// interval from χ²₂ₖ/(2T) to χ²₂ₖ₊₂/(2T) (χ²₂ₖ where none is left), and half of the orbits leave within ln 2/rate.
// Sources: T. Tél, Y.-C. Lai, Phys. Rep. 460 (2008) 245 (escape from chaotic saddles); B. Epstein, M. Sobel, J. Amer.
// Statist. Assoc. 48 (1953) 486 (censored exponential lives).

/// One orbit: the steps that it spent in chaos, and whether it then left.
struct ChaoticStay {
    std::int64_t steps = 0;
    bool left = false;
};

struct EscapeRate {
    std::int64_t left = 0;        ///< k
    std::int64_t remaining = 0;   ///< still in chaos
    double steps = 0;             ///< T
    double rate = 0;              ///< k/T, per step
    double least_rate = 0;        ///< at 95 %
    double most_rate = infinity;  ///< at 95 %; for k = 0, 3/T
    double half_life = infinity;  ///< steps: ln 2/rate
    /// How likely it is, at one rate for all, that no more left in the later half of the longest stay than did: small
    /// where those that remain keep to an attractor of their own.
    double late_share = 1;
    /// The others are to be expected to leave, too: at least three left, and `late_share` ≥ 0.05.
    bool others_will_leave = false;
};

/// Cost: a pass over the stays.
///   settling  steps at the start that are left out of every stay: orbits that leave earlier may never have been in
///             chaos
EscapeRate escape_rate(std::span<const ChaoticStay> stays, std::int64_t settling);

/// The chance that an orbit which is still in chaos leaves it within so many steps more, at 95 % no larger than
///
///     1 − e^{−λ n},   λ = χ²_{0.95, 2(k+1)}/(2T)
///
/// after T steps in chaos of it and others, of which k have left (for k = 0, λ = 3/T). 1 for T = 0. It assumes one rate
/// for all, at all times.
double chance_of_leaving(std::int64_t left, double steps, double more);

}  // namespace swirl::analysis
