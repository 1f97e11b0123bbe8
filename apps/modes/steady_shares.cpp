#include "apps/modes/steady_shares.hpp"

#include "analysis/cycles/stability.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps {

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

Table<SteadyShare> steady_share_table(const std::string& dimension) {
    return {{dimension},
            {{"S", &SteadyShare::spin, "1", "S of the attracting steady mode"},
             {"period", [](const SteadyShare&) { return std::int64_t{1}; }, "1", "of a fixed point, 1"},
             {"share", &SteadyShare::share, "1", "share of the starts that came to it"},
             {"flight_time", &SteadyShare::flight_time, "1/omega_s", "from impact to impact"},
             {"multiplier", &SteadyShare::multiplier, "1", "its largest |multiplier|"}}};
}

std::vector<double> filled(std::span<const SteadyShare> modes, double SteadyShare::*member, std::size_t length) {
    std::vector<double> values(length, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < modes.size() && i < length; ++i) values[i] = modes[i].*member;
    return values;
}

}  // namespace swirl::apps
