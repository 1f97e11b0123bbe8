#include "apps/studies/grids/run_cells.hpp"

#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace swirl::studies::grids {

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
    return {runs, static_cast<std::size_t>(study.runs), study.risk, study.seed, early_look(study.settings)};
}

SeenRun seen_of(const RunResult& run) {
    return studies::seen_of(kind_of(run), static_cast<Outcome>(static_cast<int>(run.outcome)), run.largest_exponent);
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
