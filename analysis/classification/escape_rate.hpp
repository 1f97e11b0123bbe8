// How fast orbits leave chaos, from when some of several did and how long the others have been in it.
//
// A chaotic transient forgets how long it has lasted: the times at which orbits leave are exponential. With k orbits
// that left and T all the time that was spent in chaos, by those and by the others (censored), the rate is k/T, its
// interval χ²₂ₖ/(2T), and half of the orbits leave within ln 2/rate.
// Sources: T. Tél, Y.-C. Lai, Phys. Rep. 460 (2008) 245 (escape from chaotic saddles); B. Epstein, M. Sobel, J. Amer.
// Statist. Assoc. 48 (1953) 486 (censored exponential lives).
#pragma once

#include "analysis/special_values.hpp"

#include <cstdint>
#include <span>

namespace swirl::analysis {

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
