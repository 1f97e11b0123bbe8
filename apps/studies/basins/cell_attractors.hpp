// The attractors that the runs of one cell came to.
#pragma once

#include "apps/studies/grids/run_results.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies::grids {

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

}  // namespace swirl::studies::grids
