// The attractors of a plane of starts, and which of them each start came to.
#pragma once

#include "apps/output/table.hpp"
#include "apps/sweep/sweep_results.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace swirl::apps::sweep {

/// Two runs of one scene came to the same attractor: equal mode, kind and period, and, where the verdict has polished a
/// cycle (fixed-point, cycle, landing) or a motion on the wall that attracts (sliding, two-vertex), equal mean S to
/// within `same_spin` (1 + |S|). All chaotic runs are one attractor, and all tori: their means have errors of their
/// own. So are the members of a family, and two cycles of equal period and mean S.
bool is_same_attractor(const RunResult& a, const RunResult& b);

/// Polished cycles have their mean S to some 10⁻¹²; motions on the wall, whose mean is measured, to some 10⁻⁸.
inline constexpr double same_spin = 1e-6;

struct Basin {
    RunResult attractor;      ///< of the first start that came to it
    std::int64_t starts = 0;  ///< that came to it
    double share = 0;
    Interval interval = {};  ///< Wilson's, as of independent starts
};

struct Basins {
    std::vector<Basin> basins;          ///< the largest first; of equal ones that of the earlier start
    std::vector<std::int64_t> of_cell;  ///< which of them a cell's start is in
};

Table<Basin> basin_table();

/// Of results with one run a cell. Cost: cells × attractors.
Basins basins_of(std::span<const RunResult> results);

}  // namespace swirl::apps::sweep
