// The modes over a grid of scenes or of starts.
//
// In every cell R orbits are followed from starts of their own, and each has the verdict of `name_mode`. What a cell
// says of its runs: shares by mode with Wilson's intervals, means of S with their errors (run_results.hpp). Results
// depend neither on the number of threads nor on which runs are followed together.
// Cost: of an orbit in double some 0.3 µs an impact, on each thread.
#pragma once

#include "apps/studies/grids/run_results.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies::grids {

/// Takes the result of run `index`.
using TakeRun = std::function<void(std::size_t index, const RunResult& result)>;

/// Runs by their indices, run r of cell c at c · runs + r, each given to `take` as soon as it is known; nothing of
/// those that are stopped. Well named together are `most_named_together()`.
/// @throws std::invalid_argument for a scene or start out of range
void name_runs(const GridStudy& study, std::span<const std::size_t> indices, const analysis::Stop& stop,
               const TakeRun& take);

/// All runs of all cells: run r of cell c is at c · runs + r. Nothing if it was stopped.
/// @throws std::invalid_argument for a scene or start out of range
std::optional<std::vector<RunResult>> sweep_grid(const GridStudy& study, const RunControl& control = {});

}  // namespace swirl::studies::grids
