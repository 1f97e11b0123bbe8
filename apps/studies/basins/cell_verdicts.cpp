#include "apps/studies/basins/cell_verdicts.hpp"

#include "apps/studies/basins/basins.hpp"
#include "apps/studies/grids/starts.hpp"
#include "apps/studies/parallel/pieces.hpp"

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>

namespace swirl::studies::grids {

namespace {

std::int64_t verdict_of(std::span<const RunResult> runs) {
    const auto number = [](const RunResult& run) {
        constexpr double kinds = 64, modes = 8;
        return static_cast<std::int64_t>((run.period * kinds + run.kind) * modes + run.mode);
    };
    std::int64_t usual = 0;
    std::ptrdiff_t most = 0;
    for (const auto& run : runs) {
        const auto same = [&](const RunResult& other) { return number(other) == number(run); };
        const auto count = std::count_if(runs.begin(), runs.end(), same);
        if (count > most) most = count, usual = number(run);
    }
    return usual;
}

}  // namespace

CellVerdicts::CellVerdicts(const std::vector<GridAxis>& grid) : basins_(are_all_of_the_start(grid)) {}

std::int64_t CellVerdicts::of(std::span<const RunResult> runs) {
    if (!basins_) return verdict_of(runs);
    const RunResult& run = runs.front();
    if (!has_attractor(run)) return no_basin;
    const auto known = std::find_if(attractors_.begin(), attractors_.end(),
                                    [&](const RunResult& other) { return is_same_attractor(other, run); });
    const std::int64_t place = known - attractors_.begin();
    if (known == attractors_.end()) attractors_.push_back(run);
    return place;
}

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
