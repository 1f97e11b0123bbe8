// The modes over a grid of scenes or of starts.
//
// In every cell R orbits are followed from starts of their own, and each has the verdict of `name_mode`. What a cell
// says of its runs: shares by mode with Wilson's intervals, means of S with their errors (run_results.hpp). Results
// depend neither on the number of threads nor on which runs are followed together.
// Cost: of an orbit in double some 0.3 µs an impact, on each thread.
#pragma once

#include "apps/studies/grids/run_results.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/early_chaos.hpp"
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
///   look  to which they are followed, whatever the study's risk (NamingOptions); those of scenes with an attracting
///         steady mode are not, and have neither mode nor kind. 0: to the limits
/// @throws std::invalid_argument for a scene or start out of range
void name_runs(const GridStudy& study, std::span<const std::size_t> indices, const analysis::Stop& stop,
               const TakeRun& take, std::int64_t look = 0);

/// What is asked where chaos of so many runs, of whole cells, may be called before the limits.
RiskQuestion risk_question(const GridStudy& study, std::size_t runs);
SeenRun seen_of(const RunResult& run);

/// All runs of all cells: run r of cell c is at c · runs + r. Chaos is called at the study's risk. Nothing if it was
/// stopped.
/// @throws std::invalid_argument for a scene or start out of range, or a risk
std::optional<std::vector<RunResult>> sweep_grid(const GridStudy& study, const RunControl& control = {});

}  // namespace swirl::studies::grids
