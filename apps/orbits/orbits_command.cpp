#include "apps/orbits/orbits_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/studies/cycles/near_orbit.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"
#include "map/orbit/orbit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <tuple>

namespace swirl::apps::orbits {

const char* const orbits_details =
    R"(Lists fixed points and cycles of the collision map, stable and unstable, each once.
  period 1        all fixed points through impacts alone with a flight time up to --max-time, from two
                  equations in closed form (`swirl describe`), each confirmed by the map; bodies that
                  stay on the wall have no impacts and are none of these (`swirl classify` names them)
  longer periods  and cycles through contact: multi-shooting with exact derivatives, from close returns
                  of trajectories and from random section points, polished to rounding; where that
                  fails, as near grazing, the impacts' times are unknowns, too
How often each cycle was found tells how many were missed (Chao 1984): at least that many, if some are harder to find than
others. --complete searches on, twice as long each time, until the estimate is none and nothing new came; cycles to which
fewer than 3 in n candidates lead may be missing all the same.

Multipliers are those of DF^k; index is the number of them outside the unit circle. A family (the disk at e = 1, conserved
J or S) is listed once, with its tangent; --pin S=VALUE or --pin tau=VALUE gives its member there. --near finds the nearest
of the cycles beside a point, from that point and from clouds about it, and says how far it is. If interrupted, the cycles
that were found are kept.

The table numbers the cycles. In a record (-o) `swirl show`, `swirl continue RECORD --orbit I`, `swirl certify RECORD
--orbit I` and `swirl animate RECORD --orbit I` know them by these numbers.

Examples:
  swirl orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --period 1
  swirl orbits --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --near=-0.08,0.03,-0.55,0.89,-0.98
  swirl orbits --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --period 1 --pin tau=2.5)";

void OrbitsOptions::add_to(Flags& command) {
    constexpr std::int64_t most = 100'000'000;
    scene.add_to(command);
    output.add_to(command);
    add_whole_number(command, "--period", period, "K", 1, 256, "cycles of this period (default 1)");
    add_whole_number(command, "--max-period", max_period, "K", 1, 256, "cycles of all periods up to this");
    command.add_option("--max-time", longest, "T",
                       "longest flight time of fixed points, in 1/omega_s (SI units: s; default 12/omega_s)");
    command.add_flag("--complete", complete, "search on until no cycle seems to be missing");
    command.add_flag("--stable", stable, "list attracting cycles alone: all multipliers inside the unit circle");
    add_whole_number(command, "--most-starts", most_starts, "R", 1, most,
                     "random section points per period after which --complete gives up (default 200000)");
    command.add_option("--near", near, "", "psi,chi,vn,vt,S: the cycle near this point (a disk drops chi)");
    command
        .add_option("--pin", pin, "",
                    "S=VALUE or tau=VALUE (SI units: s): members of families with this S or return time")
        ->offer({"S=", "tau="});
    add_whole_number(command, "--starts", candidates.starts, "R", 0, most,
                     "random section points per period (default 1500)");
    add_whole_number(command, "--trajectories", candidates.trajectories, "R", 0, most,
                     "orbits searched for close returns (default 16)");
    add_whole_number(command, "--collisions", candidates.collisions, "K", 1, most,
                     "impacts of each of them (default 2000)");
    add_seed(command, candidates.seed, "of the random starts (default 1)");
}

std::pair<int, int> OrbitsOptions::periods() const {
    if (period > 0 && max_period > 0) throw BadInput("--period and --max-period are both given; give one");
    if (max_period > 0) return {1, max_period};
    return {std::max(period, 1), std::max(period, 1)};
}

namespace {

FindOptions find_options_of(const OrbitsOptions& options) {
    FindOptions find;
    find.candidates = options.candidates;
    std::tie(find.first_period, find.last_period) = options.periods();
    find.max_time = options.max_time;
    find.complete = options.complete;
    find.most_starts = options.most_starts;
    find.control = run_control(options.output);
    return find;
}

/// --near. @throws BadInput unless it leaves the wall
std::optional<SectionPoint<double>> near_point(const OrbitsOptions& options, const Scene<double>& scene) {
    if (options.near.empty()) return std::nullopt;
    const auto z = section_point_from<double>("--near", options.near, scene.is_disk());
    require_leaving(make_body(scene), z);
    return z;
}

/// --stable.
void leave_out_others(FoundOrbits& found) {
    const auto left_out = std::erase_if(
        found.cycles, [](const analysis::Cycle& c) { return c.stability != analysis::Stability::stable; });
    if (left_out > 0)
        found.limits.push_back(fmt::format("{} cycle{} left out, as not all multipliers lie inside the unit circle",
                                           left_out, left_out == 1 ? " is" : "s are"));
}

/// A polygon's cycles with friction, and any with e < 1, are isolated, but for psi where there is no swirl.
void require_families(const OrbitsOptions& options, const Scene<double>& scene) {
    const bool isolated = scene.acts_in_flight() || scene.restitution < 1 || (!scene.is_disk() && scene.mu > 0);
    if (!options.pin.empty() && isolated && scene.beta > 0)
        throw BadInput(fmt::format(
            "pin = {}: it takes members of families, and this scene has none (a disk has, or mu = 0, both at e = 1)",
            options.pin));
}

/// What no combination of flags or no range allows.
void check(const OrbitsOptions& options) {
    options.periods();
    if (!options.pin.empty() && !options.near.empty()) throw BadInput("--pin and --near are both given; give one");
    if (options.complete && !options.near.empty()) throw BadInput("--complete and --near are both given; give one");
}

}  // namespace

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

int orbits(OrbitsOptions& options) {
    options.scene.read_file(options.output.quiet);
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
    options.max_time = options.scene.longest_flight(options.longest, 12, 1e4);
    options.near = point_without_units(options.near, options.scene.units());
    if (options.pin.starts_with("tau="))
        options.pin = range_without_units(options.pin, options.scene.units(), "1/omega_s");
    check(options);
    const std::optional<Pin> pin = pin_from(options.pin);
    require_families(options, scene);
    const auto near = near_point(options, scene);
    options.candidates.accuracy = options.output.accuracy();
    const auto map = shooting_map_of(scene, options.candidates.accuracy);
    std::optional<RecordWriter> record =
        open_record(options.output, "Cycles of a swirled polygon", {options.scene.file()}, options.scene.units());
    note_interruptions();
    const auto [first, last] = options.periods();
    FoundOrbits found = near ? find_near(scene, map, options.candidates.accuracy, *near, first, last, interruption())
                             : find_orbits(scene, map, find_options_of(options));
    found.accuracy = options.candidates.accuracy;
    for (const ShortOrbit& orbit : found.too_short)
        found.limits.push_back(
            fmt::format("period {}: the orbit from --near ends after {} impacts", orbit.period, orbit.impacts));
    if (pin) pin_families(scene, map, *pin, found);
    const bool as_asked = !near ? !found.wants_more() : !found.cycles.empty();
    if (options.stable) leave_out_others(found);
    found.interrupted = is_interrupted();
    finish_up();
    if (record) write_orbits_record(*record, options, scene, found);
    if (options.output.json)
        write_orbits_document(options, scene, found);
    else if (!options.output.quiet)
        print_orbits(options, scene, found);
    if (found.interrupted) return exit_interrupted;
    return as_asked ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::orbits
