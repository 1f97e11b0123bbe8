// Pseudo-arclength continuation of a cycle, both ways, with its special points located and named.
#pragma once

#include "analysis/continuation/branch.hpp"

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace swirl::analysis {

struct ContinuationOptions {
    double low = 0, high = 1;  ///< the parameter's range
    double first_step = 1e-3;  ///< in arclength, s² = |δZ|²/k + δp²
    double longest_step = 0.02;
    double shortest_step = 1e-12;  ///< a step that fails at this length has met a border
    int most_points = 20'000;      ///< in each direction
    /// For a map without a parameter: the coordinate, or the return time, that distinguishes the family's members.
    std::function<double(const CurvePoint&)> label;
    /// Higher derivatives of Fᵏ at a cycle; without it special points have no normal forms.
    std::function<HigherForms(const CyclePoints& points, double p)> forms;
    /// Names a border from its last cycle, the itinerary behind it (empty: the map ends) and whether a cycle continues
    /// there.
    std::function<std::string(const CurvePoint& last, const std::vector<std::int64_t>& itinerary_after, bool goes_on)>
        name_border;
    std::function<void(double p)> progress;
    std::function<bool()> stop;
};

/// The name of a border where none was given or found.
inline constexpr const char* nameless_border = "border";

/// The value that distinguishes the cycles of the branch: the parameter, or the label of a family.
double parameter_of(const ContinuationOptions& options, const CurvePoint& point);

/// Follows the branch through a cycle to both ends of the range. Steps adapt to the corrector and the turn of the
/// tangent; where the itinerary of the cycle changes or no cycle follows, steps are halved down to the border itself.
/// Special points are zeros of test functions along the arclength, bracketed by two steps and found by TOMS 748 to
/// rounding. Cost: about 4 × k steps of the map and two QRs of kD + 1 unknowns a point. False if the cycle can't be
/// continued: the solutions there are no curve (a family), or p is outside the range.
bool continue_branch(const ShootingMap& map, const CyclePoints& cycle, double p, const ContinuationOptions& options,
                     Branch& branch);

/// Follows one way only, from `start` in the direction of its tangent.
Branch follow_one_way(const ShootingMap& map, const CurvePoint& start, const ContinuationOptions& options);

}  // namespace swirl::analysis
