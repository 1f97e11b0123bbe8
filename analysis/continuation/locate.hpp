// Where on a step of the curve a function has its zero.
#pragma once

#include "analysis/continuation/continue_branch.hpp"

namespace swirl::analysis {

/// The special points between a base and the point that a step of length h led to, in order, their normal forms
/// included. One that the corrector can't be led to is given as not `located`, at the step's end.
std::vector<SpecialPoint> special_points_between(const ShootingMap& map, const BranchPoint& base, double h,
                                                 const BranchPoint& next, const ContinuationOptions& options);

/// The curve's point at which `value` is zero, between base (value f0) and the step h (value f1), found to rounding.
/// False if the corrector failed on the way.
bool locate(const ShootingMap& map, const CurvePoint& base, double h, double f0, double f1,
            const std::function<double(const CurvePoint&)>& value, CurvePoint& found);

}  // namespace swirl::analysis
