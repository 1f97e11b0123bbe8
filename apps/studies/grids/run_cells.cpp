#include "apps/studies/grids/run_cells.hpp"

#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <memory>
#include <numeric>
#include <utility>

namespace swirl::studies::grids {

void name_runs(const GridStudy& study, std::span<const std::size_t> indices, const analysis::Stop& stop,
               const TakeRun& take) {
    const auto runs = static_cast<std::size_t>(study.runs);
    std::vector<SceneStart> starts;
    for (const std::size_t index : indices) {
        const Scene<double> scene = cell_scene(study, index / runs);
        starts.push_back({scene, cell_start(study, scene, index / runs, index % runs)});
    }
    name_modes(starts, {study.settings, study.accuracy, stop},
               [&](std::size_t place, const NamedMode& named, const OrbitSamples&) {
                   take(indices[place], result_of(named));
               });
}

std::optional<std::vector<RunResult>> sweep_grid(const GridStudy& study, const RunControl& control) {
    const std::size_t count = cell_count(study.grid) * static_cast<std::size_t>(study.runs);
    const std::size_t together = most_named_together(), pieces = (count + together - 1) / together;
    std::vector<RunResult> results(count);
    const auto name_piece = [study, control, together, count, &results](std::size_t piece) -> KeepResult {
        std::vector<std::size_t> indices(std::min(together, count - piece * together));
        std::iota(indices.begin(), indices.end(), piece * together);
        using Found = std::vector<std::pair<std::size_t, RunResult>>;
        const auto found = std::make_shared<Found>();
        name_runs(study, indices, control.stop,
                  [&found](std::size_t index, const RunResult& result) { found->emplace_back(index, result); });
        if (found->size() < indices.size()) return {};  // stopped
        return [found, &results] {
            for (const auto& [index, result] : *found) results[index] = result;
        };
    };
    if (!run_pieces(pieces, "sweep", control, name_piece)) return std::nullopt;
    return results;
}

}  // namespace swirl::studies::grids
