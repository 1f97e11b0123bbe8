// Where to look for cycles of a scene.
#pragma once

#include "analysis/cycles/find_cycles.hpp"
#include "map/model/scene.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace swirl::apps::orbits {

struct CandidateOptions {
    std::int64_t starts = 1500;      ///< random section points
    std::int64_t trajectories = 16;  ///< orbits whose close returns are taken
    std::int64_t collisions = 2000;  ///< impacts of each
    double speed = 1.0 / 7;          ///< of the trajectories' random starts
    std::uint64_t seed = 1;
    int returns = 30;            ///< close returns per trajectory and period
    double vicinity = 0.5;       ///< how close (Euclidean)
    std::function<bool()> stop;  ///< true: end with what there is
};

/// Guesses, and what was left out of them, in words.
struct SteadyGuesses {
    std::vector<analysis::CyclePoints> points;
    std::vector<std::string> limits;
};

/// Candidates for steady modes from their closed form at e = 1 (map/README.md, "Steady modes"): ψ = χ = 0, v_n =
/// −(2R/τ) sin²(τ/2), v_t = R sin τ/τ, R = β + 1 − α. For a polygon with friction one per root τ of (β − v_t)/α = 1 −
/// 2πj/(Nτ); for the disk, and without friction (where S is free), a grid of τ. For e < 1 they are guesses. Where there
/// are very many (α → 0, N → ∞) those that another vertex cuts short are left out, and for e < 1 some thousands are
/// taken of the rest.
SteadyGuesses steady_guesses(const Scene<double>& scene);

/// Trajectories from random starts, transients included: each a list of states on the section.
std::vector<analysis::CyclePoints> trajectories_of(const Scene<double>& scene, const CandidateOptions& options);

/// Everything for period k: steady guesses (k = 1), the trajectories' close returns and last k states, and random
/// section points followed for a few impacts. Philox keyed by the seed: the same candidates each time.
std::vector<analysis::CyclePoints> candidates_for(const Scene<double>& scene, const analysis::ShootingMap& map, int k,
                                                  const std::vector<analysis::CyclePoints>& trajectories,
                                                  const CandidateOptions& options);

}  // namespace swirl::apps::orbits
