#include "apps/sweep/basins.hpp"

#include "apps/modes/mode_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace swirl::apps::sweep {

namespace {

bool has_exact_spin(const RunResult& run) {
    const auto kind = static_cast<analysis::Kind>(static_cast<int>(run.kind));
    switch (kind) {
        case analysis::Kind::fixed_point:
        case analysis::Kind::cycle:
        case analysis::Kind::landing:
        case analysis::Kind::sliding:
        case analysis::Kind::two_vertex:
            return std::isfinite(run.mean_spin);
        default:
            return false;
    }
}

}  // namespace

Table<Basin> basin_table() {
    using F = Field<Basin>;
    const auto kind = [](const Basin& basin) {
        return static_cast<analysis::Kind>(static_cast<int>(basin.attractor.kind));
    };
    const auto period = [](const Basin& basin) { return static_cast<std::int64_t>(basin.attractor.period); };
    const auto mode = [](const Basin& basin) {
        return static_cast<analysis::Mode>(static_cast<int>(basin.attractor.mode));
    };
    const auto spin = [](const Basin& basin) { return basin.attractor.mean_spin; };
    const auto in_percent = [](const Value& value) {
        return fmt::format("  {:>8.2f} %", 100 * std::get<double>(value));
    };
    return {
        {"basin"},
        {F{"mode", mode}.shown("mode", "  {:<12}"),
         kind_field<Basin>(kind).shown("kind", " {:<19}"),
         period_field<Basin>(period).shown("period", dash_for_zero(" {:>6}")),
         F{"mean_S", spin, "omega_s", "time mean of S, of the first start that came to it"}.shown("mean S",
                                                                                                  " {:>14.8g}"),
         F{"starts", &Basin::starts, "1", "starts that came to it"}.shown("starts", "  {:>8}"),
         F{"share", &Basin::share, "1", "share of all starts"}.shown("share", {"  {:>10}", in_percent}),
         {"share_low", [](const Basin& b) { return b.interval.low; }, "1", "from this share on, by Wilson's interval"},
         {"share_high", [](const Basin& b) { return b.interval.high; }, "1", "up to this share"}}};
}

bool is_same_attractor(const RunResult& a, const RunResult& b) {
    if (a.mode != b.mode || a.kind != b.kind || a.period != b.period) return false;
    if (!has_exact_spin(a) || !has_exact_spin(b)) return has_exact_spin(a) == has_exact_spin(b);
    return std::abs(a.mean_spin - b.mean_spin) <= same_spin * (1 + std::abs(a.mean_spin));
}

Basins basins_of(std::span<const RunResult> results) {
    Basins found;
    for (const RunResult& run : results) {
        const auto known = std::find_if(found.basins.begin(), found.basins.end(),
                                        [&](const Basin& basin) { return is_same_attractor(basin.attractor, run); });
        found.of_cell.push_back(known - found.basins.begin());
        if (known == found.basins.end())
            found.basins.push_back({run, 1});
        else
            ++known->starts;
    }
    std::vector<std::size_t> order(found.basins.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return found.basins[a].starts > found.basins[b].starts; });
    std::vector<std::int64_t> place(order.size());
    std::vector<Basin> sorted;
    for (const std::size_t from : order) {
        place[from] = static_cast<std::int64_t>(sorted.size());
        sorted.push_back(found.basins[from]);
        sorted.back().share = static_cast<double>(sorted.back().starts) / static_cast<double>(results.size());
        sorted.back().interval = wilson_interval(sorted.back().share, static_cast<double>(results.size()));
    }
    found.basins = std::move(sorted);
    for (auto& basin : found.of_cell) basin = place[static_cast<std::size_t>(basin)];
    return found;
}

}  // namespace swirl::apps::sweep
