#include "apps/describe/describe_command.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/special_values.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/record_files.hpp"

#include <fmt/format.h>

#include <optional>

namespace swirl::apps::describe {

const char* const describe_details =
    R"(Says what follows from the scene's numbers alone: how far chi reaches (chi_m), the friction from which sliding can jam
(Painleve), how far from the wall's reach the body can be, whether impacts can last, and all steady modes (fixed points of
the collision map) with a flight time up to --max-time, from two equations in closed form, each confirmed by the map.
Bodies that stay on the wall have no impacts and are none of these: listed apart is where a polygon rests on two vertices and
turns with the swirl (S = 1), to which impacts may lead if e < 1; `swirl classify` names it two-vertex.
  +, -  branch: on the outer side of the container's wall (psi near 0), on the inner one (psi near pi)
  j     vertices from impact to impact, which fix S = 1 - 2 pi j/(N tau)
A mode is stable if all its multipliers lie inside the unit circle. With e = 1 a disk, and anything without friction, has
families over tau; `swirl orbits --pin tau=VALUE` and `swirl continue --along tau=A:B` give their members. A disk on the
wall is a pendulum: psi'' = -k sin psi.

The table also lists a polygon's chords of e = 1 with friction: the centre runs to and fro along one without slip, at an
angle a to the wall's normal (a diameter if a = 0). A small swirl feeds those whose fate is `accelerates` (a diameter: J
grows as (3/4 K beta^2 n)^(1/3) after n impacts, for ever) or `limit` (up to the speed v*, where S = S*). They attract if
|pair| < 1. With e < 1 the loss of impacts balances a diameter's gain at J*.

Of a floor that drags (--drag) it says what is known of that alone: whether and on which circle a body rides along with a
dish that it does not touch, and whether a disk on the wall rolls locked to the swirl: (gamma + kappa gamma_r) rho <= beta
(on a table, beta sqrt(1 + gamma^2)), rho = 1 - alpha. Its steady modes solve three equations, and are looked for on a grid
(|S| <= 10): each is confirmed by the map, but some may be missed.

Examples:
  swirl describe --sides disk --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.5 --drag 0.2
  swirl describe --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9
  swirl describe --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1)";

void DescribeOptions::add_to(Flags& command) {
    scene.add_to(command);
    output.add_to(command);
    command.add_option("--max-time", longest, "T",
                       "longest flight time of steady modes, in 1/omega_s (SI units: s; default 12/omega_s)");
}

namespace {

void add_chords(Description& d) {
    const Chords all = chords_of(d.scene);
    d.has_all_chords = all.complete;
    for (const Chord& chord : all.chords) {
        const ChordSpeeds speeds = chord_speeds(d.scene, chord);
        const bool diameter = chord.is_diameter();
        const std::optional<double> balanced = diameter ? balanced_speed(d.scene, chord) : std::nullopt;
        d.chords.push_back({chord, speeds, diameter && chord.attracts() ? diameter_growth(d.scene) : analysis::nan,
                            balanced ? 0.5 * *balanced * *balanced : analysis::nan,
                            speeds.fate == ChordFate::limit ? speeds.limit_spin : analysis::nan});
    }
}

}  // namespace

Description description_of(const Scene<double>& scene, double max_time) {
    SteadyOptions search;
    search.longest_flight = max_time;
    Description d{scene, search, scene_facts(scene), steady_modes(scene, search), {}, {}, true, edge_rests(scene), {}};
    for (SteadyMode& mode : d.steady.modes) analysis::sort_multipliers(mode.multipliers);
    for (const SteadyFamily& family : d.steady.families)
        d.families.push_back({family, member_of(scene, family, 0.5 * (family.from + family.to))});
    d.none_exist = why_none(d.steady.set);
    add_chords(d);
    return d;
}

int describe(DescribeOptions& options) {
    options.scene.read_file(options.output.quiet);
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
    without_dry_floor(without_rounding(scene, "describe"), "describe");
    options.output.require_double("describe works in double");
    options.max_time = options.scene.longest_flight(options.longest, 12, 1e4);
    std::optional<RecordWriter> record = open_record(options.output, "What is known of a swirled polygon",
                                                     {options.scene.file()}, options.scene.units());
    exit_when_interrupted();
    if (scene.has_drag()) return describe_floor(options, scene, record);
    const Description d = description_of(scene, options.max_time);
    const Settings settings = {{"max_time", options.max_time},
                               {"fastest_spin", d.search.fastest_spin},
                               {"accuracy", options.output.accuracy_name}};
    if (record) {
        write_description_record(record->root(), d, settings);
        record->finish();
    }
    if (options.output.json)
        write_description_document(options, d, settings);
    else if (!options.output.quiet)
        print_description(d, options.scene.units());
    return exit_done;
}

}  // namespace swirl::apps::describe
