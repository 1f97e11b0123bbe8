// The cycles of a scene, period by period, and what is known of those that were not found: all fixed points of impacts
// alone from their equations, the others from candidates.
#pragma once

#include "analysis/curves/shooting_map.hpp"
#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/find_cycles.hpp"
#include "apps/studies/cycles/candidates.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/scene_map/accuracy.hpp"
#include "map/steady/steady_modes.hpp"

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace swirl::studies::cycles {

// What a search for cycles found, and what is known of what it did not find.

/// The search for cycles of one period.
struct PeriodSearch {
    int period = 1;
    std::int64_t tried = 0;           ///< guesses
    std::int64_t converged = 0;       ///< of them that led to a cycle, of a divisor of the period included
    std::int64_t from_equations = 0;  ///< cycles that `dragged_cycles` has and no guess led to
    analysis::UnseenCycles unseen;    ///< of period 1 with `FoundOrbits::steady`: of the cycles through contact alone
    bool wants_more = false;          ///< it was to go on, and the estimate of what was missed did not come to none
};

/// The fixed points of impacts alone, from their two equations.
struct SteadySearch {
    double max_time = 0;                ///< flight time up to which they are sought
    SteadySet set = SteadySet::points;  ///< none, isolated ones or families
    std::size_t found = 0;              ///< points or families
    double complete_to = 0;  ///< all with τ ≤ this are listed; less than max_time where there are too many
    std::vector<SteadyFamily> families;  ///< where they come in families
    std::size_t not_fixed = 0;           ///< of the exact map's: those that a map with another search doesn't have

    bool is_complete() const { return complete_to >= max_time; }
};

/// An orbit that ends before it has as many impacts as the period that was asked for.
struct ShortOrbit {
    int period = 1;
    int impacts = 0;
};

struct FoundOrbits {
    std::vector<analysis::Cycle> cycles;
    std::vector<PeriodSearch> searches;  ///< not of one near a point
    std::optional<SteadySearch> steady;  ///< where period 1 was asked for, not of one near a point
    std::int64_t tried = 0;
    std::int64_t converged = 0;
    int iterations = 0;                                         ///< of the solution near a point
    double reached = std::numeric_limits<double>::quiet_NaN();  ///< residual that it reached; NaN: nothing to solve
    double distance = std::numeric_limits<double>::infinity();  ///< of the nearest point of a cycle from that point
    std::vector<ShortOrbit> too_short;                          ///< orbits from the point that end before they have k
    std::vector<std::string> limits;                            ///< what the search left out
    Accuracy accuracy = Accuracy::double_precision;             ///< of the map that has these cycles
    bool interrupted = false;
    bool none_exist = false;  ///< proven: every impact takes (map/model/scene.hpp, `is_dissipative_without_drive`)

    bool wants_more() const {
        for (const PeriodSearch& search : searches)
            if (search.wants_more) return true;
        return false;
    }
};

/// The mean of S just after the impacts.
inline double mean_spin_per_impact(const analysis::Cycle& cycle) {
    double sum = 0;
    for (const auto& z : cycle.points) sum += z[z.size() - 1];
    return sum / static_cast<double>(cycle.period());
}

inline constexpr double accepted = 1e-11;  ///< residual of a cycle; those found end near 10⁻¹⁵

struct FindOptions {
    CandidateOptions candidates;
    int first_period = 1, last_period = 1;
    double max_time = 12;  ///< flight time of fixed points, in 1/ω_s
    /// Search on, twice as long each time, until the estimate of what was missed is none and twice as many candidates
    /// have brought nothing new, …
    bool complete = false;
    std::int64_t most_starts = 200'000;  ///< … or that many random section points of a period were tried
    RunControl control = {};
};

/// Cycles of each period, each once. Period 1: `find_steady_cycles`, and by search those that lead through contact.
/// Cost: some milliseconds a candidate and period.
FoundOrbits find_orbits(const Scene<double>& scene, const analysis::ShootingMap& map, const FindOptions& options);

}  // namespace swirl::studies::cycles
