// What tells the cells of a grid apart, as one number a cell: where it changes a refined grid is halved.
#pragma once

#include "apps/studies/grids/grid.hpp"
#include "apps/studies/grids/run_results.hpp"

#include <cstdint>
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

}  // namespace swirl::studies::grids
