#include "apps/studies/cycles/near_orbit.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/find_cycles.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/studies/cycles/candidates.hpp"
#include "apps/studies/cycles/find_orbits.hpp"
#include "apps/studies/scene_map/chatter_once.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/steady/scene_facts.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <utility>

namespace swirl::studies::cycles {

analysis::CyclePoints cycle_from(const CyclePlace& place, int period, const analysis::ShootingMap& map, double p) {
    constexpr double closes = 1e-10;
    if (place.points.empty()) return {};
    const bool disk = place.scene.is_disk();
    analysis::CyclePoints guess;
    if (std::ssize(place.points) == period)
        for (const auto& z : place.points) guess.push_back(coordinates_of(z, disk));
    else
        guess = analysis::orbit_from(map, coordinates_of(place.points.front(), disk), p, period);
    if (guess.empty()) return {};
    const auto shot = analysis::solve_shooting(map, guess, p, closes);
    if (!shot.converged) return {};
    const auto cycle = analysis::minimal_cycle(map, shot.points, analysis::same_cycle);
    return static_cast<int>(cycle.size()) == period ? cycle : analysis::CyclePoints{};
}

namespace {

using analysis::CyclePoints;

constexpr double smallest_cloud = 3e-6, largest_cloud = 3e-2;
constexpr std::int64_t most_steps = 400'000;  // of the map, for one cloud
constexpr std::int64_t most_points = 8000;
constexpr std::size_t solved_of_cloud = 12;

/// What a solution is judged by.
struct Solution {
    CyclePoints points;
    double residual = std::numeric_limits<double>::infinity();  ///< reached
    double distance = std::numeric_limits<double>::infinity();  ///< of its nearest point from z
    int iterations = 0;
};

struct NearSearch {
    const Scene<double>& scene;
    const analysis::ShootingMap& map;
    const analysis::TimedMap* timed;  ///< none over a floor that drags
    Accuracy accuracy;
    Eigen::VectorXd near;
    int period;
};

/// Of minimal period k, by the map or with the impacts' times as unknowns, whichever ends nearer: near grazing the
/// map's steps may lead far away.
Solution solve_from(const NearSearch& search, const CyclePoints& guess) {
    Solution best;
    const auto take = [&](const analysis::ShootingResult& shot) {
        if (best.points.empty()) {
            best.residual = std::min(best.residual, shot.residual);
            best.iterations = std::max(best.iterations, shot.iterations);
        }
        if (!shot.converged) return;
        const auto points = analysis::minimal_cycle(search.map, shot.points, analysis::same_cycle);
        if (static_cast<int>(points.size()) != search.period) return;
        double distance = std::numeric_limits<double>::infinity();
        for (const auto& point : points) distance = std::min(distance, search.map.distance(point, search.near));
        if (distance < best.distance - analysis::same_cycle)  // both to rounding on one cycle: the map's own
            best = {points, shot.residual, distance, shot.iterations};
    };
    take(analysis::solve_shooting(search.map, guess, 0, accepted));
    if (search.timed != nullptr) take(analysis::solve_near_grazing(search.map, *search.timed, guess, 0, accepted));
    return best;
}

/// A point of the cloud, and how far from it its k-th image is.
struct Returning {
    double gap;
    CyclePoints points;
};

/// Point number i of a cloud about `near`; empty where the body would not leave the wall or another vertex is outside.
Eigen::VectorXd cloud_point(const NearSearch& search, const Body<double>& body, double room, double radius,
                            std::int64_t i) {
    const Draws draws(1, static_cast<std::uint64_t>(search.period), static_cast<std::uint64_t>(i));
    Eigen::VectorXd start = search.near;
    for (Eigen::Index j = 0; j < start.size(); ++j)
        start[j] += draws.between(static_cast<std::size_t>(j), -radius, radius);
    const SectionPoint<double> z = section_point_of(start);
    const bool leaves = kinematics_of(body, post_impact_state(z)).un < 0;
    return leaves && std::abs(z.chi) <= room ? start : Eigen::VectorXd();
}

/// The points of a cloud whose k-th images come back best.
std::vector<Returning> best_of_cloud(const NearSearch& search, double radius) {
    const std::int64_t count = std::min(most_points, most_steps / search.period);
    const auto body = make_body(search.scene);
    const double room = scene_facts(search.scene).widest_chi;
    const auto follow = [&]<int D>(const SceneMap<D>& map) {
        std::vector<Returning> all;
        for (std::int64_t i = 0; i < count; ++i) {
            const Eigen::VectorXd start = cloud_point(search, body, room, radius, i);
            if (start.size() == 0) continue;
            CyclePoints points{start};
            auto z = map.state_at(analysis::Vector<D>(start));
            bool alive = true;
            for (int k = 1; alive && k <= search.period; ++k) {
                const auto step = advance_as_one(map, z);
                alive = step.alive;
                z = step.state;
                if (alive) points.emplace_back(map.coordinates(z));
            }
            if (!alive) continue;
            const double gap = search.map.difference(points.back(), points.front()).norm();
            points.pop_back();
            all.push_back({gap, std::move(points)});
        }
        const auto kept = std::min(all.size(), solved_of_cloud);
        std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), all.end(),
                          [](const Returning& a, const Returning& b) { return a.gap < b.gap; });
        all.resize(kept);
        return all;
    };
    return with_scene_map(search.scene, follow, solver_horizon, search.accuracy);
}

/// A point whose orbit has not k impacts.
ShortOrbit ends_early(const NearSearch& search) {
    int steps = 0;
    auto step = search.map.step(search.near, 0);
    for (; step.alive; ++steps) step = search.map.step(step.state, 0);
    return {search.period, steps};
}

Solution nearest_cycle(const NearSearch& search, const std::function<bool()>& stop, FoundOrbits& found) {
    Solution best;
    const auto take = [&](const CyclePoints& guess) {
        ++found.tried;
        Solution solution = solve_from(search, guess);
        found.converged += solution.points.empty() ? 0 : 1;
        if (solution.distance < best.distance - analysis::same_cycle || best.points.empty()) {
            solution.residual =
                solution.points.empty() ? std::min(best.residual, solution.residual) : solution.residual;
            best = std::move(solution);
        }
    };
    const auto guess = analysis::orbit_from(search.map, search.near, 0, search.period);
    if (guess.empty())
        found.too_short.push_back(ends_early(search));
    else
        take(guess);
    for (double radius = smallest_cloud; radius < std::min(2 * largest_cloud, best.distance) && !stop(); radius *= 10)
        for (const Returning& returning : best_of_cloud(search, radius)) take(returning.points);
    return best;
}

}  // namespace

FoundOrbits find_near(const Scene<double>& scene, const analysis::ShootingMap& map, Accuracy accuracy,
                      const SectionPoint<double>& z, int first_period, int last_period,
                      const std::function<bool()>& stop) {
    FoundOrbits found;
    const auto timed = scene.has_own_map() ? analysis::TimedMap{} : timed_map_of(scene);
    const Eigen::VectorXd near = coordinates_of(z, scene.is_disk());
    analysis::KnownCycles known(map, 0, analysis::same_cycle, false);
    for (int k = first_period; k <= last_period && !stop(); ++k) {
        const Solution best =
            nearest_cycle({scene, map, scene.has_own_map() ? nullptr : &timed, accuracy, near, k}, stop, found);
        found.iterations = best.iterations;
        found.reached = std::isfinite(best.residual) ? best.residual : std::nan("");
        if (best.points.empty()) continue;
        known.add(best.points, best.residual);
        found.distance = std::min(found.distance, best.distance);
    }
    found.cycles = known.completed();
    found.interrupted = stop();
    return found;
}

}  // namespace swirl::studies::cycles
