// What comparisons of derivatives through contact with differences in 113 bits have in common.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::tests {

/// Landings or phases of one kind.
struct ComparedDerivatives {
    long compared = 0, columns = 0, left_out = 0, kinks = 0;
    double worst = 0;           ///< difference, of the derivative's largest entry
    long stopping = 0;          ///< landings whose slip stops in the rest of chatter …
    double stopping_worst = 0;  ///< … and their largest difference
};

/// Of the largest entry. An event whose rate is small (a release, a grazing λ) is known to ε by that rate: 1 in 700.
inline constexpr double usual = 1e-10, most = 1e-7;

/// The larger; a derivative that is not known is the worst of all.
inline double worse(double error, double other) {
    return std::isfinite(error) && std::isfinite(other) ? std::max(error, other)
                                                        : std::numeric_limits<double>::infinity();
}

}  // namespace swirl::tests
