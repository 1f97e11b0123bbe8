// The time that the command may take, and how much of it is gone.
#pragma once

#include <chrono>

namespace swirl::studies::tradeoff {

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
/// depend on its speed. What is not done after these shares (verdicts, arithmetics' orbits, flights) is left out, and
/// the document says so. Times are measured in the rest. Further starts are judged only where they are expected to
/// leave time for the other shares.
inline constexpr double more_starts_share = 0.25;
inline constexpr double evidence_share = 0.45;
inline constexpr double orbits_share = 0.7;
inline constexpr double counted_share = 0.9;

}  // namespace swirl::studies::tradeoff
