// Cycles of a map found by Newton's method from many points, those that are known, and an estimate of the others.
#pragma once

#include "analysis/cycles/family.hpp"
#include "analysis/cycles/multi_shooting.hpp"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace swirl::analysis {

// Cycles found so far, each once, and one of each family.

class KnownCycles {
public:
    /// The map must outlive it.
    ///   same            cycles nearer than that are one
    ///   one_per_family  members of a family that is known already are known
    KnownCycles(const ShootingMap& map, double p, double same, bool one_per_family)
        : map_(map), p_(p), same_(same), one_per_family_(one_per_family) {}

    /// Adds the cycle, its angles normalised, unless it, a cyclic shift of it or another member of its family is there;
    /// counts how often each comes (`Cycle::found`). False if it was known, or if the map ends on it.
    bool add(const CyclePoints& points, double residual);

    /// How often each of them came, in the order in which they were added.
    std::vector<std::int64_t> times_found() const;

    /// All of them with everything that is known of a cycle, in the order in which they were added.
    ///   threads  0: all; the result does not depend on it
    std::vector<Cycle> completed(int threads = 0) const;

private:
    std::optional<std::size_t> position_of(const CyclePoints& points) const;
    double mean_of(const CyclePoints& points) const;
    std::optional<std::size_t> position_of_family_of(const CyclePoints& points, Eigen::Index dimension) const;

    const ShootingMap& map_;
    double p_;
    double same_;
    bool one_per_family_;
    std::vector<Cycle> cycles_;                   ///< points, residual and tangents only
    std::multimap<double, std::size_t> by_mean_;  ///< cycles by a mean that no cyclic shift changes
    std::vector<FamilyCurve> curves_;  ///< one a cycle; empty for isolated ones and for families of more parameters
};

// How many cycles a search has missed, from how often it found each: Chao's estimator of unseen species.
//
// Of n solutions, one for each candidate that led to a cycle, f₁ cycles were found once and f₂ twice. At least about
//
//     f₀ = ((n − 1)/n) f₁(f₁ − 1)/(2(f₂ + 1))
//
// were found by none: exact in the mean where all cycles are equally easy to find, a lower bound where they are not.
// Sources: A. Chao, Scand. J. Statist. 11 (1984) 265; A. Chao, Biometrics 43 (1987) 783 (the interval); A. Chao, R. K.
// Colwell, in: Handbook of Capture–Recapture Analysis (2005) (f₂ = 0 included).

struct UnseenCycles {
    std::int64_t samples = 0;  ///< n
    std::int64_t found = 0;    ///< cycles
    std::int64_t once = 0;     ///< f₁
    std::int64_t twice = 0;    ///< f₂
    double missed = 0;         ///< f₀; 0 without samples
    /// Of `missed` at 95 %: log-normal, Chao 1987. Both 0 where f₀ is 0: a cycle that leads 3/n of the candidates or
    /// more to it would have been found at 95 %, and nothing is known of those that lead fewer.
    double least_missed = 0, most_missed = 0;
};

///   times  how often each cycle was found; zeros (cycles known otherwise) count as found, but as no sample
UnseenCycles unseen_cycles(std::span<const std::int64_t> times);

// All cycles of one period that the candidates lead to.

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
