// Folds, flips and Neimark–Sacker points between the boxes of a branch whose stability is decided.
#pragma once

#include "map/proof/branch_claim.hpp"
#include "map/proof/branch_system.hpp"

#include <vector>

namespace swirl::proof {

/// Where boxes whose stability is not decided lie between two with different numbers of multipliers outside the unit
/// circle: the point between, proven where the extended system encloses one that lies on the branch within those boxes.
/// Words with slip that stops at once have no second derivative there: their points are not proven.
/// Cost: some ten evaluations with second derivatives, a millisecond times the period each, a point.
std::vector<SpecialPoint> special_points(const BranchSystem& system, const std::vector<BranchBox>& boxes);

}  // namespace swirl::proof
