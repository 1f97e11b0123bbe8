#include "apps/ramp/ramp_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "map/orbit/orbit.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <string>
#include <variant>

namespace swirl::apps::ramp {

const char* const ramp_details =
    R"(Follows one orbit while a parameter of the scene changes slowly from A to B, with --down back to A, with --cycles K so
there and back K times: the hysteresis loop as a bench sees it. The parameter is linear in time; a flight has the value of
the impact that it began with, so that it is behind by the rate times the flight's duration at most (`lag`).

beta, mu, restitution, tangential-restitution and drag can be changed while the body moves. alpha, sides, corner and
inertia-factor change the body itself, and omega_s is the unit of time: these are refused.

Each way has N windows. Of each: the time mean of S with its standard error along the orbit (none where it drifts), and the
period that it kept all through, by impacts, chatter that lands counted as one: k is kept where the orbit comes back to
within D after k impacts, eight rounds and 32 impacts in a row. D must be above what the ramp moves the mode by in a round. Modes are listed with the value of the parameter at which
they were left: where the orbit did not come back.

--branches continues each cycle that was kept over A:B and says at which special point its branch ends on the way, and how
far beyond it the mode was left. Beyond a fold that delay goes to 2.338 (rate T)^(2/3) |a b|^(-1/3) for slow ramps, T the
duration of a round, a and b those of the fold's normal form; what it is with D is given beside.

An orbit may end before, as those of `swirl simulate` do (exit code 3). If interrupted, the windows so far are kept. `swirl
plot` draws the record; after a record of `bifurcate` over the same parameter both in one.

Examples:
  swirl ramp --sides 6 --alpha 0.4 --mu 0.5 --restitution 0.9 --along beta=0.374:0.384 --rate 1e-6 --down --windows 20 --branches
  swirl ramp --sides 6 --alpha 0.4 --beta 0.5 --restitution 0.9 --along mu=0.6:0.2 --duration 2000 --windows 10 -o ramp.h5)";

void RampOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command.add_option("--along", along, "", "NAME=A:B: beta, mu, restitution, tangential-restitution, drag")
        ->offer({"beta=", "mu=", "restitution=", "tangential-restitution=", "drag="});
    command.add_option("--rate", rate, "R", "|dp/dt|, per 1/omega_s (SI units: per s)");
    command.add_option("--duration", duration, "T", "of one way, in its place, in 1/omega_s (SI units: s)");
    command.add_flag("--down", down, "and back to A");
    add_whole_number(command, "--cycles", cycles, "K", 1, 10'000, "there and back K times");
    add_whole_number(command, "--windows", settings.windows, "N", 1, 1'000'000, "of each way (default 100)");
    add_whole_number(command, "--samples", settings.samples, "M", 1, 1'000'000,
                     "the last M impacts of a window go into the record (default 16)");
    add_whole_number(command, "--transient", settings.transient, "K", 0, 1'000'000'000,
                     "impacts at A before (default 2500)");
    add_whole_number(command, "--longest-period", settings.period.longest, "K", 1, 256,
                     "longest period that is looked for (default 16)");
    command.add_option("--tolerance", settings.period.tolerance, "D",
                       "a mode is left where its orbit does not come back to within D (default 0.001)");
    command.add_flag("--branches", branches, "continue the cycles that were kept, and compare");
    noise.add_to(command);
}

namespace {

std::string name_of_range(const std::string& along) {
    return along.substr(0, along.find('='));
}

/// The time of one way. @throws BadInput
double duration_of(const RampOptions& options, const ParameterRange& along) {
    if (options.rate && options.duration) throw BadInput("--rate and --duration are both given; give one");
    if (!options.rate && !options.duration) throw BadInput("--rate is missing: R, or --duration T, is wanted");
    const auto& given = options.rate ? options.rate : options.duration;
    const char* name = options.rate ? "rate" : "duration";
    if (!(*given > 0 && std::isfinite(*given)))
        throw BadInput(fmt::format("{} = {} is outside its range: {} > 0, finite", name, *given, name));
    if (options.duration) return without_units(*options.duration, options.scene.units(), "1/omega_s");
    const double duration = (along.high - along.low) / without_units(*options.rate, options.scene.units(), "omega_s");
    if (!(duration > 0 && std::isfinite(duration)))
        throw BadInput(fmt::format("rate = {}: one way takes {} / omega_s, no finite time", *options.rate, duration));
    return duration;
}

/// @throws BadInput, std::invalid_argument
RampSettings settings_of(RampOptions& options) {
    const std::string name = name_of_range(options.along);
    if (const std::string why = why_not_ramped(name); !why.empty())
        throw BadInput(fmt::format("along {}: {} can't be changed while the body moves: {}", options.along, name, why));
    RampSettings settings = options.settings;
    settings.along = parameter_range_from(options.along, false, false);
    if (options.down && options.cycles > 0) throw BadInput("--down and --cycles are both given; give one");
    settings.ways = options.cycles > 0 ? 2 * options.cycles : options.down ? 2 : 1;
    settings.duration = duration_of(options, settings.along);
    if (!(settings.period.tolerance > 0 && settings.period.tolerance < 1))
        throw BadInput(fmt::format("tolerance = {} is outside its range: above 0, below 1", settings.period.tolerance));
    for (const double end : {settings.along.low, settings.along.high}) {
        SceneOptions scene = options.scene;
        scene.set(settings.along.name, fmt::format("{:.17g}", end));
        settings.scene = scene.scene<double>(Extensions::followed);
    }
    settings.accuracy = options.output.accuracy();
    settings.noise = options.noise.noise(options.start, options.output);
    if (settings.scene.has_drag()) options.output.require_double("it is not extended to a floor that drags");
    if (settings.scene.has_dry_floor())
        options.output.require_double("it is not extended to a floor with dry friction");
    if (settings.scene.is_rounded()) options.output.require_double("it is not extended to rounded corners");
    if (settings.noise.is_any()) without_rounding(settings.scene, "noise at impacts");
    return settings;
}

/// Finds a bad start before any work.
Start<double> start_of(const RampOptions& options, const RampSettings& settings) {
    const Scene<double> scene = validated(with_parameter(settings.scene, *settings.along.parameter, settings.begin()));
    const Start<double> start = options.start.start<double>(scene);
    const auto body = make_body(scene);
    if (const auto* lab = std::get_if<LabStart<double>>(&start))
        flight_from(body, *lab);
    else
        require_leaving(body, std::get<SectionPoint<double>>(start));
    return start;
}

}  // namespace

int ramp(RampOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.noise.keep_seed_apart(options.start);
    options.start.take_from(options.scene);
    RampResult result{settings_of(options), {}, {}};
    const Start<double> start = start_of(options, result.settings);
    std::optional<RecordWriter> record = open_record(options.output, "A swirled polygon while a parameter changes",
                                                     {options.scene.file()}, options.scene.units());
    note_interruptions();
    const RunControl control = run_control(options.output);
    result.ramp = run_ramp(result.settings, start, control);
    if (options.branches) result.branches = continue_modes(result.settings, control, result.ramp);
    finish_up();
    if (record) write_ramp_record(*record, options, result);
    if (options.output.json)
        write_ramp_document(options, result);
    else if (!options.output.quiet)
        print_ramp(options, result);
    if (result.ramp.interrupted || is_interrupted()) return exit_interrupted;
    return result.ramp.outcome == Outcome::completed ? exit_done : exit_numerical_ending;
}

}  // namespace swirl::apps::ramp
