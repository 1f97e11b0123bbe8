#include "apps/studies/grids/run_results.hpp"

#include "apps/studies/modes/means.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace swirl::studies::grids {

namespace {

std::vector<double> measured(std::span<const RunResult> runs, double RunResult::*member) {
    std::vector<double> values;
    for (const auto& run : runs)
        if (std::isfinite(run.*member)) values.push_back(run.*member);
    return values;
}

}  // namespace

RunResult result_of(const NamedMode& named) {
    const auto& v = named.verdict;
    return RunResult{static_cast<double>(v.mode),
                     static_cast<double>(v.kind),
                     static_cast<double>(named.outcome),
                     static_cast<double>(v.period),
                     v.mean,
                     v.mean_per_step,
                     v.recurrence_rate,
                     v.largest_exponent,
                     static_cast<double>(named.impacts),
                     named.mean_errors.per_time,
                     named.mean_errors.per_impact,
                     static_cast<double>(named.mean_errors.kind),
                     named.growth.value,
                     named.growth.low,
                     named.growth.high,
                     named.limit_spin};
}

Interval wilson_interval(double share, double n) {
    constexpr double z = 1.959963984540054;  // of the normal distribution: 2.5 % lie above
    const double narrowed = 1 + z * z / n, middle = share + z * z / (2 * n);
    const double half = z * std::sqrt(share * (1 - share) / n + z * z / (4 * n * n));
    // 0 and 1 are ends of their own intervals; rounding may miss them
    return {std::clamp((middle - half) / narrowed, 0.0, share), std::clamp((middle + half) / narrowed, share, 1.0)};
}

CellSummary summary_of(std::span<const RunResult> runs) {
    CellSummary cell;
    for (int m = 0; m < mode_count; ++m) {
        double count = 0;
        for (const auto& run : runs) count += run.mode == static_cast<double>(all_modes[static_cast<std::size_t>(m)]);
        cell.shares[static_cast<std::size_t>(m)] = count / static_cast<double>(runs.size());
    }
    const auto spins = measured(runs, &RunResult::mean_spin);
    cell.mean_spin = mean_of(spins);
    cell.mean_spin_error = error_of_mean(spins, measured(runs, &RunResult::mean_spin_error));
    const auto per_impact = measured(runs, &RunResult::mean_spin_per_impact);
    cell.mean_spin_per_impact = mean_of(per_impact);
    cell.mean_spin_per_impact_error = error_of_mean(per_impact, measured(runs, &RunResult::mean_spin_per_impact_error));
    cell.recurrence_rate = mean_of(measured(runs, &RunResult::recurrence_rate));
    cell.largest_exponent = mean_of(measured(runs, &RunResult::largest_exponent));
    for (const auto& run : runs) cell.impacts_spent += run.impacts;
    return cell;
}

}  // namespace swirl::studies::grids
