#include "apps/orbits/candidates.hpp"

#include "apps/command_line/start_options.hpp"
#include "apps/system/orbit_ending.hpp"

#include <Random123/philox.h>
#include <fmt/format.h>
#include <Random123/uniform.hpp>
#include <boost/math/tools/toms748_solve.hpp>

#include <algorithm>
#include <cmath>

namespace swirl::apps::orbits {

namespace {

using analysis::CyclePoints;

/// A closed form and its flight time.
struct SteadyGuess {
    double tau = 0;
    Eigen::VectorXd point;
};

/// The closed form of a steady mode at e = 1, with spin S.
Eigen::VectorXd steady_point(const Scene<double>& scene, double tau, double spin) {
    const double radius = scene.beta + 1 - scene.alpha;
    const double half = std::sin(0.5 * tau);
    return coordinates_of({0, 0, -2 * radius / tau * half * half, radius * std::sin(tau) / tau, spin}, scene.is_disk());
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

double last_tau(const Scene<double>& scene) {
    return std::min(longest_flight(scene), longest_tau);
}

constexpr double tau_step = 0.05;
constexpr double fastest_spin = 5;  // without friction S is free: that of what a user may see
constexpr int least_j = -4, most_j = 8;
constexpr std::size_t most_guesses = 1'000'000;
constexpr std::size_t plenty = 300;       // of guesses: from then on only those that clear the wall are tried
constexpr std::size_t most_tried = 3000;  // of those that are guesses only, e < 1

std::vector<SteadyGuess> guesses_on_grid(const Scene<double>& scene, bool no_slip) {
    std::vector<SteadyGuess> guesses;
    for (double tau = tau_step; tau < last_tau(scene); tau += tau_step) {
        if (no_slip) {
            guesses.push_back({tau, steady_point(scene, tau, spin_without_slip(scene, tau))});
            continue;
        }
        if (scene.is_disk()) {  // any S will do
            guesses.push_back({tau, steady_point(scene, tau, 0)});
            continue;
        }
        for (int j = least_j; j <= most_j; ++j) {
            const double spin = 1 - 2 * pi<double>() * j / (scene.sides * tau);
            if (std::abs(spin) <= fastest_spin) guesses.push_back({tau, steady_point(scene, tau, spin)});
        }
    }
    return guesses;
}

/// Roots τ of Nτ(1 − S(τ))/2π = j for every whole j.
std::vector<SteadyGuess> guesses_of_polygon(const Scene<double>& scene) {
    const double turns = scene.sides / (2 * pi<double>());
    const auto vertices_on = [&](double tau) { return turns * tau * (1 - spin_without_slip(scene, tau)); };
    std::vector<SteadyGuess> guesses;
    // Steps so short that two roots in one, about an extremum, are rare; from where u_n = Rτ/2 is an impact at all.
    const auto step_from = [](double tau) { return std::min(1e-3, 0.1 * tau); };
    double begin = 2e-6, last = vertices_on(begin);
    while (begin < last_tau(scene) && guesses.size() < most_guesses) {
        const double tau = begin + step_from(begin);
        const double next = vertices_on(tau);
        const double low = std::min(last, next), high = std::max(last, next);
        for (double j = std::ceil(low); j <= high && guesses.size() < most_guesses; ++j) {
            std::uintmax_t most = 100;
            const auto gap = [&](double t) { return vertices_on(t) - j; };
            if (gap(begin) * gap(tau) > 0) continue;
            const auto root =
                boost::math::tools::toms748_solve(gap, begin, tau, boost::math::tools::eps_tolerance<double>(50), most);
            guesses.push_back({root.first, steady_point(scene, root.first, 1 - j / (turns * root.first))});
        }
        last = next;
        begin = tau;
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
    return coordinates_of(z, scene.is_disk());
}

bool stopped(const CandidateOptions& options) {
    return options.stop && options.stop();
}

/// k states after `skip` impacts from z; empty if the map ends.
CyclePoints states_from(const analysis::ShootingMap& map, const Eigen::VectorXd& z, int skip, int k) {
    const CyclePoints orbit = analysis::orbit_from(map, z, 0, skip + k);
    return orbit.empty() ? orbit : CyclePoints(orbit.begin() + skip, orbit.end());
}

/// Guesses whose flight is that of the map: no other vertex in between, whatever e and the impact are. A microsecond
/// each.
std::vector<CyclePoints> clearing(const Scene<double>& scene, const std::vector<SteadyGuess>& guesses) {
    constexpr double same_time = 1e-6;
    return with_collision_map(scene, [&](const auto& map) {
        std::vector<CyclePoints> clear;
        for (const auto& guess : guesses) {
            const auto collision = map.advance(post_impact_state(section_point_of(guess.point)));
            if (collision.outcome == FirstContactOutcome::contact &&
                std::abs(collision.flight_time - guess.tau) < same_time)
                clear.push_back({guess.point});
        }
        return clear;
    });
}

/// At most so many, evenly taken.
std::vector<CyclePoints> thinned(const std::vector<CyclePoints>& all, std::size_t most) {
    std::vector<CyclePoints> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(all[i * all.size() / most]);
    return some;
}

}  // namespace

SteadyGuesses steady_guesses(const Scene<double>& scene) {
    SteadyGuesses guesses;
    const bool on_grid = scene.mu == 0 || scene.is_disk();
    const auto all = on_grid ? guesses_on_grid(scene, scene.mu > 0) : guesses_of_polygon(scene);
    if (all.size() > plenty)
        guesses.points = clearing(scene, all);
    else
        for (const auto& guess : all) guesses.points.push_back({guess.point});
    if (scene.restitution < 1 && guesses.points.size() > most_tried) {
        guesses.limits.push_back(fmt::format("of {} steady modes of the elastic scene {} are tried as guesses",
                                             guesses.points.size(), most_tried));
        guesses.points = thinned(guesses.points, most_tried);
    }
    if (longest_flight(scene) > longest_tau)
        guesses.limits.push_back(
            fmt::format("steady modes are sought up to tau = {:g}; there may be longer ones, up to {:g}", longest_tau,
                        longest_flight(scene)));
    if (scene.mu == 0 && !scene.is_disk())
        guesses.limits.push_back(
            fmt::format("without friction S is free: steady modes are sought for |S| <= {:g}, j = {} to {}",
                        fastest_spin, least_j, most_j));
    if (all.size() >= most_guesses)
        guesses.limits.push_back(fmt::format("only the first {} steady modes are tried", most_guesses));
    return guesses;
}

std::vector<CyclePoints> trajectories_of(const Scene<double>& scene, const CandidateOptions& options) {
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
                    return static_cast<std::int64_t>(points.size()) < options.collisions && !stopped(options);
                };
                for (bool alive = begin.impacts > 0; alive && goes_on();) {
                    points.emplace_back(map.coordinates(begin.state));
                    const auto step = map.advance(begin.state);
                    alive = step.alive;
                    begin.state = step.state;
                }
                trajectories.push_back(std::move(points));
            }
            return trajectories;
        },
        horizon);
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

}  // namespace swirl::apps::orbits
