// All cycles of one period that the candidates lead to.
#pragma once

#include "analysis/cycles/known_cycles.hpp"
#include "analysis/cycles/multi_shooting.hpp"

#include <cstdint>
#include <functional>

namespace swirl::analysis {

struct SearchOptions {
    int period = 1;
    double accept = 1e-11;     ///< residual of a cycle
    double same = same_cycle;  ///< cycles nearer than that are one
    int threads = 0;           ///< 0: all; the result does not depend on it
    bool one_per_family = true;
    /// Tried where the map's own solver fails: see `solve_near_grazing`. Must outlive the search.
    const TimedMap* timed = nullptr;
    ShootingOptions shooting;
    /// Of the cycles of minimal period `period` those that are looked for; empty: all.
    std::function<bool(const CyclePoints& points)> wanted;
    std::function<void(double done)> progress;  ///< candidates tried so far; called from one thread at a time
    std::function<bool()> stop;                 ///< true: solve no more; what is solved is completed
};

struct SearchCounts {
    std::int64_t tried = 0;
    std::int64_t converged = 0;  ///< candidates that led to a cycle, of a divisor of the period included
};

struct SearchResult {
    SearchCounts counts;
    std::vector<Cycle> cycles;  ///< of minimal period `period`, in the order in which candidates found them
    bool stopped = false;
};

/// Solves from every candidate (k points each) and adds what has the minimal period k to `known`, in the candidates'
/// order. `one_per_family` and `same` are `known`'s.
/// Cost: one multi-shooting solution a candidate, in parallel.
SearchCounts add_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                        const SearchOptions& options, KnownCycles& known);

/// The cycles that the candidates lead to, none being known before, each once.
SearchResult find_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                         const SearchOptions& options);

/// The `count` nearest returns after k steps of a trajectory, within `vicinity`, as candidates: local minima of
/// |z_{i+k} − z_i|, nearest first.
std::vector<CyclePoints> close_returns(const ShootingMap& map, const CyclePoints& trajectory, int k, int count,
                                       double vicinity);

}  // namespace swirl::analysis
