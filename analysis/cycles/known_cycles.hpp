// Cycles found so far, each once, and one of each family.
#pragma once

#include "analysis/cycles/family.hpp"

#include <map>
#include <optional>
#include <vector>

namespace swirl::analysis {

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

}  // namespace swirl::analysis
