#include "apps/orbits/orbits_command.hpp"

#include "analysis/cycles/family.hpp"
#include "analysis/cycles/known_cycles.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/system/section_coordinates.hpp"
#include "apps/system/shooting_map.hpp"
#include "map/orbit/orbit.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl::apps::orbits {

const char* const orbits_details =
    R"(Fixed points and cycles of the collision map, stable and unstable, each once: solved by multi-shooting with exact
derivatives from the steady modes' closed form (period 1), close returns of trajectories and random section points, then
polished to rounding; where that fails, as near grazing, with the impacts' times as unknowns. Multipliers are those of
DF^k; index: how many lie outside the unit circle. A family (the disk at e = 1, conserved J or S) is given once, with its
tangent; --pin S=VALUE or --pin tau=VALUE gives its members there. An empty list means that no candidate led to a cycle: more
--starts may. --near gives the nearer of the cycles that the map and the impacts' times as unknowns lead to, and how far it
is: near grazing start nearer than the reciprocal of the multiplier. Interrupted, it gives the cycles that were found.

Examples:
  swirl orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --period 1
  swirl orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --near=-0.08,0.03,-0.55,0.89,-0.98
  swirl orbits --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --period 1 --pin tau=2.5)";

void OrbitsOptions::add_to(CLI::App& command) {
    constexpr std::int64_t most = 100'000'000;
    scene.add_to(command);
    output.add_to(command);
    command.add_option("--period", period, "cycles of this period (default 1)")
        ->type_name("K")
        ->check(CLI::Range(1, 256));
    command.add_option("--max-period", max_period, "cycles of all periods up to this")
        ->type_name("K")
        ->check(CLI::Range(1, 256));
    command.add_option("--near", near, "psi,chi,vn,vt,S: the cycle near this point (a disk drops chi)")->type_name("");
    command.add_option("--pin", pin, "S=VALUE or tau=VALUE: members of families with this S or return time")
        ->type_name("");
    command.add_option("--starts", candidates.starts, "random section points per period (default 1500)")
        ->type_name("R")
        ->check(CLI::Range(std::int64_t{0}, most));
    command.add_option("--trajectories", candidates.trajectories, "orbits searched for close returns (default 16)")
        ->type_name("R")
        ->check(CLI::Range(std::int64_t{0}, most));
    command.add_option("--collisions", candidates.collisions, "impacts of each of them (default 2000)")
        ->type_name("K")
        ->check(CLI::Range(std::int64_t{1}, most));
    add_seed(command, candidates.seed, "of the random starts (default 1)");
}

std::pair<int, int> OrbitsOptions::periods() const {
    if (period > 0 && max_period > 0) throw BadInput("--period and --max-period are both given; give one");
    if (max_period > 0) return {1, max_period};
    return {std::max(period, 1), std::max(period, 1)};
}

namespace {

constexpr double accepted = 1e-11;   // residual of a cycle; those found end near 10⁻¹⁵
constexpr double same_cycle = 1e-6;  // nearer ones are one

struct Pin {
    bool by_time = false;
    double value = 0;
};

std::optional<Pin> pin_from(const std::string& text) {
    if (text.empty()) return std::nullopt;
    const auto equals = text.find('=');
    const std::string name = text.substr(0, equals);
    if (equals == std::string::npos || (name != "S" && name != "tau"))
        throw BadInput(fmt::format("pin = {}: S=VALUE or tau=VALUE is wanted", text));
    const double value = number_from<double>("pin", text.substr(equals + 1));
    if (!std::isfinite(value) || (name == "tau" && value <= 0))
        throw BadInput(fmt::format("pin = {} is outside its range: S finite, tau > 0", text));
    return Pin{name == "tau", value};
}

double pinned_value(const analysis::CurvePoint& point, bool by_time) {
    return by_time ? point.shooting.duration : point.points.front()[point.points.front().size() - 1];
}

/// Replaces the families by their members where S or the return time has the value.
void pin_families(const analysis::ShootingMap& map, const Pin& pin, FoundOrbits& found) {
    analysis::KnownCycles members(map, 0, 1e-7, false);
    for (const auto& cycle : found.cycles) {
        if (cycle.tangents.cols() > 1)
            found.limits.push_back(
                "a family of more than one parameter has no single member with that value: left out");
        if (cycle.tangents.cols() != 1) continue;
        const auto family = analysis::walk_family(map, 0, cycle);
        const auto value = [&](const analysis::CurvePoint& point) { return pinned_value(point, pin.by_time); };
        for (const auto& points : analysis::pinned_members(map, family, value, pin.value))
            members.add(points, analysis::shooting_residual(map, points, 0).residual());
    }
    found.cycles = members.completed();
}

/// What is said of a point whose orbit has not k impacts.
std::string ends_early(const analysis::ShootingMap& map, const Eigen::VectorXd& near, int k) {
    int steps = 0;
    auto step = map.step(near, 0);
    for (; step.alive; ++steps) step = map.step(step.state, 0);
    return fmt::format("period {}: the orbit from --near ends after {} impacts", k, steps);
}

/// How far a solution's cycle comes from a point; +∞ if none was found.
double distance_of(const analysis::ShootingMap& map, const analysis::ShootingResult& shot,
                   const Eigen::VectorXd& near) {
    double nearest = std::numeric_limits<double>::infinity();
    if (shot.converged)
        for (const auto& point : shot.points) nearest = std::min(nearest, map.distance(point, near));
    return nearest;
}

/// The nearer of the cycles that the map and the impacts' times lead to: near grazing the map's steps may lead far
/// away.
analysis::ShootingResult solve_near(const analysis::ShootingMap& map, const analysis::TimedMap& timed,
                                    const analysis::CyclePoints& guess) {
    const auto plain = analysis::solve_shooting(map, guess, 0, accepted);
    auto with_times = analysis::solve_near_grazing(map, timed, guess, 0, accepted);
    const double left = distance_of(map, plain, guess.front()), nearer = distance_of(map, with_times, guess.front());
    // Both to rounding on one cycle: the map's own.
    return nearer < left - same_cycle ? with_times : plain;
}

FoundOrbits find_near(const OrbitsOptions& options, const Scene<double>& scene, const analysis::ShootingMap& map) {
    const auto z = section_point_from<double>("--near", options.near, scene.is_disk());
    require_leaving(make_body(scene), z);
    const Eigen::VectorXd near = coordinates_of(z, scene.is_disk());
    FoundOrbits found;
    const auto timed = timed_map_of(scene);
    analysis::KnownCycles known(map, 0, same_cycle, false);
    const auto [first, last] = options.periods();
    for (int k = first; k <= last; ++k) {
        if (is_interrupted()) break;
        const auto guess = analysis::orbit_from(map, near, 0, k);
        if (guess.empty()) {
            found.limits.push_back(ends_early(map, near, k));
            continue;
        }
        ++found.tried;
        const auto shot = solve_near(map, timed, guess);
        found.iterations = shot.iterations;
        found.reached = shot.residual;
        const auto points = analysis::minimal_cycle(map, shot.points, same_cycle);
        if (!shot.converged || static_cast<int>(points.size()) != k) continue;
        ++found.converged;
        known.add(points, shot.residual);
    }
    found.cycles = known.completed();
    for (const auto& cycle : found.cycles)
        for (const auto& point : cycle.points) found.distance = std::min(found.distance, map.distance(point, near));
    return found;
}

FoundOrbits find_all(const OrbitsOptions& options, const Scene<double>& scene, const analysis::ShootingMap& map) {
    FoundOrbits found;
    found.none_exist = is_dissipative_without_drive(scene);
    if (found.none_exist) return found;
    const auto timed = timed_map_of(scene);
    const auto [first, last] = options.periods();
    const auto trajectories = trajectories_of(scene, options.candidates);
    for (int k = first; k <= last && !found.interrupted; ++k) {
        const auto candidates = candidates_for(scene, map, k, trajectories, options.candidates);
        if (k == 1) found.limits = steady_guesses(scene).limits;
        Progress progress(fmt::format("orbits of period {}", k), static_cast<double>(candidates.size()),
                          options.output.quiet);
        analysis::SearchOptions search;
        search.period = k;
        search.accept = accepted;
        search.timed = &timed;
        search.threads = options.output.threads;
        search.progress = [&](double done) { progress.at(done); };
        search.stop = is_interrupted;
        const auto result = analysis::find_cycles(map, 0, candidates, search);
        found.tried += result.tried;
        found.converged += result.converged;
        found.interrupted = is_interrupted();
        found.cycles.insert(found.cycles.end(), result.cycles.begin(), result.cycles.end());
    }
    return found;
}

}  // namespace

FamilyRange range_of(const analysis::ShootingMap& map, const analysis::Cycle& cycle) {
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

double mean_spin_per_impact(const analysis::Cycle& cycle) {
    double sum = 0;
    for (const auto& z : cycle.points) sum += z[z.size() - 1];
    return sum / static_cast<double>(cycle.period());
}

int orbits(OrbitsOptions& options) {
    options.scene.read_file();
    const Scene<double> scene = options.scene.scene<double>();
    if (options.output.accuracy() != Accuracy::double_precision)
        throw BadInput(fmt::format("accuracy = {}: orbits works in double", options.output.accuracy_name));
    options.periods();
    const std::optional<Pin> pin = pin_from(options.pin);
    if (pin && !options.near.empty()) throw BadInput("--pin and --near are both given; give one");
    const auto map = shooting_map_of(scene);
    std::optional<RecordWriter> record =
        open_record(options.output.record, "Cycles of a swirled polygon", options.scene.units());
    note_interruptions();
    options.candidates.stop = is_interrupted;
    FoundOrbits found = options.near.empty() ? find_all(options, scene, map) : find_near(options, scene, map);
    if (pin) pin_families(map, *pin, found);
    found.interrupted = is_interrupted();
    if (record) write_orbits_record(*record, options, scene, found);
    if (options.output.json)
        write_orbits_document(options, scene, found);
    else if (!options.output.quiet)
        print_orbits(scene, found);
    if (found.interrupted) return exit_interrupted;
    return !options.near.empty() && found.cycles.empty() ? exit_numerical_ending : exit_done;
}

}  // namespace swirl::apps::orbits
