// What the solutions of a cycle's equations are along a piece of their curve: cycles of the map, or none, or it is not
// certain; and how many multipliers lie on either side of the unit circle.
#pragma once

#include "map/proof/branch_claim.hpp"
#include "map/proof/branch_system.hpp"

#include <string>

namespace swirl::proof {

struct BoxStanding {
    Verdict verdict = Verdict::undecided;           ///< proven: cycles for all of it; refuted: none for any of it
    BranchEndKind kind = BranchEndKind::equations;  ///< of what is not certain
    std::string reason;
    bool decided = false;  ///< as many multipliers lie outside, and inside, for all of it
    int outside = 0, inside = 0;
};

/// Modes, flights and period; the multipliers if those are proven. Cost: about a millisecond times the period.
BoxStanding standing_of(const BranchSystem& system, const intervals::CurvePiece& piece);

}  // namespace swirl::proof
