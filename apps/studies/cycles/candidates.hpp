// Where to look for cycles of a scene.
#pragma once

#include "analysis/cycles/find_cycles.hpp"
#include "analysis/random_draws.hpp"
#include "analysis/section_map.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "map/model/scene.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace swirl::studies::cycles {

// Uniform numbers of one candidate, by a generator that is keyed by its place: the same whatever came before.

struct Draws {
    std::array<double, 8> u;  ///< in (0, 1]

    Draws(std::uint64_t seed, std::uint64_t period, std::uint64_t index) {
        for (std::uint64_t half = 0; half < 2; ++half) {
            const auto four = analysis::uniform_draws({index, period, half, 0x6f72626974}, {seed, 1});
            std::copy(four.begin(), four.end(), u.begin() + 4 * static_cast<std::ptrdiff_t>(half));
        }
    }
    double between(std::size_t i, double low, double high) const { return low + (high - low) * u[i]; }
};

struct CandidateOptions {
    std::int64_t starts = 1500;      ///< random section points, of the first search
    std::int64_t trajectories = 16;  ///< orbits whose close returns are taken
    std::int64_t collisions = 2000;  ///< impacts of each
    double speed = 1.0 / 7;          ///< of the trajectories' random starts
    std::uint64_t seed = 1;
    Accuracy accuracy = Accuracy::double_precision;  ///< in which each step is computed (SceneMap)
    int returns = 30;                                ///< close returns per trajectory and period
    double vicinity = 0.5;                           ///< how close (Euclidean)
};

/// Trajectories from random starts, transients included: each a list of states on the section. Once stopped, what there
/// is; and so below.
std::vector<analysis::CyclePoints> trajectories_of(const Scene<double>& scene, const CandidateOptions& options,
                                                   const analysis::Stop& stop = {});

/// The trajectories' close returns and last k states.
std::vector<analysis::CyclePoints> returning_candidates(const analysis::ShootingMap& map, int k,
                                                        const std::vector<analysis::CyclePoints>& trajectories,
                                                        const CandidateOptions& options);

/// Random section points number `from` to `to` − 1, each followed for a few impacts. Philox keyed by the seed: the same
/// each time.
std::vector<analysis::CyclePoints> random_candidates(const Scene<double>& scene, const analysis::ShootingMap& map,
                                                     int k, std::int64_t from, std::int64_t to,
                                                     const CandidateOptions& options, const analysis::Stop& stop = {});

}  // namespace swirl::studies::cycles
