// Boundaries of basins over a plane of starts, and the saddles whose stable sets they are.
#pragma once

#include "analysis/classification/basin_boundary.hpp"
#include "analysis/classification/mode.hpp"
#include "analysis/section_map.hpp"
#include "apps/studies/basins/basins.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/scene_map/scene_map.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace swirl::studies::grids {

// A cycle carried from one scene to another by Newton's method (natural continuation).

/// A cycle in the scene to which it was carried.
struct CarriedCycle {
    analysis::CyclePoints points;  ///< none: it was not carried, or not back to where it came from
    double mean_spin = 0;          ///< time mean of S
    double mean_spin_per_impact = 0;
    bool stable = false;  ///< all multipliers inside the unit circle
};

/// Carries the k points of a cycle to another scene with the same N and law, its minimal period kept, in 2ⁿ equal steps
/// of α, β, μ, e and κ: the smallest n of 1 … 4 with which Newton's method converges at each and leads back, in the
/// same steps, to the points themselves (10⁻⁶): one that has jumped to another cycle on the way seldom does.
/// None once stopped.
/// Cost: 2ⁿ⁺¹ solutions of k points.
CarriedCycle carried(const Scene<double>& from, const Scene<double>& to, Accuracy accuracy,
                     const analysis::CyclePoints& points, const analysis::Stop& stop = {});

// Boundaries of basins, and the saddles whose stable sets they are.

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

// The edge of an attractor's basin in one scene: which starts are inside, and where it leads.

template <int D>
class BasinEdge {
public:
    /// Of what `attractor` came to, by verdicts with these settings.
    ///   stop  true: starts are reported no more
    BasinEdge(const Scene<double>& scene, const analysis::ClassifyOptions& settings, Accuracy accuracy,
              const RunResult& attractor, const analysis::Stop& stop);

    /// Does a start come to the attractor? Nothing: its verdict names none. Cost: a run.
    std::optional<bool> is_inside(const Start<double>& start) const;

    /// Where the edge leads from between two starts of which the first alone is inside: an unstable cycle of up to 32
    /// impacts, polished, or an unstable torus fills `saddle`. Cost: about a run for each impact until it is there.
    analysis::StraddleEnd follow(const LabStart<double>& in, const LabStart<double>& out, Saddle& saddle) const;

private:
    using Points = std::vector<analysis::Vector<D>>;
    bool is_at_cycle(const Points& orbit, Saddle& saddle) const;
    bool take_cycle(const analysis::CyclePoints& cycle, Saddle& saddle) const;
    bool is_torus(const Points& orbit, Saddle& saddle) const;

    Scene<double> scene_;
    analysis::ClassifyOptions settings_;
    Accuracy accuracy_;
    RunResult attractor_;
    analysis::Stop stop_;
    SceneMap<D> map_;
    analysis::ShootingMap shooting_;
};

extern template class BasinEdge<disk_dimension>;
extern template class BasinEdge<polygon_dimension>;

/// Cycles by their points, tori by their means of S: a rotation number is one up to m ρ + k.
bool is_same_saddle(const analysis::ShootingMap& map, const Saddle& a, const Saddle& b);

// The boundaries of the basins over a plane of starts, and the saddles that they lead to.
//
// Between two neighbouring starts that came to different attractors the boundary is bisected to 10⁻¹² of a step; the
// orbit between two starts on its two sides, drawn together again and again (straddling), stays on the boundary and
// leads to the unstable cycle or torus whose stable set it is. Source: H. E. Nusse and J. A. Yorke, Physica D 36 (1989)
// 137 (analysis/classification/basin_boundary.hpp).

/// Follows so many places on the boundaries, evenly spread. Nothing if it was stopped.
///   study    over numbers of the start alone
///   results  of its runs, one a cell
///   visited  1 of the cells that were run themselves; empty: all
/// Cost: of a place some 50 runs, and about one for each impact until its orbit is at the saddle.
std::optional<Boundaries> find_saddles(const GridStudy& study, std::span<const RunResult> results,
                                       std::span<const char> visited, const Basins& basins, std::size_t places,
                                       const RunControl& control = {});

}  // namespace swirl::studies::grids
