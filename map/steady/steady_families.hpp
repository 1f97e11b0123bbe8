// Steady modes that come in families over the flight time: without loss, e = 1, on a disk or without friction.
#pragma once

#include "map/steady/flight_times.hpp"
#include "map/steady/verified_mode.hpp"

#include <optional>
#include <vector>

namespace swirl {

/// Fixed points z(τ) for every τ of an open interval: χ = 0, ψ = 0 or π, R = 1 − α ± β. At its ends another contact
/// comes in between (grazing), or the impact vanishes (τ a multiple of 2π), or the search ends.
struct SteadyFamily {
    SteadyBranch branch = SteadyBranch::plus;
    long long j = 0;  ///< vertices on; 0 for the disk
    double from = 0, to = 0;
    bool spin_is_free = false;  ///< a frictionless disk: S is any constant besides
};

namespace steady {

/// S of the family's member at τ: (±β − R sin τ/τ)/α with friction (no slip), else 1 − 2πj/(Nτ); of a frictionless disk
/// `spin`.
double family_spin(const Scene<double>& scene, SteadyBranch branch, long long j, double tau, double spin = 0);

/// The intervals of flight times within `flights` on which the map confirms the member of (branch, j), found on a grid
/// of 0.01 and bisected: shorter ones may be missed, and shorter gaps between them. Cost: a hundred collisions per unit
/// of τ.
std::vector<SteadyFamily> families_of(const MapOfScene& map, SteadyBranch branch, long long j, Interval flights);

}  // namespace steady

/// The member of a family at τ, as the map sees it; none outside the family. `spin` is read where it is free.
std::optional<SteadyMode> member_of(const Scene<double>& scene, const SteadyFamily& family, double tau,
                                    double spin = 0);

}  // namespace swirl
