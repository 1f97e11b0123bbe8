// Does a measured series repeat, within its noise?
#pragma once

#include <cstddef>
#include <span>

namespace swirl::analysis {

struct RepetitionLimits {
    double residual = 0;   ///< noise: standard deviation about the phase means, at most
    double exact = 0;      ///< rounding: what repeats within it repeats, whatever its structure
    int max_period = 256;  ///< also at most an eighth of the samples, and a sixteenth unless exact
};

struct Repetition {
    int period = 0;          ///< 0: none
    double residual = 0;     ///< standard deviation about the phase means; 0 with period 0: above the limit at every k
    double correlation = 0;  ///< largest autocorrelation of the residual; 0 for what is exact
    double chance = 1;       ///< of neighbours as correlated, phase by phase, as the residual's, were it noise
    int structured = 0;      ///< the smallest k whose residual is within the limit, but not white; 0: none
};

/// At most this is the largest autocorrelation of the residual of n samples, if it is white.
double white_autocorrelation(std::size_t n);

/// Noise has a smaller chance than this of being called structured phase by phase.
inline constexpr double smallest_chance = 1e-5;

/// The smallest k for which the k phase means leave a residual within the limit that is white: no autocorrelation up to
/// lag 2k + 8 beyond 4/√n, and no correlation of neighbours phase by phase beyond chance. The second is what tells
/// chaos in k bands: the map segments each band by its own factor, of either sign, so that a residual decides the next
/// at every phase while the mean over the phases sees nothing. A residual that is small but structured is that of a
/// longer period, or no noise at all: a torus, a band, a drift. The longer period is a multiple (the phase means of k
/// know of a period q no more than those of the common divisor of k and q). Its residual is rounding, or white and at
/// most half as large, as where a period has doubled; else more means only hide the structure, which stands.
Repetition repetition_of(std::span<const double> x, const RepetitionLimits& limits);

}  // namespace swirl::analysis
