// The attracting steady modes of every cell of a grid, and which share of its runs came to each.
#pragma once

#include "apps/studies/grids/run_results.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/steady_shares.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <optional>
#include <span>
#include <vector>

namespace swirl::studies::grids {

/// steady_shares() of each cell; empty of those that were not run themselves. Nothing if it was stopped.
///   results  of all runs (run_cells.hpp)
///   visited  1 of the cells that were run themselves; empty: all
std::optional<std::vector<std::vector<SteadyShare>>> steady_modes_of_cells(const GridStudy& study,
                                                                           std::span<const RunResult> results,
                                                                           std::span<const char> visited,
                                                                           const RunControl& control);

}  // namespace swirl::studies::grids
