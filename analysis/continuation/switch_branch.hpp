// The other branch at a special point.
#pragma once

#include "analysis/continuation/continue_branch.hpp"

#include <functional>

namespace swirl::analysis {

/// The doubled cycle at a flip, or the crossing branch at a branch point, followed within the range.
///   is_known  asked of the first cycle on either side of the point: true leaves that side out. (At a flip both are
///   one.)
/// False if no branch was found there that is not known.
bool switch_branch(const ShootingMap& map, const SpecialPoint& special, const ContinuationOptions& options,
                   Branch& branch, const std::function<bool(const CurvePoint&)>& is_known = {});

}  // namespace swirl::analysis
