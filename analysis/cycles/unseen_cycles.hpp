// How many cycles a search has missed, from how often it found each: Chao's estimator of unseen species.
//
// Of n solutions, one for each candidate that led to a cycle, f₁ cycles were found once and f₂ twice. At least about
//
//     f₀ = ((n − 1)/n) f₁(f₁ − 1)/(2(f₂ + 1))
//
// were found by none: exact in the mean where all cycles are equally easy to find, a lower bound where they are not.
// Sources: A. Chao, Scand. J. Statist. 11 (1984) 265; A. Chao, Biometrics 43 (1987) 783 (the interval); A. Chao, R. K.
// Colwell, in: Handbook of Capture–Recapture Analysis (2005) (f₂ = 0 included).
#pragma once

#include <cstdint>
#include <span>

namespace swirl::analysis {

struct UnseenCycles {
    std::int64_t samples = 0;  ///< n
    std::int64_t found = 0;    ///< cycles
    std::int64_t once = 0;     ///< f₁
    std::int64_t twice = 0;    ///< f₂
    double missed = 0;         ///< f₀; 0 without samples
    /// Of `missed` at 95 %: log-normal, Chao 1987. Both 0 where f₀ is 0: a cycle that leads 3/n of the candidates or
    /// more to it would have been found at 95 %, and nothing is known of those that lead fewer.
    double least_missed = 0, most_missed = 0;
};

///   times  how often each cycle was found; zeros (cycles known otherwise) count as found, but as no sample
UnseenCycles unseen_cycles(std::span<const std::int64_t> times);

}  // namespace swirl::analysis
