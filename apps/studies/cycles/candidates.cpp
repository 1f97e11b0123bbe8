#include "apps/studies/cycles/candidates.hpp"

#include "apps/studies/scene_map/chatter_once.hpp"
#include "apps/studies/scene_map/orbit_ending.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/steady/scene_facts.hpp"

#include <cmath>
#include <utility>

namespace swirl::studies::cycles {

namespace {

using analysis::CyclePoints;

/// A point that leaves the wall with all vertices inside: speeds of the swirl's size, S up to rolling and beyond.
///   room  χ_m
Eigen::VectorXd random_section_point(const Scene<double>& scene, double room, const Draws& draws) {
    SectionPoint<double> z;
    const double pi_ = pi<double>();
    const double speed = scene.beta + 0.3;
    const double rolling = (1 - scene.alpha) / scene.alpha;
    const double arm = scene.alpha - scene.corner;  // to a rounded corner's centre
    z.psi = draws.u[5] < 0.5 ? draws.between(0, -pi_, pi_) : draws.between(0, -0.3 * pi_, 0.3 * pi_);
    z.chi = 0.999 * room * draws.between(1, -1, 1);
    z.spin = draws.between(2, -1.5 * rolling - 0.5, 0.5 * rolling + 1.5);
    const double leaving = 2 * speed * draws.u[3] * draws.u[3];
    z.vn = -leaving + arm * z.spin * std::sin(z.chi) + scene.beta * std::sin(z.psi);
    // Half of them without slip, which is where sticking impacts lead.
    z.vt = scene.beta * std::cos(z.psi) - arm * z.spin * std::cos(z.chi) - scene.corner * z.spin +
           (draws.u[6] < 0.5 ? 0 : draws.between(4, -speed, speed));
    return coordinates_of(z, scene.is_disk());
}

bool stopped(const analysis::Stop& stop) {
    return stop && stop();
}

/// k states after `skip` impacts from z; empty if the map ends.
CyclePoints states_from(const analysis::ShootingMap& map, const Eigen::VectorXd& z, int skip, int k) {
    const CyclePoints orbit = analysis::orbit_from(map, z, 0, skip + k);
    return orbit.empty() ? orbit : CyclePoints(orbit.begin() + skip, orbit.end());
}

}  // namespace

std::vector<CyclePoints> trajectories_of(const Scene<double>& scene, const CandidateOptions& options,
                                         const analysis::Stop& stop) {
    constexpr double horizon = 10;
    return with_scene_map(
        scene,
        [&](const auto& map) {
            std::vector<CyclePoints> trajectories;
            for (std::int64_t run = 0; run < options.trajectories; ++run) {
                const auto start =
                    random_start(scene.beta, options.speed, options.seed, static_cast<std::uint64_t>(run));
                CyclePoints points;
                OrbitBegin begin = begin_orbit(map, start);
                const auto goes_on = [&] {
                    return static_cast<std::int64_t>(points.size()) < options.collisions && !stopped(stop);
                };
                for (bool alive = begin.impacts > 0; alive && goes_on();) {
                    points.emplace_back(map.coordinates(begin.state));
                    const auto step = advance_as_one(map, begin.state);
                    alive = step.alive;
                    begin.state = step.state;
                }
                trajectories.push_back(std::move(points));
            }
            return trajectories;
        },
        horizon, options.accuracy);
}

std::vector<CyclePoints> returning_candidates(const analysis::ShootingMap& map, int k,
                                              const std::vector<CyclePoints>& trajectories,
                                              const CandidateOptions& options) {
    std::vector<CyclePoints> candidates;
    const auto length = static_cast<std::size_t>(k);
    for (const CyclePoints& trajectory : trajectories) {
        if (trajectory.size() < length) continue;
        candidates.emplace_back(trajectory.end() - k, trajectory.end());
        for (auto& guess : close_returns(map, trajectory, k, options.returns, options.vicinity))
            candidates.push_back(std::move(guess));
    }
    return candidates;
}

std::vector<CyclePoints> random_candidates(const Scene<double>& scene, const analysis::ShootingMap& map, int k,
                                           std::int64_t from, std::int64_t to, const CandidateOptions& options,
                                           const analysis::Stop& stop) {
    std::vector<CyclePoints> candidates;
    const double room = scene_facts(scene).widest_chi;
    for (std::int64_t i = from; i < to && !stopped(stop); ++i) {
        const Draws draws(options.seed, static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(i));
        const auto skip = static_cast<int>(4 * draws.u[7]);
        CyclePoints guess = states_from(map, random_section_point(scene, room, draws), skip, k);
        if (!guess.empty()) candidates.push_back(std::move(guess));
    }
    return candidates;
}

}  // namespace swirl::studies::cycles
