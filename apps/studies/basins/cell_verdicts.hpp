// What tells the cells of a grid apart, and the attracting steady modes of every cell.
#pragma once

#include "apps/studies/grids/grid.hpp"
#include "apps/studies/grids/run_cells.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies::grids {

class CellVerdicts {
public:
    explicit CellVerdicts(const std::vector<GridAxis>& grid);

    /// Of a cell what most of its runs say: mode, kind and period; of equally many that of the earlier run. Of a plane
    /// of starts, whose cells have one scene, which of the attractors asked for so far its run came to.
    std::int64_t of(std::span<const RunResult> runs);

private:
    bool basins_;
    std::vector<RunResult> attractors_;  ///< of one scene: told apart by their mean S, too
};

// The attracting steady modes of every cell of a grid, and which share of its runs came to each.

/// steady_shares() of each cell; empty of those that were not run themselves. Nothing if it was stopped.
///   results  of all runs (run_cells.hpp)
///   visited  1 of the cells that were run themselves; empty: all
std::optional<std::vector<std::vector<SteadyShare>>> steady_modes_of_cells(const GridStudy& study,
                                                                           std::span<const RunResult> results,
                                                                           std::span<const char> visited,
                                                                           const RunControl& control);

}  // namespace swirl::studies::grids
