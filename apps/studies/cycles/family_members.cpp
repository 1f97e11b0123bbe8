#include "apps/studies/cycles/family_members.hpp"

#include "analysis/cycles/find_cycles.hpp"
#include "apps/studies/cycles/steady_cycles.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace swirl::studies::cycles {

namespace {

constexpr double time_step = 1e-3;  // S of a family of fixed points varies over times of order 1

double pinned_value(const analysis::CurvePoint& point, bool by_time) {
    return by_time ? point.shooting.duration : point.points().front().tail(1)[0];
}

/// Flight times from one end of a family to the other.
std::vector<double> flight_times(const SteadyFamily& family) {
    const int cells = 1 + static_cast<int>((family.to - family.from) / time_step);
    std::vector<double> times;
    for (int i = 0; i <= cells; ++i) times.push_back(family.from + (family.to - family.from) * i / cells);
    times.front() = std::max(times.front(), 1e-9);  // S has a limit as τ → 0, but no value there
    return times;
}

FamilyRange range_of_steady(const Scene<double>& scene, const SteadyFamily& family) {
    FamilyRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), family.from,
                      family.to, false};
    for (const double tau : flight_times(family)) {
        const double spin = steady::family_spin(scene, family.branch, family.j, tau);
        range.least_spin = std::min(range.least_spin, spin);
        range.most_spin = std::max(range.most_spin, spin);
    }
    return range;
}

FamilyRange range_by_walking(const analysis::ShootingMap& map, const analysis::Cycle& cycle) {
    const auto family = analysis::walk_family(map, 0, cycle);
    FamilyRange range{cycle.points.front().tail(1)[0], cycle.points.front().tail(1)[0], cycle.return_time,
                      cycle.return_time, family.closed};
    for (const auto& member : family.members) {
        const double spin = pinned_value(member, false);
        range.least_spin = std::min(range.least_spin, spin);
        range.most_spin = std::max(range.most_spin, spin);
        range.shortest = std::min(range.shortest, member.shooting.duration);
        range.longest = std::max(range.longest, member.shooting.duration);
    }
    return range;
}

/// The flight times of a family's members with the value.
std::vector<double> pinned_times(const Scene<double>& scene, const SteadyFamily& family, const Pin& pin) {
    if (pin.by_time)
        return pin.value > family.from && pin.value < family.to ? std::vector{pin.value} : std::vector<double>{};
    const auto gap = [&](double tau) { return steady::family_spin(scene, family.branch, family.j, tau) - pin.value; };
    std::vector<double> found;
    const auto times = flight_times(family);
    for (std::size_t i = 1; i < times.size(); ++i) {
        const double before = gap(times[i - 1]), behind = gap(times[i]);
        if (before == 0 && behind != 0) found.push_back(times[i - 1]);
        if (!(before * behind < 0)) continue;
        std::uintmax_t most = 100;
        found.push_back(boost::math::tools::toms748_solve(gap, times[i - 1], times[i], before, behind,
                                                          boost::math::tools::eps_tolerance<double>(52), most)
                            .first);
    }
    return found;
}

}  // namespace

FamilyRange range_of(const Scene<double>& scene, const analysis::ShootingMap& map,
                     const std::optional<SteadySearch>& steady, const analysis::Cycle& cycle) {
    const SteadyFamily* family = steady ? family_of(scene, steady->families, cycle) : nullptr;
    return family != nullptr ? range_of_steady(scene, *family) : range_by_walking(map, cycle);
}

void pin_families(const Scene<double>& scene, const analysis::ShootingMap& map, const Pin& pin, FoundOrbits& found) {
    analysis::KnownCycles members(map, 0, 1e-7, false);
    for (const auto& cycle : found.cycles) {
        if (cycle.tangents.cols() > 1)
            found.limits.emplace_back(
                "a family of more than one parameter has no single member with that value: left out");
        if (cycle.tangents.cols() != 1) continue;
        const SteadyFamily* steady = found.steady ? family_of(scene, found.steady->families, cycle) : nullptr;
        if (steady != nullptr) {
            for (const double tau : pinned_times(scene, *steady, pin))
                if (const auto member = member_of(scene, *steady, tau))
                    members.add({coordinates_of(member->point, scene.is_disk())}, member->residual);
            continue;
        }
        const auto family = analysis::walk_family(map, 0, cycle);
        const auto value = [&](const analysis::CurvePoint& point) { return pinned_value(point, pin.by_time); };
        for (const auto& points : analysis::pinned_members(map, family, value, pin.value))
            members.add(points, analysis::shooting_residual(map, points, 0).residual());
    }
    found.cycles = members.completed();
}

}  // namespace swirl::studies::cycles
