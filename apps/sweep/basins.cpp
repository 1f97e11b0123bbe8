#include "apps/sweep/basins.hpp"

#include "analysis/special_values.hpp"
#include "apps/modes/attractors.hpp"
#include "apps/modes/mode_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swirl::apps::sweep {

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

Table<Basin> basin_table() {
    using F = Field<Basin>;
    const auto kind = [](const Basin& basin) { return kind_of(basin.attractor); };
    const auto period = [](const Basin& basin) { return static_cast<std::int64_t>(basin.attractor.period); };
    const auto mode = [](const Basin& basin) { return mode_of(basin.attractor); };
    const auto spin = [](const Basin& basin) { return basin.attractor.mean_spin; };
    const auto in_percent = [](const Value& value) {
        return fmt::format("  {:>8.2f} %", 100 * std::get<double>(value));
    };
    return {
        {"basin"},
        {F{"mode", mode, "", "mode of the attractor"}.shown("mode", "  {:<12}"),
         kind_field<Basin>(kind).shown("kind", " {:<19}"),
         period_field<Basin>(period).shown("period", dash_for_zero(" {:>6}")),
         F{"mean_S", spin, "1", "time mean of S of a polished cycle"}.shown("mean S", " {:>14.8g}"),
         F{"starts", &Basin::starts, "1", "starts that were run and came to it"}.shown("starts", "  {:>8}"),
         F{"share", &Basin::share, "1", "share of all cells"}.shown("share", {"  {:>10}", in_percent}),
         {"share_low", [](const Basin& b) { return b.interval.low; }, "1", "from this share on, by Wilson's interval"},
         {"share_high", [](const Basin& b) { return b.interval.high; }, "1", "up to this share"}}};
}

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

}  // namespace swirl::apps::sweep
