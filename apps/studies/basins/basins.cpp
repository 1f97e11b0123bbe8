#include "apps/studies/basins/basins.hpp"

#include "analysis/special_values.hpp"
#include "apps/studies/modes/attractors.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace swirl::studies::grids {

namespace {

bool has_exact_spin(const RunResult& run) {
    switch (kind_of(run)) {
        case analysis::Kind::fixed_point:
        case analysis::Kind::cycle:
        case analysis::Kind::landing:
            return std::isfinite(run.mean_spin);
        default:
            return false;
    }
}

}  // namespace

bool has_attractor(const RunResult& run) {
    return kind_of(run) != analysis::Kind::none && kind_of(run) != analysis::Kind::transient;
}

bool is_same_attractor(const RunResult& a, const RunResult& b) {
    if (a.mode != b.mode || a.kind != b.kind || a.period != b.period) return false;
    if (!has_exact_spin(a) || !has_exact_spin(b)) return has_exact_spin(a) == has_exact_spin(b);
    return means_agree(a.mean_spin, b.mean_spin);
}

Basins basins_of(std::span<const RunResult> results, std::span<const char> visited) {
    struct Found {
        RunResult attractor;
        std::int64_t starts = 0, cells = 0;
    };
    std::vector<Found> found;
    Basins all;
    for (std::size_t i = 0; i < results.size(); ++i) {
        all.of_cell.push_back(no_basin);
        if (!has_attractor(results[i])) continue;
        auto known = std::find_if(found.begin(), found.end(),
                                  [&](const Found& f) { return is_same_attractor(f.attractor, results[i]); });
        if (known == found.end()) known = found.insert(found.end(), {results[i]});
        all.of_cell.back() = known - found.begin();
        known->starts += visited.empty() || visited[i] != 0;
        ++known->cells;
    }
    std::vector<std::size_t> order(found.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return found[a].cells > found[b].cells; });
    std::vector<std::int64_t> place(order.size());
    for (const std::size_t from : order) {
        place[from] = static_cast<std::int64_t>(all.basins.size());
        Basin basin{found[from].attractor, found[from].starts};
        if (!has_exact_spin(basin.attractor)) basin.attractor.mean_spin = analysis::nan;
        const auto cells = static_cast<double>(results.size());
        basin.share = static_cast<double>(found[from].cells) / cells;
        basin.interval = visited.empty() ? wilson_interval(basin.share, cells) : Interval{analysis::nan, analysis::nan};
        all.basins.push_back(basin);
    }
    for (auto& basin : all.of_cell)
        if (basin != no_basin) basin = place[static_cast<std::size_t>(basin)];
    return all;
}

}  // namespace swirl::studies::grids
