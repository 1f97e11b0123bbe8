// Families: cycles that are not isolated (the disk's steady modes at e = 1, all cycles of a conservative map).
#pragma once

#include "analysis/cycles/curve.hpp"
#include "analysis/cycles/cycle.hpp"

#include <functional>
#include <vector>

namespace swirl::analysis {

struct FamilyOptions {
    double step = 0.01;      ///< longest step along the family
    double shortest = 1e-6;  ///< the walk ends where it must take shorter ones
    int most_steps = 3000;   ///< in each direction
};

/// A one-parameter family, from one end to the other through the member it was found by.
struct FamilyCurve {
    std::vector<CurvePoint> members;
    bool closed = false;  ///< the walk came back to its beginning
    double p = 0;         ///< the map's parameter
};

/// Walks along the family through a cycle with one tangent, both ways, until it ends at a border of the map or closes.
FamilyCurve walk_family(const ShootingMap& map, double p, const Cycle& cycle, const FamilyOptions& options = {});

/// The members at which `value` is `goal`, each refined to rounding: pins a family by S, or by its return time.
std::vector<CyclePoints> pinned_members(const ShootingMap& map, const FamilyCurve& family,
                                        const std::function<double(const CurvePoint&)>& value, double goal);

/// True if b lies on the family's curve.
bool belongs_to(const ShootingMap& map, const FamilyCurve& curve, const CyclePoints& b);

/// True if b can be reached from a by small steps from cycle to cycle: for families of two and more parameters.
bool is_reachable(const ShootingMap& map, double p, const CyclePoints& a, const CyclePoints& b);

}  // namespace swirl::analysis
