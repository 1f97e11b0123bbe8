// Angles as angles: a number less whole periods.
#pragma once

#include <cmath>

namespace swirl::analysis {

/// x less the whole multiple of the period P that leaves it in [−P/2, P/2], exactly; x itself for a plain number, P =
/// 0. The bits of std::remainder, which takes 20 times as long: most are differences of angles in (−P/2, P/2], below
/// 3P/2, and of |x| in [P/2, 2P] x − P has no rounding (Sterbenz's lemma).
inline double within_period(double x, double period) {
    if (!(period > 0)) return x;
    const double size = std::abs(x);
    if (size <= 0.5 * period) return x;
    if (!(size < 1.25 * period)) return std::remainder(x, period);
    return std::copysign(1.0, x) * (size - period);
}

}  // namespace swirl::analysis
