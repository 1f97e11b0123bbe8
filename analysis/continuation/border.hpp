// What lies behind a border of the map.
#pragma once

#include "analysis/orbits/curve.hpp"

namespace swirl::analysis {

/// Looks behind the border that `last`, the last cycle with its word, lies on to rounding. F is continuous across most
/// borders and DF jumps, so another smooth branch of cycles may begin there, straight on or turned back. Its tangent is
/// worked out from the derivative at points a little aside that have another word.
///   word_after  the word found behind; empty if the map ends all around
/// False if no cycle begins there.
bool find_behind(const ShootingMap& map, const CurvePoint& last, std::vector<std::int64_t>& word_after,
                 CurvePoint& behind);

}  // namespace swirl::analysis
