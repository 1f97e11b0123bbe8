// What a grid comes to: one result per run, and what a cell says of its runs.
#pragma once

#include "apps/studies/grids/starts.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/modes/name_mode.hpp"
#include "apps/studies/parallel/run_control.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <span>
#include <vector>

namespace swirl::studies::grids {

/// One start of one cell. All numbers, so that it is its own entry of the journal.
struct RunResult {
    double mode = 0, kind = 0, outcome = 0;  ///< the enumerators' numbers
    double period = 0;                       ///< 0: none
    double mean_spin = 0, mean_spin_per_impact = 0, recurrence_rate = 0, largest_exponent = 0;  ///< NaN: not measured
    double impacts = 0;
    double mean_spin_error = 0, mean_spin_per_impact_error = 0;  ///< along the run; NaN: none
    double mean_kind = 0;                                        ///< MeanKind's number
    double growth = analysis::nan, growth_low = analysis::nan,
           growth_high = analysis::nan;  ///< of one that is accelerated
    double limit_spin = analysis::nan;   ///< S* of one on a chord
};

inline analysis::Mode mode_of(const RunResult& run) {
    return static_cast<analysis::Mode>(static_cast<int>(run.mode));
}
inline analysis::GrowthExponent growth_of(const RunResult& run) {
    return {run.growth, run.growth_low, run.growth_high};
}
inline MeanErrors mean_errors_of(const RunResult& run) {
    return {static_cast<MeanKind>(static_cast<int>(run.mean_kind)), run.mean_spin_error,
            run.mean_spin_per_impact_error};
}
inline analysis::Kind kind_of(const RunResult& run) {
    return static_cast<analysis::Kind>(static_cast<int>(run.kind));
}
/// Off the wall for ever, on a floor that drags?
inline bool is_riding(const RunResult& run) {
    return kind_of(run) == analysis::Kind::riding;
}

/// What is kept of a run.
RunResult result_of(const NamedMode& named);

inline constexpr int mode_count = 4;
inline constexpr std::array<analysis::Mode, mode_count> all_modes = {
    analysis::Mode::steady, analysis::Mode::quasi_steady, analysis::Mode::chaotic, analysis::Mode::undecided};

/// What the runs of a cell have in common.
struct CellSummary {
    std::array<double, mode_count> shares{};  ///< by all_modes
    double mean_spin = 0;                     ///< mean of the runs' mean_S
    double mean_spin_error = 0;               ///< its standard error over the runs; of one run its own, if sampled
    double mean_spin_per_impact = 0;          ///< mean over the runs
    double mean_spin_per_impact_error = 0;    ///< as mean_spin_error
    double recurrence_rate = 0;               ///< mean over the runs, and the next
    double largest_exponent = 0;
    double impacts_spent = 0;  ///< by all runs
};

/// Wilson's interval of a share that was found in n of independent runs: of the probabilities p those from which it is
/// less than 1.96 of their standard deviations √(p(1 − p)/n) away (95 %). E. B. Wilson, J. Amer. Statist. Assoc. 22
/// (1927) 209.
struct Interval {
    double low = 0, high = 1;
};
Interval wilson_interval(double share, double n);

CellSummary summary_of(std::span<const RunResult> runs);

// The modes over a grid of scenes or of starts.
//
// In every cell R orbits are followed from starts of their own, and each has the verdict of `name_mode`. What a cell
// says of its runs: shares by mode with Wilson's intervals, means of S with their errors. Results
// depend neither on the number of threads nor on which runs are followed together.
// Cost: of an orbit in double some 0.3 µs an impact, on each thread.

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
