#include "apps/studies/basins/cell_verdicts.hpp"

#include "apps/studies/basins/basins.hpp"
#include "apps/studies/grids/starts.hpp"

#include <algorithm>
#include <cstddef>

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

}  // namespace swirl::studies::grids
