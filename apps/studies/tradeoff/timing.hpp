// Times per collision, of several ways to do the same, measured side by side.
#pragma once

#include "apps/studies/parallel/run_control.hpp"
#include "apps/studies/tradeoff/budget.hpp"

#include <cmath>
#include <cstdint>
#include <functional>
#include <vector>

namespace swirl::studies::tradeoff {

/// Work to be timed: about so many units of it, and the collisions that they were.
using TimedWork = std::function<std::int64_t(std::size_t units)>;

/// Seconds per collision, of batches.
struct Timing {
    double median = std::nan("");
    double lower = std::nan(""), upper = std::nan("");  ///< quartiles
    std::int64_t batches = 0;
    std::int64_t collisions = 0;  ///< in all batches
};

/// Runs a batch (about half a millisecond) of each in turn, round by round until the budget is spent, so that what
/// disturbs the machine disturbs all of them. At least 12 rounds. Without batches of work that makes no collision.
std::vector<Timing> time_in_turn(const std::vector<TimedWork>& works, const Budget& budget, const ReportDone& report);

}  // namespace swirl::studies::tradeoff
