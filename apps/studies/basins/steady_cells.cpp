#include "apps/studies/basins/steady_cells.hpp"

#include "apps/studies/parallel/pieces.hpp"

#include <cstddef>
#include <memory>
#include <utility>

namespace swirl::studies::grids {

std::optional<std::vector<std::vector<SteadyShare>>> steady_modes_of_cells(const GridStudy& study,
                                                                           std::span<const RunResult> results,
                                                                           std::span<const char> visited,
                                                                           const RunControl& control) {
    std::vector<std::vector<SteadyShare>> of_cells(cell_count(study.grid));
    // A piece that a stop leaves alone may outlive the call: it has what it reads.
    std::vector<SettledRun> settled;
    settled.reserve(results.size());
    for (const RunResult& run : results) settled.push_back({kind_of(run), run.mean_spin});
    const auto look = [study, settled = std::make_shared<const std::vector<SettledRun>>(std::move(settled)),
                       visited = std::vector<char>(visited.begin(), visited.end()),
                       &of_cells](std::size_t c) -> KeepResult {
        if (!visited.empty() && visited[c] == 0) return [] {};
        const auto runs = static_cast<std::size_t>(study.runs);
        const auto modes = std::make_shared<std::vector<SteadyShare>>(
            steady_shares(cell_scene(study, c), std::span(*settled).subspan(c * runs, runs)));
        return [&of_cells, c, modes] { of_cells[c] = std::move(*modes); };
    };
    if (!run_pieces(of_cells.size(), "sweep: steady modes", control, look)) return std::nullopt;
    return of_cells;
}

}  // namespace swirl::studies::grids
