#include "apps/studies/modes/steady_shares.hpp"

#include "analysis/cycles/stability.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::studies {

namespace {

bool is_of(const SettledRun& run, double spin) {
    return run.kind == analysis::Kind::fixed_point &&
           std::abs(run.mean_spin - spin) <= same_mean * std::max(1.0, std::abs(spin));
}

}  // namespace

std::vector<SteadyShare> steady_shares(const Scene<double>& scene, std::span<const SettledRun> runs) {
    SteadyOptions options;
    options.longest_flight = longest_attracting_flight;
    options.attracting = true;
    std::vector<SteadyShare> modes;
    for (const SteadyMode& mode : steady_modes(scene, options).modes) {
        if (!analysis::attracts(mode.multipliers)) continue;
        modes.push_back({mode.point.spin, mode.tau, std::abs(mode.multipliers.front()), 0});
    }
    for (const SettledRun& run : runs) {
        const auto mode =
            std::find_if(modes.begin(), modes.end(), [&](const SteadyShare& m) { return is_of(run, m.spin); });
        if (mode != modes.end()) mode->share += 1 / static_cast<double>(runs.size());
    }
    return modes;
}

}  // namespace swirl::studies
