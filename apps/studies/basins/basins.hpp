// The attractors of a plane of starts, and which of them each start came to.
#pragma once

#include "apps/studies/grids/run_cells.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies::grids {

/// Whether a verdict names what the orbit came to: not one without a kind, nor a transient.
bool has_attractor(const RunResult& run);

/// Two runs of one scene came to the same attractor: equal mode, kind and period, and of a polished cycle (fixed-point,
/// cycle, landing) equal mean S (`means_agree`). All chaotic runs are one, and all tori: their means
/// have errors of their own; so are all members of a family and all motions on the wall of one kind, whose S may be the
/// start's; and two cycles of equal period and mean S.
bool is_same_attractor(const RunResult& a, const RunResult& b);

struct Basin {
    RunResult attractor;      ///< mean_spin NaN where that is no number of the attractor's alone
    std::int64_t starts = 0;  ///< that were run and came to it
    double share = 0;         ///< of all cells, also those that have their neighbour's result
    Interval interval = {};   ///< Wilson's, as of independent starts; NaN where not all cells were run
};

struct Basins {
    std::vector<Basin> basins;          ///< the largest share first; of equal ones that of the earlier start
    std::vector<std::int64_t> of_cell;  ///< which of them a cell's start is in; no_basin: its verdict names none
};
inline constexpr std::int64_t no_basin = -1;

/// Of results with one run a cell, of which those with `visited` 0 are copies (empty: none is). Cost: cells ×
/// attractors.
Basins basins_of(std::span<const RunResult> results, std::span<const char> visited);

}  // namespace swirl::studies::grids
