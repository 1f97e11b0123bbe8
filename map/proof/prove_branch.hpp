// Proves a branch of cycles along a parameter: README.md, "Branches of cycles".
#pragma once

#include "map/proof/branch_claim.hpp"

#include <functional>

namespace swirl::proof {

/// Follows the branch both ways from the claimed cycle, box by box, until the range ends or something is not certain of
/// boxes of a 10⁻⁹-th of it. A box along which only the stability is not certain is halved down to a 10⁻⁷-th and then
/// taken as undecided.
///   stop  true: end with what there is
/// Cost: about a millisecond times the period a box; some ten to a thousand boxes.
BranchProof prove_branch(const BranchClaim& claim, const std::function<bool()>& stop);

/// @throws std::invalid_argument where cycles come in families: e = 1 without friction, of a disk e = 1 or no friction
void require_isolated_branch(const Scene<double>& scene, Parameter parameter, double low, double high);

}  // namespace swirl::proof
