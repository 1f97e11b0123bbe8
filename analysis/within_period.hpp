// Angles as angles: a number less whole periods.
#pragma once

#include <cmath>

namespace swirl::analysis {

/// x less the whole multiple of the period P that leaves it in [−P/2, P/2], exactly; a plain number, P = 0, stays x.
/// The bits of std::remainder, which takes some twelve times as long (12 ns against 1): most x are differences of
/// angles in [−P/2, P/2], at most P, and where P/2 ≤ |x| ≤ 2P the difference |x| − P has no rounding (Sterbenz's
/// lemma).
inline double within_period(double x, double period) {
    if (!(period > 0)) return x;
    const double size = std::abs(x);
    if (size <= 0.5 * period) return x;
    if (!(size < 1.25 * period)) return std::remainder(x, period);  // well below 3P/2, from where it is two periods
    return std::copysign(1.0, x) * (size - period);
}

}  // namespace swirl::analysis
