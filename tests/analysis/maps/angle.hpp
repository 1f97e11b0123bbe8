// Angles of the test maps lie in [0, 2π).
#pragma once

#include <cmath>
#include <numbers>

namespace swirl::analysis::maps {

inline constexpr double two_pi = 2 * std::numbers::pi;
inline constexpr double golden_mean = std::numbers::phi - 1;  ///< (√5 − 1)/2, the most irrational rotation number

inline double wrap_angle(double angle) {
    const double wrapped = angle - two_pi * std::floor(angle / two_pi);
    return wrapped < two_pi ? wrapped : 0;
}

}  // namespace swirl::analysis::maps
