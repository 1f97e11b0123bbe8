// Every curve that lines through the plane meet, with lines added where they may have missed some.
#pragma once

#include "analysis/cycles/find_cycles.hpp"
#include "apps/studies/bifurcation_curves/curves.hpp"
#include "apps/studies/bifurcation_curves/starting_points.hpp"

#include <cstddef>
#include <vector>

namespace swirl::studies::bifurcation_curves {

/// What lines met, and what that says of the curves that none met. Curves that are not met by a line and to which
/// others lead are not counted.
struct LineSurvey {
    std::size_t even = 0, between = 0;  ///< lines: those evenly spaced, and those put in gaps
    std::size_t met = 0;                ///< curves that a line meets
    std::size_t met_by_even = 0;        ///< of them: by one of the evenly spaced
    std::size_t lone = 0;               ///< in the end met by one line alone
    /// Of the evenly spaced lines, by how many of them meet each curve: how many curves none of them meets. The lines
    /// between say how many of these there are at least.
    analysis::UnseenCycles by_even;
    std::vector<CycleSearches> searches;  ///< for longer cycles, by period
};

/// Follows the curves through the special points of evenly spaced lines (starting_points_of_lines), then of lines in
/// the gaps on both sides of each line that meets a curve which no other line meets: where curves are that short, or
/// closed curves that small, others lie between the lines. Gaps are halved so twice. A curve that is narrower than the
/// last gap in both directions may be missed: nothing is proven.
LineSurvey follow_all_curves(CurveSearch& search, const Scene<double>& scene, const Plane& plane,
                             const LineOptions& options);

}  // namespace swirl::studies::bifurcation_curves
