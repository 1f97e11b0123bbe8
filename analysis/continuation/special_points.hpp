// The special points on a step of a branch.
#pragma once

#include "analysis/continuation/continue_branch.hpp"

#include <vector>

namespace swirl::analysis {

/// The special points between a base and the point that a step of length h led to, in order, their normal forms
/// included. One that the corrector can't be led to is given as not `located`, at the step's end.
std::vector<SpecialPoint> special_points_between(const CurveProblem& problem, const BranchPoint& base, double h,
                                                 const BranchPoint& next, const ContinuationOptions& options);

}  // namespace swirl::analysis
