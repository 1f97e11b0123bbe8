// The curves that are born where a cycle on a border has a multiplier 1 or −1 or a pair on the unit circle.
#pragma once

#include "apps/studies/bifurcation_curves/border_curve.hpp"
#include "apps/studies/bifurcation_curves/border_cycle.hpp"
#include "apps/studies/bifurcation_curves/plane.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace swirl::studies::bifurcation_curves {

// The border curve of the doubled cycle, which is born where a cycle on a border has a multiplier −1.

/// A cycle of twice the period on the same border, beside a cycle there with a multiplier −1: its points and flights
/// are those of the two turns ± ε times the eigenvector, and one of the turns touches, the other stays inside. Newton's
/// method on the equations of the border (border_system.hpp) and that amplitude ε, from 10⁻² down to 10⁻⁴. With μ the
/// distance along the border from the special point, ε² ~ μ (the doubled cycle's square root) and its distance from the
/// border ~ ε: the curve touches the flip curve that ends there.
/// Empty if no such cycle is found on either side.
std::optional<BorderCycle> doubled_on_border(const ItineraryMap& map, const Plane& plane, const BorderCycle& flip);

/// Special points of grazing curves of their own: a multiplier of the cycle with the impact that vanishes there.
inline constexpr const char *fold_of_impact = "fold-vanishing-impact", *flip_of_impact = "flip-vanishing-impact";

struct BornPoints {
    std::vector<StartingPoint> starting_points;
    std::size_t not_found = 0;  ///< special points, or sides of them, of which Newton's method found none
};

/// Cycles of the fold, flip and Neimark–Sacker curves that end at the special points of a curve on a border, a little
/// off it: by Newton's method on the equations of the itinerary with det = 0 (border_system.hpp; of a Neimark–Sacker
/// curve beside the special point), where what touches is 10⁻³ (if that fails, down to 10⁻⁵) inside, or the impact that
/// vanished has such a rate. Those that the map itself closes to 10⁻⁷. At a multiplier −1 also the doubled cycle on the
/// same border. Of periods up to `longest_period`.
/// Cost: some 10 k(D + 1) steps of the map for each.
BornPoints points_born_on(const ItineraryMap& itineraries, const analysis::PlaneMap& map, const Plane& plane,
                          const analysis::BoundaryOptions& options, std::size_t longest_period,
                          const BorderCurve& curve);

}  // namespace swirl::studies::bifurcation_curves
