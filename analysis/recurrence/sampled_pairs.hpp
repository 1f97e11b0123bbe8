// Measures estimated from random pairs of points, with standard errors: for series whose n² pairs are out of reach.
//
// Pairs (i, j), |i − j| ≥ W, are drawn with equal chances, with replacement, and in a random order of the two. Of a
// pair that recurs the diagonal and the upright line through it are followed both ways. Lines are met in proportion to
// their lengths; with weights g that add up to 1 along each line the mean of g over all pairs is the number of lines
// over that of pairs, without bias: g = 1/l of a line of at most C points; of a longer one 1/C at its first C points,
// else 0, so that no line is followed farther than C points each way. Over k pairs, K of them recurrent, with a = 1 in
// a line of at least the minimal length:
//
//     RR = K/k      DET, LAM = Σa/K      L, TT = Σa/Σ(a g)
//
// RR is without bias, DET and LAM are given K; L and TT are ratios, whose bias falls like 1/k. Standard errors: of
// shares √(p(1 − p)/n) at p = (x + 2)/(n + 4), so that 0 and n of n have one, too (Agresti & Coull, Am. Stat. 52 (1998)
// 119); of ratios √Σ(a − L a g)² / Σ(a g), with two points in lines of the minimal length, where g is largest, added to
// those that were met.
#pragma once

#include "analysis/recurrence/measures.hpp"
#include "analysis/recurrence/metric.hpp"

#include <cstdint>
#include <string>

namespace swirl::analysis::recurrence {

/// Points to which a line is followed each way (C), or its minimal length if that is more.
inline constexpr std::uint64_t longest_followed = 1024;

struct SampledPairs {
    std::uint64_t pairs = 0, recurrent = 0;
    Measures measures;  ///< RR, DET, L, LAM, TT; the others are NaN: they need all pairs
    Measures errors;    ///< standard errors of these; of L and TT NaN without a line
};

/// Why these settings cannot be sampled; empty: they can. Norm, strictness, minimal lengths and a window from 1 on are
/// free, all else is as in the default.
std::string obstacle_to_sampling(const Settings& settings);

/// Equal arguments give equal bits, whatever the number of threads. Without a recurrent pair DET and LAM, L and TT are
/// NaN. Cost: two random points a pair; of a recurrent one up to 4 C more.
/// @throws std::invalid_argument for pairs = 0, points with gaps, too few of them for the window, or such settings
SampledPairs sample_pairs(const Points& points, double threshold, std::uint64_t pairs, std::uint64_t seed,
                          const Settings& settings = {});

}  // namespace swirl::analysis::recurrence
