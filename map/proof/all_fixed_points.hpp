// All fixed points of a scene up to a flight time, with the proof that there are no others: README.md, "All of them".
#pragma once

#include "map/proof/claim.hpp"

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

namespace swirl::proof {

/// What could not be decided: a part of the plane of (τ, φ), or a solution in it.
struct OpenCell {
    double tau_low = 0, tau_high = 0;
    double phi_low = 0, phi_high = 0;  ///< φ = ψ + χ, the direction of the struck corner from the swirl's arm
    std::string reason;
};

struct AllFixedPoints {
    double max_time = 0;
    std::vector<CycleProof> proven;   ///< by the + branch (cos φ > 0) first, then rising τ
    std::vector<CycleProof> refuted;  ///< solutions of the two equations that are proven to be no orbits, and why
    std::vector<OpenCell> open;       ///< empty: `proven` are all there are
    std::size_t cells = 0;            ///< that were looked at
    std::string none;                 ///< why there are none, where that follows from the scene's numbers alone

    bool complete() const { return open.empty(); }
};

/// Every fixed point of F with impacts and 0 < τ ≤ max_time. Isolated ones: a polygon with friction and swirl, or a
/// scene that has none.
///   stop  true: end; what was not looked at is then `open`
/// Cost: some seconds.
/// @throws std::invalid_argument where fixed points come in families, or max_time is out of range
AllFixedPoints all_fixed_points(const Scene<double>& scene, double max_time, const std::function<bool()>& stop);

}  // namespace swirl::proof
