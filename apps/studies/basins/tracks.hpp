// Attractors followed over the cells of a grid: which attractor of a cell is the continuation of which of its
// neighbour's. A share over a parameter then belongs to an attractor, not to a place in a list.
//
// A cycle is carried to the neighbouring cells by Newton's method (carried_cycle.hpp). It is the attractor there that
// has its period and mean S (`same_mean`). If none has, and the cycle attracts there, it is an attractor of that cell
// that no start came to, with share 0, and is followed on. Chaos, tori, members of families and motions on the wall
// have no points to be carried: they are one where each of the two cells has exactly one attractor of that mode, kind,
// period and outcome (so chaos before and after an interior crisis is); so are landing cycles that could not be
// carried, for those that leave at u_n = 0 lie on the edge of the map.
#pragma once

#include "apps/studies/basins/cell_attractors.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::studies::grids {

/// Longer cycles have a track of their own in each cell.
inline constexpr std::int64_t longest_tracked = 64;

/// Neighbours whose attractors may be one's continuation: cells one step apart along an axis of real numbers (not N,
/// not the law), the earlier cell first.
std::vector<std::pair<std::size_t, std::size_t>> neighbours(const std::vector<GridAxis>& grid);

struct TrackedAttractors {
    std::vector<std::vector<CellAttractor>> of_cells;
    Tracking tracking;
};

/// The attractors of every cell, each with the number of its track; tracks are counted by their earliest cell. A
/// verdict that names no attractor has none. Nothing if it was stopped.
///   results  of all runs (run_cells.hpp)
/// Cost: for each cycle of a cell one run more, and Newton's method to and from each neighbour.
std::optional<TrackedAttractors> track_attractors(const GridStudy& study, std::span<const RunResult> results,
                                                  const RunControl& control);

/// A track, over its cells.
struct Track {
    CellAttractor first;     ///< in its earliest cell
    std::int64_t cells = 0;  ///< that have it
    double least_share = 1, largest_share = 0;
    double least_spin = 0, largest_spin = 0;  ///< of the mean S
};

/// The one that most cells have first; of equally many that of the earlier cell.
std::vector<Track> tracks_of(const std::vector<std::vector<CellAttractor>>& of_cells);

}  // namespace swirl::studies::grids
