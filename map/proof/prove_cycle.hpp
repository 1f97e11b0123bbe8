// Proves a cycle of the collision map: README.md.
#pragma once

#include "map/proof/claim.hpp"

namespace swirl::proof {

/// @throws std::invalid_argument in one line unless Swirl was built with interval arithmetic (Arb); so do then the
/// other functions of this folder
void require_interval_arithmetic();

/// Proves that an explicit box about the claimed points holds exactly one cycle of F with the claimed itinerary, that
/// no vertex touches earlier on any of its flights, that every impact is in its mode, that its period is k and no less;
/// and encloses its multipliers. The scene's numbers are the shortest decimals of its doubles.
///
/// A family's member (e = 1 without friction; a disk's fixed points at e = 1) is that with the claimed S, or, where S
/// does not tell members apart, with the claimed first flight's time.
///
/// The claim may be off by rounding, not by more than 10⁻⁸. Cost: some milliseconds a step.
CycleProof prove_cycle(const Scene<double>& scene, const CycleClaim& claim);

}  // namespace swirl::proof
