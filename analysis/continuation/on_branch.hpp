// Where a branch passes a value of its parameter, and whether a cycle is on it.
#pragma once

#include "analysis/continuation/branch.hpp"

#include <optional>

namespace swirl::analysis {

/// The branch's cycles at one value of the parameter, each corrected to rounding.
/// Cost: one root of the parameter along each step that passes the value.
std::vector<BranchPoint> cycles_at(const ShootingMap& map, const Branch& branch, double p);

/// The branch's cycle at p that is `points`, cyclic shifts included, to 10⁻⁶.
std::optional<BranchPoint> find_on_branch(const ShootingMap& map, const Branch& branch, double p,
                                          const CyclePoints& points);

}  // namespace swirl::analysis
