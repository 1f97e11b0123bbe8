#include "apps/studies/tradeoff/timing.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>

namespace swirl::studies::tradeoff {

namespace {

constexpr double batch_seconds = 5e-4;  // ten thousand times what the clock resolves, a fifth of a scheduler's slice
constexpr int fewest_rounds = 12;       // a quartile of fewer is one of three batches
constexpr double overdrawn = 1.2;       // of the budget: up to there for the fewest rounds
constexpr double long_batch = 0.01;     // of the budget: the warming up of one that takes longer counts as a batch

/// One work with its batches.
struct Series {
    const TimedWork* work;
    std::size_t units = 1;
    std::vector<double> seconds{};  ///< per collision, a batch each
    std::int64_t collisions = 0;
    double took = 0;  ///< the last batch, in seconds

    /// The time that a batch took. One that is short by far only tells how long the next should be.
    void run() {
        using Clock = std::chrono::steady_clock;
        const auto begin = Clock::now();
        const std::int64_t made = (*work)(units);
        took = std::chrono::duration<double>(Clock::now() - begin).count();
        if (took < batch_seconds / 2) {
            units *= 2;
            if (made > 0 && seconds.empty() && units < (std::size_t{1} << 24)) return run();
        }
        if (made == 0) return;
        seconds.push_back(took / static_cast<double>(made));
        collisions += made;
    }

    /// After warming up caches and finding the length of a batch.
    void begin(const Budget& budget) {
        if (took > long_batch * budget.seconds()) return;
        seconds.clear();
        collisions = 0;
    }

    /// One batch, unless there is one already and another would go beyond this share of the budget: one flight past all
    /// of 10⁶ vertices may take seconds. @return there was one
    bool run_within(const Budget& budget, double share) {
        if (!seconds.empty() && budget.spent() + took > share * budget.seconds()) return false;
        run();
        return true;
    }

    Timing timing() {
        Timing found;
        found.batches = static_cast<std::int64_t>(seconds.size());
        found.collisions = collisions;
        if (seconds.empty()) return found;
        std::sort(seconds.begin(), seconds.end());
        const auto quantile = [this](double share) {
            return seconds[static_cast<std::size_t>(std::lround(share * static_cast<double>(seconds.size() - 1)))];
        };
        found.lower = quantile(0.25);
        found.median = quantile(0.5);
        found.upper = quantile(0.75);
        return found;
    }
};

}  // namespace

std::vector<Timing> time_in_turn(const std::vector<TimedWork>& works, const Budget& budget, const ReportDone& report) {
    std::vector<Series> all;
    all.reserve(works.size());
    for (const TimedWork& work : works) all.push_back({&work});
    for (auto& series : all) {
        series.run();
        series.begin(budget);
    }
    const auto share = [](int round) { return round < fewest_rounds ? overdrawn : 1; };
    for (int round = 0; round == 0 || !budget.is_spent(share(round)); ++round) {
        bool any = false;
        for (auto& series : all) any |= series.run_within(budget, share(round));
        if (!any) break;
        report(std::min(budget.spent(), budget.seconds()));
    }
    std::vector<Timing> timings;
    timings.reserve(all.size());
    for (auto& series : all) timings.push_back(series.timing());
    return timings;
}

}  // namespace swirl::studies::tradeoff
