// Whether F carries a set over another, as sampled points say: a sieve before the proof.
#pragma once

#include "apps/studies/certify/saddles.hpp"

#include <vector>

namespace swirl::studies::certify {

/// Points of q: a grid along the first direction, times the corners and the middle of the others.
///   low, high  of q_0
///   count      points along it
std::vector<Eigen::VectorXd> sampled_points(Eigen::Index dimension, double low, double high, int count);

/// With a margin of 5 % where the set is crossed and at its exits; all points of one smooth branch, as far as letters
/// say.
bool covers_in_samples(const ChartMap& map, const FramedSet& from, const FramedSet& to);

}  // namespace swirl::studies::certify
