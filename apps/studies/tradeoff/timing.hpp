// Times per collision, of several ways to do the same, measured side by side, and the time that all may take.
#pragma once

#include "apps/studies/parallel/run_control.hpp"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace swirl::studies::tradeoff {

// The time that the command may take, and how much of it is gone.

class Budget {
public:
    explicit Budget(double seconds) : seconds_(seconds) {}

    double seconds() const { return seconds_; }
    double spent() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    bool is_spent(double share = 1) const { return spent() > share * seconds_; }

private:
    using Clock = std::chrono::steady_clock;

    double seconds_;
    Clock::time_point begin_ = Clock::now();
};

/// All that is not measured in seconds takes about a third of the budget on a slow machine, in amounts that do not
/// depend on its speed. What is not done after these shares (verdicts, arithmetics' orbits, flights) is left
/// out, and the document says so. Times are measured in the rest. Further starts are judged only where they are
/// expected to leave time for the other shares.
inline constexpr double more_starts_share = 0.25;
inline constexpr double evidence_share = 0.45;
inline constexpr double orbits_share = 0.7;
inline constexpr double counted_share = 0.9;
inline constexpr double risk_share = 0.75;  // after all of these, and only if it is not gone

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
