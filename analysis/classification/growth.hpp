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

/// The slope of ln x over ln n, least squares through the means of 32 blocks of equal length in ln n, with ± 2.04
/// standard errors from the blocks' scatter (Student's t, 30 degrees of freedom): of noise that is independent from
/// block to block. The first values are left out while their blocks would have less than ten. NaN if a mean is not
/// positive, or there are too few values (870 of a series from its first step on, more after a transient). An exponent
/// of the range that was followed: of (n₀ + n)^γ it is smaller while n₀ matters.
///   series  x after each step
///   first   steps before the first value, from which n is counted
GrowthExponent growth_exponent(std::span<const double> series, double first);

/// Parts of a stretch that rise from each to the next: in random order one in 8! = 40,320 does.
inline constexpr int growth_parts = 8;
/// What wanders within bounds, with a memory as long as the stretch, hardly rises by so much: README, "Growth".
inline constexpr double least_growth = 1e4;

/// Does x grow without bound, as far as a stretch can tell: the mean of each of `growth_parts` parts above the one
/// before, the last `least_growth` times the first? What keeps to an attractor is there again and again.
bool grows_geometrically(std::span<const double> series);

}  // namespace swirl::analysis
