#include "apps/studies/grids/run_cells.hpp"

#include "apps/studies/modes/means.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>
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

void name_runs(const GridStudy& study, std::span<const std::size_t> indices, const analysis::Stop& stop,
               const TakeRun& take, std::int64_t look) {
    const auto runs = static_cast<std::size_t>(study.runs);
    std::vector<SceneStart> starts;
    std::vector<std::size_t> started;
    std::optional<std::pair<std::size_t, bool>> steady;  // has this cell's scene an attracting steady mode?
    for (const std::size_t index : indices) {
        const std::size_t cell = index / runs;
        const Scene<double> scene = cell_scene(study, cell);
        if (look > 0 && !(steady && steady->first == cell)) steady = {cell, has_attracting_steady_mode(scene)};
        if (steady && steady->second) {
            take(index, result_of({}));
            continue;
        }
        started.push_back(index);
        starts.push_back({scene, cell_start(study, scene, cell, index % runs)});
    }
    name_modes(starts, {study.settings, study.accuracy, stop, false, look},
               [&](std::size_t place, const NamedMode& named, const OrbitSamples&) {
                   take(started[place], result_of(named));
               });
}

RiskQuestion risk_question(const GridStudy& study, std::size_t runs) {
    return {runs,
            static_cast<std::size_t>(study.runs),
            study.risk,
            study.seed,
            early_look(study.settings),
            study.error,
            last_look(study.settings)};
}

SeenRun seen_of(const RunResult& run) {
    return studies::seen_of(kind_of(run), static_cast<Outcome>(static_cast<int>(run.outcome)), run.largest_exponent,
                            run.mean_spin_error);
}

namespace {

using Found = std::vector<std::pair<std::size_t, RunResult>>;

/// Follows runs. False if it was stopped.
bool follow_runs(const GridStudy& study, std::span<const std::size_t> wanted, std::int64_t look,
                 const RunControl& control, std::vector<RunResult>& results) {
    const std::vector<std::size_t> runs(wanted.begin(), wanted.end());
    const std::size_t together = most_named_together(), pieces = (runs.size() + together - 1) / together;
    const auto name_piece = [study, runs, look, control, together, &results](std::size_t piece) -> KeepResult {
        const std::size_t first = piece * together, count = std::min(together, runs.size() - first);
        const auto found = std::make_shared<Found>();
        name_runs(
            study, std::span(runs).subspan(first, count), control.stop,
            [&found](std::size_t run, const RunResult& result) { found->emplace_back(run, result); }, look);
        if (found->size() < count) return {};  // stopped
        return [found, &results] {
            for (const auto& [run, result] : *found) results[run] = result;
        };
    };
    return run_pieces(pieces, "sweep", control, name_piece);
}

}  // namespace

std::optional<std::vector<RunResult>> sweep_grid(const GridStudy& study, const RunControl& control) {
    const std::size_t count = cell_count(study.grid) * static_cast<std::size_t>(study.runs);
    std::vector<RunResult> results(count);
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    RunsAtRisk runs;
    runs.follow = [&](std::span<const std::size_t> some, std::int64_t look) -> std::optional<std::vector<SeenRun>> {
        if (!follow_runs(study, some, look, control, results)) return std::nullopt;
        std::vector<SeenRun> seen;
        for (const std::size_t run : some) seen.push_back(seen_of(results[run]));
        return seen;
    };
    runs.keep = [](std::size_t) {};  // it is in its place
    if (!follow_at_risk(risk_question(study, count), all, runs)) return std::nullopt;
    return results;
}

}  // namespace swirl::studies::grids
