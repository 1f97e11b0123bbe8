#include "apps/studies/modes/attractors.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/special_values.hpp"
#include "apps/studies/modes/means.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::studies {

namespace {

bool has_own_mean(analysis::Kind kind) {
    using analysis::Kind;
    switch (kind) {
        case Kind::fixed_point:
        case Kind::cycle:
        case Kind::landing:
        case Kind::rolling:
        case Kind::sliding:
        case Kind::two_vertex:
        case Kind::riding:
            return true;
        case Kind::none:
        case Kind::family:
        case Kind::quasi_periodic:
        case Kind::rolling_librating:
        case Kind::rolling_circulating:
        case Kind::chaotic:
        case Kind::transient:
        case Kind::accelerated:
        case Kind::chord:
            return false;
    }
    return false;
}

bool same_attractor(const RunVerdict& a, const RunVerdict& b) {
    if (a.mode != b.mode || a.kind != b.kind || a.outcome != b.outcome || a.period != b.period) return false;
    if (a.kind == analysis::Kind::chord) return means_agree(a.limit_spin, b.limit_spin);
    return !has_own_mean(a.kind) ||
           (means_agree(a.mean_spin, b.mean_spin) && means_agree(a.mean_spin_per_impact, b.mean_spin_per_impact));
}

void summarise(std::span<const RunVerdict> runs, SharedAttractor& attractor) {
    std::vector<double> errors;
    const auto measured = [&](double RunVerdict::*member) {
        std::vector<double> values;
        for (const std::size_t r : attractor.runs)
            if (std::isfinite(runs[r].*member)) values.push_back(runs[r].*member);
        return values;
    };
    for (const std::size_t r : attractor.runs) errors.push_back(runs[r].mean_errors.per_time);
    const auto spins = measured(&RunVerdict::mean_spin);
    attractor.mean_spin = mean_of(spins);
    attractor.mean_spin_error = error_of_mean(spins, errors);
    attractor.recurrence_rate = mean_of(measured(&RunVerdict::recurrence_rate));
    attractor.largest_exponent = mean_of(measured(&RunVerdict::largest_exponent));
}

}  // namespace

bool means_agree(double a, double b) {
    if (std::isnan(a) || std::isnan(b)) return std::isnan(a) == std::isnan(b);
    return std::abs(a - b) <= same_mean * std::max({1.0, std::abs(a), std::abs(b)});
}

std::vector<SharedAttractor> attractors_of(std::span<const RunVerdict> runs) {
    std::vector<SharedAttractor> found;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const auto same = std::find_if(found.begin(), found.end(), [&](const SharedAttractor& attractor) {
            return same_attractor(runs[attractor.runs.front()], runs[r]);
        });
        if (same != found.end())
            same->runs.push_back(r);
        else
            found.push_back({{r}, 0, 0, 0, 0});
    }
    for (auto& attractor : found) summarise(runs, attractor);
    std::stable_sort(found.begin(), found.end(),
                     [](const SharedAttractor& a, const SharedAttractor& b) { return a.runs.size() > b.runs.size(); });
    return found;
}

namespace {

/// NaN without a cycle; its multipliers come by falling modulus.
double ln_multiplier_of(const analysis::Classification& verdict) {
    return verdict.multipliers.empty() ? analysis::nan : std::log(std::abs(verdict.multipliers.front()));
}

}  // namespace

RunVerdict run_verdict(std::uint64_t seed, const NamedMode& named) {
    const auto& v = named.verdict;
    return RunVerdict{seed,
                      v.mode,
                      v.kind,
                      named.outcome,
                      std::int64_t{named.impacts},
                      v.period,
                      v.mean,
                      v.mean_per_step,
                      v.recurrence_rate,
                      v.largest_exponent,
                      v.largest_exponent_error,
                      ln_multiplier_of(v),
                      0,
                      v.point,
                      named.mean_errors,
                      named.growth,
                      named.limit_spin};
}

namespace {

bool is_of(const SettledRun& run, double spin) {
    return run.kind == analysis::Kind::fixed_point &&
           std::abs(run.mean_spin - spin) <= same_mean * std::max(1.0, std::abs(spin));
}

}  // namespace

std::vector<SteadyShare> steady_shares(const Scene<double>& scene, std::span<const SettledRun> runs) {
    if (scene.has_own_map()) return {};  // map/steady has the equations of a floor without drag, of sharp polygons
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
