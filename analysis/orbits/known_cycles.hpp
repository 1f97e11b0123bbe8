// Cycles found so far, each once, and one of each family.
#pragma once

#include "analysis/orbits/family.hpp"

#include <vector>

namespace swirl::analysis {

class KnownCycles {
public:
    /// The map must outlive it.
    ///   same            cycles nearer than that are one
    ///   one_per_family  members of a family that is known already are known
    KnownCycles(const ShootingMap& map, double p, double same, bool one_per_family)
        : map_(map), p_(p), same_(same), one_per_family_(one_per_family) {}

    /// Adds the cycle unless it, a cyclic shift of it or another member of its family is there. Works out what is known
    /// of a new one. False if it was known, or if the map ends on it.
    bool add(const CyclePoints& points, double residual);

    const std::vector<Cycle>& cycles() const { return cycles_; }

private:
    bool contains(const CyclePoints& points) const;
    bool contains_family_of(const CyclePoints& points, Eigen::Index dimension) const;

    const ShootingMap& map_;
    double p_;
    double same_;
    bool one_per_family_;
    std::vector<Cycle> cycles_;
    std::vector<FamilyCurve> curves_;  ///< one a cycle; empty for isolated ones and for families of more parameters
};

}  // namespace swirl::analysis
