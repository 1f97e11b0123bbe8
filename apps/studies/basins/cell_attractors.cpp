#include "apps/studies/basins/cell_attractors.hpp"

#include "apps/studies/modes/attractors.hpp"

#include <cmath>

namespace swirl::studies::grids {

namespace {

RunVerdict verdict_of(const RunResult& run) {
    RunVerdict verdict;
    verdict.mode = mode_of(run);
    verdict.kind = kind_of(run);
    verdict.outcome = static_cast<Outcome>(static_cast<int>(run.outcome));
    verdict.period = static_cast<std::int64_t>(run.period);
    verdict.mean_spin = run.mean_spin;
    verdict.mean_spin_per_impact = run.mean_spin_per_impact;
    verdict.mean_errors.per_time = run.mean_spin_error;
    verdict.growth = growth_of(run);
    verdict.limit_spin = run.limit_spin;
    return verdict;
}

}  // namespace

std::vector<CellAttractor> cell_attractors(std::span<const RunResult> runs, std::size_t cell) {
    std::vector<RunVerdict> verdicts;
    verdicts.reserve(runs.size());
    for (const RunResult& run : runs) verdicts.push_back(verdict_of(run));
    std::vector<CellAttractor> found;
    const auto all = static_cast<double>(runs.size());
    for (const SharedAttractor& shared : attractors_of(verdicts)) {
        const double share = static_cast<double>(shared.runs.size()) / all;
        const std::size_t first = shared.runs.front();
        found.push_back({runs[first],
                         share,
                         wilson_interval(share, all),
                         shared.mean_spin,
                         shared.mean_spin_error,
                         first,
                         cell,
                         no_track,
                         {}});
    }
    return found;
}

bool spins_differ(std::span<const CellAttractor> attractors) {
    const auto error_of = [](const CellAttractor& a) { return std::isnan(a.spin_error) ? 0 : a.spin_error; };
    const auto differ = [&](const CellAttractor& a, const CellAttractor& b) {
        if (std::isnan(a.mean_spin) != std::isnan(b.mean_spin)) return true;
        const double errors = 2 * std::hypot(error_of(a), error_of(b));
        return !means_agree(a.mean_spin, b.mean_spin) && std::abs(a.mean_spin - b.mean_spin) > errors;
    };
    for (std::size_t i = 0; i < attractors.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (differ(attractors[i], attractors[j])) return true;
    return false;
}

}  // namespace swirl::studies::grids
