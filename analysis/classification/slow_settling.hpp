// Does a quantity that changes ever more slowly come to a limit, and how far is it still from it?
#pragma once

#include "analysis/special_values.hpp"

#include <cmath>
#include <span>

namespace swirl::analysis {

/// A rate of change ∝ n^(−p): with p > 1 the changes to come have a sum.
struct SlowSettling {
    double exponent = 0;          ///< p; 0 where the changes do not fall steadily
    double remaining = infinity;  ///< what is still to come after the last value
};

/// From the means of a quantity over four equal quarters of the second half of a history (n from 1 to 2): the changes
/// from quarter to quarter, at n = 5/4, 3/2 and 7/4, have one sign and fall. What falls faster than any power gives a
/// large p, and a bound of what is to come.
inline SlowSettling settling_of(std::span<const double, 4> quarters) {
    const double first = quarters[1] - quarters[0], second = quarters[2] - quarters[1],
                 third = quarters[3] - quarters[2];
    SlowSettling result;
    const bool steady = first * second > 0 && second * third > 0 && std::abs(first) > std::abs(second) &&
                        std::abs(second) > std::abs(third);
    if (!steady) return result;
    result.exponent = std::log(first / third) / std::log(7.0 / 5);
    if (result.exponent <= 1) return result;
    const double rate = std::abs(third) / 0.25;  // at n = 7/4
    result.remaining = rate * 2 * std::pow(7.0 / 8, result.exponent) / (result.exponent - 1);
    return result;
}

}  // namespace swirl::analysis
