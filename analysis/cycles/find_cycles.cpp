#include "analysis/cycles/find_cycles.hpp"

#include "analysis/threads.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <mutex>
#include <utility>

namespace swirl::analysis {

namespace {

struct Solved {
    CyclePoints points;  ///< empty: nothing converged
    double residual = 0;
};

std::vector<Solved> solve_all(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                              const SearchOptions& options, SearchCounts& counts) {
    std::vector<Solved> solved(candidates.size());
    std::mutex mutex;
    on_threads(options.threads, [&] {
        tbb::parallel_for(std::size_t{0}, candidates.size(), [&](std::size_t i) {
            if (options.stop && options.stop()) return;
            ShootingResult shot = solve_shooting(map, candidates[i], p, options.accept, options.shooting);
            if (!shot.converged && options.timed != nullptr)
                shot = solve_near_grazing(map, *options.timed, candidates[i], p, options.accept, options.shooting);
            if (shot.converged) solved[i] = {minimal_cycle(map, shot.points, options.same), shot.residual};
            const std::lock_guard lock(mutex);
            ++counts.tried;
            if (options.progress) options.progress(static_cast<double>(counts.tried));
        });
    });
    return solved;
}

}  // namespace

SearchCounts add_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                        const SearchOptions& options, KnownCycles& known) {
    SearchCounts counts;
    for (const Solved& found : solve_all(map, p, candidates, options, counts)) {
        if (found.points.empty()) continue;
        ++counts.converged;
        if (found.points.size() != static_cast<std::size_t>(options.period)) continue;
        if (!options.wanted || options.wanted(found.points)) known.add(found.points, found.residual);
    }
    return counts;
}

SearchResult find_cycles(const ShootingMap& map, double p, const std::vector<CyclePoints>& candidates,
                         const SearchOptions& options) {
    SearchResult result;
    KnownCycles known(map, p, options.same, options.one_per_family);
    result.counts = add_cycles(map, p, candidates, options, known);
    result.cycles = known.completed(options.threads);
    result.stopped = options.stop && options.stop();
    return result;
}

std::vector<CyclePoints> close_returns(const ShootingMap& map, const CyclePoints& trajectory, int k, int count,
                                       double vicinity) {
    const auto lag = static_cast<std::size_t>(k);
    if (trajectory.size() < lag + 3) return {};
    std::vector<double> returned;
    for (std::size_t i = 0; i + lag < trajectory.size(); ++i)
        returned.push_back((map.difference(trajectory[i + lag], trajectory[i])).norm());
    std::vector<std::pair<double, std::size_t>> minima;
    for (std::size_t i = 1; i + 1 < returned.size(); ++i)
        if (returned[i] <= vicinity && returned[i] <= returned[i - 1] && returned[i] <= returned[i + 1])
            minima.emplace_back(returned[i], i);
    std::sort(minima.begin(), minima.end());
    std::vector<CyclePoints> candidates;
    for (std::size_t i = 0; i < minima.size() && i < static_cast<std::size_t>(count); ++i) {
        const auto first = trajectory.begin() + static_cast<std::ptrdiff_t>(minima[i].second);
        candidates.emplace_back(first, first + k);
    }
    return candidates;
}

}  // namespace swirl::analysis
