// The attractors that the runs of one cell came to, told as `classify --runs` tells them.
#pragma once

#include "apps/output/table.hpp"
#include "apps/sweep/sweep_results.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace swirl::apps::sweep {

struct CellAttractor {
    RunResult first;        ///< the earliest of its runs: mode, kind and period are theirs
    double share = 0;       ///< of the cell's runs
    Interval interval;      ///< Wilson's, 95 %
    double mean_spin = 0;   ///< mean over its runs of their mean S
    double spin_error = 0;  ///< its standard error over these runs alone, s/√n; NaN of one run
};

/// By attractors_of (apps/modes/attractors.hpp), the most shared first. An error within one attractor is that of its
/// mean; across attractors there is none, for another sample would have other shares. Cost: runs × attractors.
std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs);

Table<CellAttractor> cell_attractor_table();

}  // namespace swirl::apps::sweep
