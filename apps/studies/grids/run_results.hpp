// What a grid comes to: one result per run, and what a cell says of its runs.
#pragma once

#include "apps/studies/modes/name_mode.hpp"

#include <array>
#include <map>
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

}  // namespace swirl::studies::grids
