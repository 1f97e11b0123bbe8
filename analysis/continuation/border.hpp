// The continuation of a branch behind a border of the map.
#pragma once

#include "analysis/curves/curve.hpp"

#include <cstdint>
#include <vector>

namespace swirl::analysis {

/// Searches behind the border on which `last`, the last cycle with its itinerary, lies to rounding. F is continuous
/// across most borders and DF jumps, so another smooth branch of cycles may begin there, straight on or turned back.
/// Its tangent follows from the derivative at nearby points with another itinerary.
///   itinerary_after  the itinerary found behind; empty if the map ends at all points tried
/// False if no cycle continues there. A cycle whose steps take another time than those of `last` is not a continuation.
bool find_behind(const ShootingMap& map, const CurvePoint& last, std::vector<std::int64_t>& itinerary_after,
                 CurvePoint& behind);

/// Where the map ends at a least margin (u_n = 10⁻⁶) the border itself, margin 0, lies that much farther on: moves
/// points and parameter there by the cubic through four cycles of the curve with margins of some 10⁻⁴. The derivatives
/// stay those of the last cycle.
void extrapolate_to_border(const ShootingMap& map, CurvePoint& last);

}  // namespace swirl::analysis
