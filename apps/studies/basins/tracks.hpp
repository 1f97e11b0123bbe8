// The attractors that the runs of a grid's cells came to, and which attractor of a cell is the continuation of which
// of its neighbours'.
#pragma once

#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace swirl::studies::grids {

// The attractors that the runs of one cell came to.

/// Of an attractor that is followed over no cells.
inline constexpr std::int64_t no_track = -1;

struct CellAttractor {
    RunResult first;        ///< the earliest of its runs: mode, kind and period are theirs
    double share = 0;       ///< of the cell's runs
    Interval interval;      ///< Wilson's, 95 %
    double mean_spin = 0;   ///< mean over its runs of their mean S
    double spin_error = 0;  ///< its standard error over these runs alone, s/√n; of one run its own
    std::size_t run = 0;    ///< the number of `first` in its cell
    std::size_t cell = 0;
    std::int64_t track = no_track;  ///< see tracks.hpp
    std::vector<double> point;      ///< of a tracked cycle, its first state's section coordinates; else empty
};

/// How often cycles were carried to a neighbouring cell, and what they came to there.
struct Tracking {
    std::int64_t carried = 0;
    std::int64_t arrived = 0;         ///< at an attractor of the cell
    std::int64_t unseen = 0;          ///< attracts there, and no start came to it
    std::int64_t not_attracting = 0;  ///< is there, and does not attract
    /// No cycle there, or Newton's method failed, there or on the way back.
    std::int64_t not_found() const { return carried - arrived - unseen - not_attracting; }
};

/// By attractors_of (../modes/attractors.hpp), the most shared first. An error within one attractor is that of its
/// mean; across attractors there is none, for another sample would have other shares. Cost: runs × attractors.
std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs, std::size_t cell = 0);

/// Do the mean S of a cell's attractors differ by more than twice their errors, or has one of several none? Then the
/// mean over the cell's runs is no attractor's.
bool spins_differ(std::span<const CellAttractor> attractors);

// Attractors followed over the cells of a grid: which attractor of a cell is the continuation of which of its
// neighbour's. A share over a parameter then belongs to an attractor, not to a place in a list.
//
// A cycle is carried to the neighbouring cells by Newton's method (saddles.hpp). It is the attractor there that
// has its period and mean S (`same_mean`). If none has, and the cycle attracts there, it is an attractor of that cell
// that no start came to, with share 0, and is followed on. Chaos, tori, members of families and motions on the wall
// have no points to be carried: they are one where each of the two cells has exactly one attractor of that mode, kind,
// period and outcome (so chaos before and after an interior crisis is); so are landing cycles that could not be
// carried, for those that leave at u_n = 0 lie on the edge of the map.

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
