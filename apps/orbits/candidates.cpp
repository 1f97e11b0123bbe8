#include "apps/orbits/candidates.hpp"

#include "apps/command_line/start_options.hpp"
#include "apps/scene_map/scene_map.hpp"
#include "map/orbit.hpp"

#include <Random123/philox.h>
#include <Random123/uniform.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace swirl::apps {

namespace {

using analysis::CyclePoints;

/// The closed form of a steady mode at e = 1, with spin S.
Eigen::VectorXd steady_point(const Scene<double>& scene, double tau, double spin) {
    const double radius = scene.beta + 1 - scene.alpha;
    const double half = std::sin(0.5 * tau);
    return state_of({0, 0, -2 * radius / tau * half * half, radius * std::sin(tau) / tau, spin}, scene.is_disk());
}

/// S of a steady mode whose contact does not slip.
double spin_without_slip(const Scene<double>& scene, double tau) {
    const double radius = scene.beta + 1 - scene.alpha;
    return (scene.beta - radius * std::sin(tau) / tau) / scene.alpha;
}

/// Flights longer than that can't clear the wall's swing: in half a swirl the wall comes 2β nearer, so the body must
/// have come that far at |V| ≤ 2R/τ.
double longest_flight(const Scene<double>& scene) {
    const double pi_ = pi<double>();
    return 2 * pi_ + pi_ * (scene.beta + 1 - scene.alpha) / scene.beta;
}

constexpr double longest_tau = 200;

double last_tau(const Scene<double>& scene) { return std::min(longest_flight(scene), longest_tau); }

constexpr double tau_step = 0.01;
constexpr double fastest_spin = 5;  // without friction S is free: that of what a user may see
constexpr int least_j = -4, most_j = 8;
constexpr std::size_t most_guesses = 1'000'000;

std::vector<CyclePoints> guesses_on_grid(const Scene<double>& scene, bool no_slip) {
    std::vector<CyclePoints> guesses;
    for (double tau = 5 * tau_step; tau < last_tau(scene); tau += 5 * tau_step) {
        if (no_slip) {
            guesses.push_back({steady_point(scene, tau, spin_without_slip(scene, tau))});
            continue;
        }
        if (scene.is_disk()) {  // any S will do
            guesses.push_back({steady_point(scene, tau, 0)});
            continue;
        }
        for (int j = least_j; j <= most_j; ++j) {
            const double spin = 1 - 2 * pi<double>() * j / (scene.sides * tau);
            if (std::abs(spin) <= fastest_spin) guesses.push_back({steady_point(scene, tau, spin)});
        }
    }
    return guesses;
}

/// Roots τ of Nτ(1 − S(τ))/2π = j for every whole j.
std::vector<CyclePoints> guesses_of_polygon(const Scene<double>& scene) {
    const double turns = scene.sides / (2 * pi<double>());
    const auto vertices_on = [&](double tau) { return turns * tau * (1 - spin_without_slip(scene, tau)); };
    std::vector<CyclePoints> guesses;
    double last = vertices_on(0.1 * tau_step);
    for (double tau = tau_step; tau < last_tau(scene) && guesses.size() < most_guesses; tau += tau_step) {
        const double next = vertices_on(tau);
        const double low = std::min(last, next), high = std::max(last, next);
        for (double j = std::ceil(low); j <= high && guesses.size() < most_guesses; ++j) {
            std::uintmax_t most = 100;
            const auto gap = [&](double t) { return vertices_on(t) - j; };
            const double begin = std::max(tau - tau_step, 0.1 * tau_step);
            if (gap(begin) * gap(tau) > 0) continue;
            const auto root = boost::math::tools::toms748_solve(
                gap, begin, tau, boost::math::tools::eps_tolerance<double>(50), most);
            guesses.push_back({steady_point(scene, root.first, 1 - j / (turns * root.first))});
        }
        last = next;
    }
    return guesses;
}

/// Uniform numbers of one candidate.
struct Draws {
    std::array<double, 8> u;
    Draws(std::uint64_t seed, std::uint64_t period, std::uint64_t index) {
        const r123::Philox4x64 generator;
        for (std::uint64_t half = 0; half < 2; ++half) {
            const auto bits = generator({{index, period, half, 0x6f72626974}}, {{seed, 1}});
            for (std::size_t i = 0; i < 4; ++i) u[4 * half + i] = r123::u01<double>(bits[i]);
        }
    }
    double between(std::size_t i, double low, double high) const { return low + (high - low) * u[i]; }
};

/// A point that leaves the wall with all vertices inside: speeds of the swirl's size, S up to rolling and beyond.
Eigen::VectorXd random_section_point(const Scene<double>& scene, const Draws& draws) {
    SectionPoint<double> z;
    const double pi_ = pi<double>();
    const double room = scene.is_disk() ? 0 : pi_ / scene.sides - std::asin(scene.alpha * std::sin(pi_ / scene.sides));
    const double speed = scene.beta + 0.3;
    const double rolling = (1 - scene.alpha) / scene.alpha;
    z.psi = draws.u[5] < 0.5 ? draws.between(0, -pi_, pi_) : draws.between(0, -0.3 * pi_, 0.3 * pi_);
    z.chi = 0.999 * room * draws.between(1, -1, 1);
    z.spin = draws.between(2, -1.5 * rolling - 0.5, 0.5 * rolling + 1.5);
    const double leaving = 2 * speed * draws.u[3] * draws.u[3];
    z.vn = -leaving + scene.alpha * z.spin * std::sin(z.chi) + scene.beta * std::sin(z.psi);
    // Half of them without slip, which is where sticking impacts lead.
    z.vt = scene.beta * std::cos(z.psi) - scene.alpha * z.spin * std::cos(z.chi) +
           (draws.u[6] < 0.5 ? 0 : draws.between(4, -speed, speed));
    return state_of(z, scene.is_disk());
}

bool stopped(const CandidateOptions& options) { return options.stop && options.stop(); }

/// k states after `skip` impacts from z; empty if the map ends.
CyclePoints states_from(const analysis::ShootingMap& map, const Eigen::VectorXd& z, int skip, int k) {
    const CyclePoints orbit = analysis::orbit_from(map, z, 0, skip + k);
    return orbit.empty() ? orbit : CyclePoints(orbit.begin() + skip, orbit.end());
}

}  // namespace

SteadyGuesses steady_guesses(const Scene<double>& scene) {
    SteadyGuesses guesses;
    if (scene.mu == 0) guesses.points = guesses_on_grid(scene, false);
    else guesses.points = scene.is_disk() ? guesses_on_grid(scene, true) : guesses_of_polygon(scene);
    if (longest_flight(scene) > longest_tau)
        guesses.limits.push_back(fmt::format("steady modes are sought up to tau = {:g}; there may be longer ones, up to {:g}",
                                             longest_tau, longest_flight(scene)));
    if (scene.mu == 0 && !scene.is_disk())
        guesses.limits.push_back(fmt::format("without friction S is free: steady modes are sought for |S| <= {:g}, j = {} to {}",
                                             fastest_spin, least_j, most_j));
    if (guesses.points.size() >= most_guesses)
        guesses.limits.push_back(fmt::format("only the first {} steady modes are tried", most_guesses));
    return guesses;
}

std::vector<CyclePoints> trajectories_of(const Scene<double>& scene, const CandidateOptions& options) {
    return with_collision_map(scene, [&](const auto& map) {
        std::vector<CyclePoints> trajectories;
        for (std::int64_t run = 0; run < options.trajectories; ++run) {
            const auto start = random_start(scene.beta, options.speed, options.seed, static_cast<std::uint64_t>(run));
            Orbit orbit(map, start);
            CyclePoints states;
            const auto goes_on = [&] { return orbit.impacts() < options.collisions && !stopped(options); };
            while (goes_on() && orbit.advance(10))
                states.push_back(state_of(section_point(orbit.launch()), scene.is_disk()));
            trajectories.push_back(std::move(states));
        }
        return trajectories;
    });
}

std::vector<CyclePoints> candidates_for(const Scene<double>& scene, const analysis::ShootingMap& map, int k,
                                        const std::vector<CyclePoints>& trajectories, const CandidateOptions& options) {
    std::vector<CyclePoints> candidates;
    if (k == 1) candidates = steady_guesses(scene).points;
    const auto length = static_cast<std::size_t>(k);
    for (const CyclePoints& trajectory : trajectories) {
        if (trajectory.size() < length) continue;
        candidates.emplace_back(trajectory.end() - k, trajectory.end());
        for (auto& guess : close_returns(map, trajectory, k, options.returns, options.vicinity))
            candidates.push_back(std::move(guess));
    }
    for (std::int64_t i = 0; i < options.starts && !stopped(options); ++i) {
        const Draws draws(options.seed, static_cast<std::uint64_t>(k), static_cast<std::uint64_t>(i));
        const auto skip = static_cast<int>(4 * draws.u[7]);
        CyclePoints guess = states_from(map, random_section_point(scene, draws), skip, k);
        if (!guess.empty()) candidates.push_back(std::move(guess));
    }
    return candidates;
}

}  // namespace swirl::apps
