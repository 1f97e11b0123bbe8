// Chaos, proven: sets about saddle cycles and about orbits that lead from one to another, which F carries over each
// other, and the entropy of the paths from set to set.
#pragma once

#include "apps/studies/certify/certified_orbit.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "map/proof/covering_claim.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::certify {

/// Heights in widths, at least, and the largest width.
struct SetShape {
    double aspect = 1, widest = 0.1;
};

struct ChaosOptions {
    int longest_link = 12;  ///< impacts of an orbit between two cycles, at most
    int most_links = 64;    ///< orbits between cycles that are taken, the shortest first
    int scan = 4000;        ///< points of an unstable manifold that are tried, per set and side
    /// Of sets about cycles; that from which most follows is taken.
    std::vector<SetShape> shapes{{1, 0.1}, {4, 0.1}, {0.25, 0.1}, {16, 0.1}, {0.25, 0.02}, {1, 0.02}, {1, 0.0003}};
    int most_pieces = 3000;  ///< of a set, after which nothing is said
    int exponent_impacts = 20'000;
    RunControl control = {};
};

/// One of the cycles that were asked for.
struct ChaosCycle {
    std::size_t number = 1;
    std::size_t period = 1;
    double multiplier = 0;      ///< outside the unit circle
    std::size_t first_set = 0;  ///< of its sets, one a point
    std::string reason;         ///< why it is left out; empty: it is not
};

/// An orbit from one cycle to another, its sets, and whether all its links are proven.
struct ChaosLink {
    std::size_t from = 0, to = 0;  ///< cycles by number
    std::size_t first_set = 0, sets = 0;
    bool proven = false;
    std::string reason;  ///< empty if it is proven
};

struct ProvenChaos {
    Scene<double> scene;
    std::vector<ChaosCycle> cycles;
    std::vector<ChaosLink> orbits;
    /// Those sets and links alone that are proven; what one set is carried over has no common point, two by two.
    proof::ChaosClaim claim;
    std::vector<int> pieces;  ///< of each of its links
    proof::GrowthBound bound;
    double exponent = 0;    ///< the largest Lyapunov exponent of an orbit from the first set: a number without proof
    std::size_t found = 0;  ///< orbits between cycles, those not taken included
    std::string reason;     ///< why there is no chaos proven; empty if there is
    bool whole = true;      ///< false: a stop left some out

    bool proven() const { return bound.entropy > 0; }
};

/// From cycles of one scene (and of one level of J where it is conserved: that of the first).
/// @throws as proof::require_chart
ProvenChaos proven_chaos(const Scene<double>& scene, const std::vector<CyclePlace>& places,
                         const ChaosOptions& options);

/// A point of a set, (q, side, 0, …) in the set's own coordinates, and where F carries it, in those of the set that
/// this one is carried over: that is crossed from q = −1 to 1, between −1 and 1 of the others.
struct CarriedPoint {
    std::size_t covering = 0;  ///< of `claim.links`, from 0
    double q = 0, side = 0;
    double carried_q = 0, carried_side = 0;
};

/// Of each covering so many q, evenly from −1 to 1, on the sides −1, 0 and 1: to be drawn, no part of the proof. Points
/// that lead to no impact are left out.
std::vector<CarriedPoint> carried_points(const ProvenChaos& found, int count);

}  // namespace swirl::studies::certify
