// What a risk saves on a scene: chaos called before the limits (../modes/early_chaos.hpp), against time.
#pragma once

#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/tradeoff/drawn_flights.hpp"
#include "apps/studies/tradeoff/timing.hpp"

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

namespace swirl::studies::tradeoff {

/// So many runs at one risk; at 0 all of them to the limits.
struct RiskRow {
    double risk = 0;
    std::int64_t runs = 0;
    std::int64_t impacts = 0;       ///< of all runs together
    double seconds = std::nan("");  ///< of one core, that these take: all that were measured have one time per impact
    std::int64_t runs_called = 0;   ///< before the limits
    std::int64_t changed = 0;       ///< of these, with another verdict at the limits: all runs were followed there
    double share_that_differs = 0;  ///< of all runs
    double bound = analysis::nan;   ///< share of such runs among all that are called, at most (95 %)
};

/// One run, to the look and to the limits.
struct RunAtBoth {
    SeenRun at_look, at_limits;
    std::int64_t impacts_to_look = 0, impacts_to_limits = 0;
};

/// Rows for 0 and each of `risks`, as `classify --runs` would follow these runs.
///   seconds  per impact
std::vector<RiskRow> risk_rows(std::span<const RunAtBoth> runs, const std::vector<double>& risks, std::uint64_t seed,
                               std::int64_t look, double seconds);

/// The risks of the ladder.
std::vector<double> risk_ladder();

/// The same of random starts of a scene from starts.seed on, to the limits of a classification: `count` of them, or as
/// many as the budget allows; none where the start is given. Equal arguments give equal rows but for `seconds` and
/// `runs`.
std::vector<RiskRow> measure_risks(const Scene<double>& scene, const OrbitStarts& starts, std::int64_t count,
                                   const Budget& budget, const RunControl& control);

/// The smallest risk that saves half of the impacts that the largest of them saves, if that are a tenth of all; 0:
/// none.
double recommended_risk(const std::vector<RiskRow>& rows);

}  // namespace swirl::studies::tradeoff
