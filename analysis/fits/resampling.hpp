// Random subsets of measurements: the same for a seed, whatever the number of threads.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::analysis {

/// How often each of `count` measurements is drawn when `count` are drawn with replacement: resample number `index` of
/// the bootstrap (Efron 1979). Random123's Philox, keyed by seed and index.
std::vector<double> bootstrap_weights(std::size_t count, std::uint64_t seed, std::uint64_t index);

/// The part, 0 … parts − 1, of each of `count` measurements: random, sizes equal to within one.
std::vector<std::size_t> random_parts(std::size_t count, std::size_t parts, std::uint64_t seed);

/// Three independent normal numbers of variance 1: the i-th of a draw.
Eigen::Vector3d normal_draws(std::uint64_t seed, std::uint64_t draw, std::size_t i);

}  // namespace swirl::analysis
