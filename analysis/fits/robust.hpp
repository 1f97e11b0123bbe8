// Robust estimates of centre and scale, and resamples.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::analysis {

// Robust scales, weights and quantiles that the fits share.

/// Tukey's biweight, w(r) = (1 − (r/c)²)² within c and 0 beyond; c in standard deviations for 95 % of the efficiency of
/// least squares on normal residuals of one and of three dimensions (Maronna, Martin & Yohai 2006, section 6.4).
inline constexpr double biweight_of_one = 4.685;
inline constexpr double biweight_of_three = 5.49;
/// Median of χ² with 1 and with 3 degrees of freedom.
inline constexpr double median_square_of_one = 0.454936;
inline constexpr double median_square_of_three = 2.365974;

inline double biweight(double square, double cut) {
    const double left = 1 - square / (cut * cut);
    return left > 0 ? left * left : 0;
}

/// The least value with at least half of the weight at or below it; NaN without any.
double weighted_median(std::vector<double> values, std::vector<double> weights);

/// The p-quantile, 0 ≤ p ≤ 1: value number p (n + 1) by size, between neighbours, so that a further draw lies below it
/// with chance p (type 6 of Hyndman & Fan 1996); NaN of none.
double quantile(std::vector<double> values, double p);

// Random subsets of measurements: the same for a seed, whatever the number of threads.

/// How often each of `count` measurements is drawn when `count` are drawn with replacement: resample number `index` of
/// the bootstrap (Efron 1979). Random123's Philox, keyed by seed and index.
std::vector<double> bootstrap_weights(std::size_t count, std::uint64_t seed, std::uint64_t index);

/// The part, 0 … parts − 1, of each of `count` measurements: random, sizes equal to within one.
std::vector<std::size_t> random_parts(std::size_t count, std::size_t parts, std::uint64_t seed);

/// Three independent normal numbers of variance 1: the i-th of a draw.
Eigen::Vector3d normal_draws(std::uint64_t seed, std::uint64_t draw, std::size_t i);

}  // namespace swirl::analysis
