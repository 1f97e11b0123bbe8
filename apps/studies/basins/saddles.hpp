// Boundaries of basins, and the saddles whose stable sets they are.
#pragma once

#include "analysis/classification/basin_boundary.hpp"
#include "analysis/classification/mode.hpp"
#include "apps/studies/grids/run_results.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace swirl::studies::grids {

inline constexpr std::int64_t no_saddle = -1;

/// The name of the end of a way along a boundary: found is "saddle", an unstable cycle or torus whose stable
/// set it is; not_found neither a cycle of up to 32 impacts nor a torus along 40,000, as on a chaotic saddle. The
/// others: analysis/classification/basin_boundary.hpp.
std::string_view name_of(analysis::StraddleEnd end);

/// A place between two neighbouring starts that came to different attractors.
struct BoundaryPlace {
    std::vector<double> point;  ///< by the grid's axes: on the boundary to 10⁻¹² of a step; undecided: that start
    std::int64_t from = 0, to = 0;    ///< the basins of the two
    std::int64_t saddle = no_saddle;  ///< its place in the list, where one was found
    analysis::StraddleEnd leads_to = analysis::StraddleEnd::not_found;
};

/// An unstable cycle or torus to which the boundary leads. NaN and 0: what the other alone has.
struct Saddle {
    analysis::Kind kind = analysis::Kind::cycle;  ///< fixed_point, cycle or quasi_periodic
    std::vector<Eigen::VectorXd> points;          ///< of a cycle all, of a torus one
    std::int64_t period = 0;
    double mean_spin = 0;             ///< over time; of a torus a weighted average over 1,000 impacts or more
    double mean_spin_per_impact = 0;  ///< likewise
    double multiplier = std::numeric_limits<double>::quiet_NaN();  ///< the largest |multiplier| of a cycle
    std::int64_t index = 0;  ///< how many of a cycle's multipliers lie outside the unit circle
    double rotation =
        std::numeric_limits<double>::quiet_NaN();  ///< of a torus: the strongest line of S, in turns per impact
    std::int64_t places = 0;                       ///< that lead to it
    double share = 0;                              ///< of all places
    Interval interval = {};                        ///< Wilson's
};

struct Boundaries {
    std::vector<BoundaryPlace> places;
    std::vector<Saddle> saddles;  ///< the one of most places first; of equally many that of the earlier place
};

}  // namespace swirl::studies::grids
