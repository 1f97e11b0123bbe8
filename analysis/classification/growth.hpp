// By which power a quantity grows along an orbit. analysis/classification/README.md, "Growth".
#pragma once

#include "analysis/special_values.hpp"

#include <span>
#include <vector>

namespace swirl::analysis {

/// γ of x ~ n^γ, and its interval of 95 %; NaN where it could not be fitted.
struct GrowthExponent {
    double value = nan, low = nan, high = nan;
};

/// Means of x over blocks of equal length.
///   blocks  at most as many as there are values
std::vector<double> block_means(std::span<const double> series, int blocks);

/// The slope of ln x over ln n, least squares through the means of 32 blocks, with ± 2.04 standard errors from the
/// blocks' scatter (Student's t, 30 degrees of freedom). NaN if a mean is not positive, or there are fewer than 320
/// values. An exponent of the range that was followed: of (n₀ + n)^γ it is smaller while n₀ matters.
///   series  x after each step
///   first   steps before the first value, from which n is counted
GrowthExponent growth_exponent(std::span<const double> series, double first);

/// Does x grow without bound, as far as a stretch can tell: each of eight blocks' means above the one before, the last
/// a hundred times the first? What keeps to an attractor is there again and again.
bool grows_geometrically(std::span<const double> series);

}  // namespace swirl::analysis
