#include "apps/studies/cycles/steady_cycles.hpp"

#include "apps/studies/scene_map/section_coordinates.hpp"
#include "map/dragged/dragged_modes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

namespace swirl::studies::cycles {

namespace {

constexpr double same_mode = 1e-9;  // steady_modes() itself tells modes apart that far

/// A member of the family: midway, or beside that where rounding has the map see another one.
std::optional<SteadyMode> typical_member(const Scene<double>& scene, const SteadyFamily& family) {
    for (const double share : {0.5, 0.4, 0.6, 0.3, 0.7})
        if (auto member = member_of(scene, family, family.from + share * (family.to - family.from))) return member;
    return {};
}

/// The modes are confirmed by the map in double; one with another search need not have them.
bool is_fixed(const analysis::ShootingMap& map, const Eigen::VectorXd& z) {
    const auto step = map.step(z, 0);
    return step.alive && map.distance(step.state, z) <= same_mode;
}

/// Those that were added, as cycles that no guess led to.
std::vector<analysis::Cycle> completed(analysis::KnownCycles& known, int threads) {
    auto cycles = known.completed(threads);
    for (auto& cycle : cycles) cycle.found = 0;
    return cycles;
}

}  // namespace

SteadySearch find_steady_cycles(const Scene<double>& scene, const analysis::ShootingMap& map, double max_time,
                                const std::function<bool()>& stop, int threads, Accuracy accuracy,
                                std::vector<analysis::Cycle>& cycles) {
    SteadyOptions options;
    options.longest_flight = max_time;
    const SteadyModes steady = steady_modes(scene, options);
    std::vector<SteadyMode> modes = steady.modes;
    SteadySearch search{max_time, steady.set, 0, steady.complete_to, steady.families};
    // What could not be listed after all ends what is complete.
    const auto lost = [&](double tau) { search.complete_to = std::min(search.complete_to, tau); };
    for (const SteadyFamily& family : steady.families) {
        const auto member = typical_member(scene, family);
        if (member)
            modes.push_back(*member);
        else
            lost(family.from);
    }
    analysis::KnownCycles known(map, 0, same_mode, false);
    for (const SteadyMode& mode : modes) {
        const Eigen::VectorXd z = coordinates_of(mode.point, scene.is_disk());
        const bool confirmed = accuracy == Accuracy::double_precision || is_fixed(map, z);
        if (stop() || !confirmed || !known.add({z}, mode.residual)) lost(mode.tau);
        if (stop()) break;
        if (!confirmed) ++search.not_fixed;
    }
    auto listed = completed(known, threads);
    search.found = listed.size();
    std::move(listed.begin(), listed.end(), std::back_inserter(cycles));
    return search;
}

std::vector<analysis::Cycle> dragged_cycles(const Scene<double>& scene, const analysis::ShootingMap& map,
                                            double max_time, const RunControl& control,
                                            const std::vector<analysis::Cycle>& found) {
    DraggedModesOptions options;
    options.longest_flight = max_time;
    options.stop = [&] { return control.is_stopped(); };
    analysis::KnownCycles known(map, 0, analysis::same_cycle, false);
    for (const SteadyMode& mode : dragged_modes(scene, options).modes) {
        const Eigen::VectorXd z = coordinates_of(mode.point, scene.is_disk());
        const bool is_found = std::any_of(found.begin(), found.end(), [&](const analysis::Cycle& cycle) {
            return map.distance(cycle.points.front(), z) <= analysis::same_cycle;
        });
        if (!is_found && is_fixed(map, z)) known.add({z}, mode.residual);
    }
    return completed(known, control.threads);
}

const SteadyFamily* family_of(const Scene<double>& scene, const std::vector<SteadyFamily>& families,
                              const analysis::Cycle& cycle) {
    constexpr double same_spin = 1e-9;
    if (cycle.period() != 1) return nullptr;
    const SectionPoint<double> z = section_point_of(cycle.points.front());
    const double tau = cycle.return_time;
    for (const SteadyFamily& family : families) {
        if (tau < family.from || tau > family.to) continue;
        if ((std::cos(z.psi) > 0) != (family.branch == SteadyBranch::plus)) continue;
        const double spin = steady::family_spin(scene, family.branch, family.j, tau, z.spin);
        if (std::abs(spin - z.spin) <= same_spin * (1 + std::abs(spin))) return &family;
    }
    return nullptr;
}

}  // namespace swirl::studies::cycles
