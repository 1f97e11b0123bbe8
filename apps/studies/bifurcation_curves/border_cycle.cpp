#include "apps/studies/bifurcation_curves/border_cycle.hpp"

#include "apps/studies/bifurcation_curves/starting_points.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace swirl::studies::bifurcation_curves {

std::string_view name_of(Touch touch) {
    switch (touch) {
        case Touch::grazing:
            return "grazing";
        case Touch::two_vertices:
        case Touch::no_flight:
            return "two-vertices";
        case Touch::slip_ends:
        case Touch::slip_late:
        case Touch::slip_held:
            break;
    }
    return "stick-slip";
}

bool is_on_border(std::string_view kind) {
    return kind == "grazing" || kind == "two-vertices" || kind == "stick-slip";
}

namespace {

/// Velocities, times and gaps that count as zero where a starting point lies: branches are followed to 10⁻⁶ of a border
/// and then extrapolated; curves to 10⁻⁹, where an impact has 10⁻⁶.
constexpr double nearly = 1e-3;

/// Numbers the cycle from flight `first` on.
void rotate(BorderCycle& cycle, std::size_t first) {
    const auto by = static_cast<std::ptrdiff_t>(first);
    std::rotate(cycle.points.begin(), cycle.points.begin() + by, cycle.points.end());
    std::rotate(cycle.times.begin(), cycle.times.begin() + by, cycle.times.end());
    std::rotate(cycle.vertices.begin(), cycle.vertices.begin() + by, cycle.vertices.end());
}

/// The impact with the smallest u_n at its end, if that vanishes.
std::optional<std::size_t> vanishing_impact(const ItineraryMap& map, const BorderCycle& cycle) {
    std::optional<std::size_t> found;
    double least = nearly;
    for (std::size_t i = 0; i < cycle.points.size(); ++i) {
        const double rate = map.touch(cycle.points[i], cycle.times[i], cycle.p, cycle.vertices[i]).rate;
        if (!(std::abs(rate) < least)) continue;
        least = std::abs(rate);
        found = i;
    }
    return found;
}

/// The cycle without the impact at the end of flight 0, whose vertex touches there.
bool leave_out_impact(const ItineraryMap& map, BorderCycle& cycle) {
    if (cycle.points.size() < 2) return false;
    cycle.touch = Touch::grazing;
    cycle.vertex = cycle.vertices[0];
    cycle.touch_time = cycle.times[0];
    cycle.times[0] += cycle.times[1];
    cycle.vertices[0] = map.sides > 0 ? (cycle.vertices[0] + cycle.vertices[1]) % map.sides : 0;
    cycle.points.erase(cycle.points.begin() + 1);
    cycle.times.erase(cycle.times.begin() + 1);
    cycle.vertices.erase(cycle.vertices.begin() + 1);
    return true;
}

/// Where on the flights a vertex comes nearest to the wall in between.
bool find_grazing(const ItineraryMap& map, BorderCycle& cycle) {
    constexpr int samples = 1000;
    double highest = -nearly;
    std::size_t flight = 0;
    for (std::size_t i = 0; i < cycle.points.size(); ++i) {
        const auto gap = [&](int s) { return map.nearest(cycle.points[i], cycle.times[i] * s / samples, cycle.p)[0]; };
        for (int s = 1; s < samples; ++s) {
            const auto here = gap(s);
            if (!(here.second > highest) || here.second < gap(s - 1).second || here.second < gap(s + 1).second)
                continue;
            highest = here.second;
            flight = i;
            cycle.vertex = here.first;
            cycle.touch_time = cycle.times[i] * s / samples;
        }
    }
    if (highest == -nearly) return false;
    rotate(cycle, flight);
    return true;
}

/// The flight that takes no time, or at whose end another vertex is on the wall.
bool find_second_vertex(const ItineraryMap& map, BorderCycle& cycle) {
    const auto shortest = std::min_element(cycle.times.begin(), cycle.times.end());
    if (*shortest < nearly) {
        cycle.touch = Touch::no_flight;
        rotate(cycle, static_cast<std::size_t>(shortest - cycle.times.begin()));
        return true;
    }
    cycle.touch = Touch::two_vertices;
    double least = nearly;
    std::optional<std::size_t> flight;
    for (std::size_t i = 0; i < cycle.points.size(); ++i) {
        for (const auto& [vertex, gap] : map.nearest(cycle.points[i], cycle.times[i], cycle.p)) {
            if (vertex == cycle.vertices[i] || !(std::abs(gap) < least)) continue;
            least = std::abs(gap);
            flight = i;
            cycle.vertex = vertex;
        }
    }
    if (flight) rotate(cycle, *flight);
    return flight.has_value();
}

/// The impact whose contact mode changes on the border, and what changes there.
bool find_slip(const StartingPoint& start, BorderCycle& cycle) {
    for (std::size_t i = 0; i < start.modes_before.size() && i < start.modes_behind.size(); ++i) {
        const ContactMode a = start.modes_before[i], b = start.modes_behind[i];
        if (a == b) continue;
        if (a == ContactMode::sliding || b == ContactMode::sliding)
            cycle.touch = Touch::slip_ends;
        else
            cycle.touch = ends_in_stick(a) == ends_in_stick(b) ? Touch::slip_late : Touch::slip_held;
        rotate(cycle, i);
        return true;
    }
    return false;
}

/// The impact nearest to a change of its contact mode, and what changes there: where the starting point names no modes.
bool find_nearest_slip(const ItineraryMap& map, BorderCycle& cycle) {
    double least = nearly;
    std::optional<std::size_t> impact;
    for (std::size_t i = 0; i < cycle.points.size(); ++i) {
        const ItineraryStep step = map.step(cycle.points[i], cycle.times[i], cycle.p, cycle.vertices[i]);
        const auto look_at = [&](Touch touch, const ModeMargin& margin) {
            const double away = std::abs(margin.value) / margin.by.norm();
            if (!(away < least)) return;
            least = away;
            impact = i;
            cycle.touch = touch;
        };
        if (!step.stops) continue;
        look_at(Touch::slip_ends, step.slip);
        if (!(step.slip.value < 0)) continue;  // it does not stop before the impact ends
        look_at(Touch::slip_late, step.late);
        look_at(Touch::slip_held, step.held);
    }
    if (impact) rotate(cycle, *impact);
    return impact.has_value();
}

}  // namespace

std::optional<BorderCycle> border_cycle_of(const ItineraryMap& map, const StartingPoint& start) {
    if (start.border) return start.border;
    if (start.times.size() != start.points.size()) return std::nullopt;
    BorderCycle cycle;
    cycle.points = start.points;
    cycle.times = start.times;
    cycle.vertices = start.vertices;
    cycle.p = start.p;
    if (start.kind == "two-vertices") {
        if (map.sides == 0 || !find_second_vertex(map, cycle)) return std::nullopt;
        return cycle;
    }
    if (start.kind == "stick-slip") {
        if (!(start.modes_before.empty() ? find_nearest_slip(map, cycle) : find_slip(start, cycle)))
            return std::nullopt;
        return cycle;
    }
    if (const auto impact = vanishing_impact(map, cycle)) {
        rotate(cycle, *impact);
        if (!leave_out_impact(map, cycle)) return std::nullopt;
        return cycle;
    }
    if (!find_grazing(map, cycle)) return std::nullopt;
    return cycle;
}

}  // namespace swirl::studies::bifurcation_curves
