#include "apps/bifurcate/bifurcate_command.hpp"

#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/classify_flags.hpp"
#include "apps/modes/risk_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <variant>

namespace swirl::apps::bifurcate {

const char* const bifurcate_details =
    R"(Samples the attractors at every value of a parameter: S after each impact (or another coordinate), after a transient, from
R random starts (start r is that of `swirl classify --seed SEED+r`). --follow also follows the attractor from column to
column, upwards and downwards (hysteresis). The mode is the verdict of `swirl classify` on these impacts, or on as many as
it takes itself where they leave an orbit undecided. An orbit that settles on a cycle is sampled over one period, once it is
on it but for rounding. A column's mode and period are those of most of its starts.

--risk P calls chaos of the random starts early where all of a column are chaotic and their mean exponent is large enough
that less than a share P of such starts has another verdict at the limits (95 %): a random sample, followed to them, tells
how large. Samples of it are the last third of the impacts that were followed.

--branches continues every cycle found (period <= --longest-branch) over the whole range, stable or not, names its special
points, and says how well samples and stable branches agree. If interrupted, the finished orbits are kept. `swirl plot`
draws the record.

Examples:
  swirl bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.35:0.42:15 --starts 2
  swirl bifurcate --sides 6 --beta 0.5 --mu 0.5 --restitution 0.95 --along alpha=0.36:0.4:9 --branches -o diagram.h5)";

void BifurcateOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    command
        .add_option("--along", along, "",
                    "NAME=A:B:COUNT, NAME=A:B:COUNT:log or NAME=V,V,...: " + parameters_in_words(RangesOver::scenes))
        ->offer(parameters_to_offer(RangesOver::scenes));
    command.add_option("--observable", observable, "", "S (default), psi, chi, vn or vt: values are listed beside S")
        ->offer({"S", "psi", "chi", "vn", "vt"});
    add_whole_number(command, "--starts", starts, "R", 0, 1'000'000, "random starts per column (default 4)");
    add_tail_flags(command, settings,
                   {"impacts before those that are kept, at most (default 2500)",
                    "impacts that are kept, at most; 64 or more (default 500)", 1'000'000'000});
    add_risk_flags(command, risk, error);
    command.add_flag("--follow", follow, "follow the attractor upwards and downwards too");
    command.add_flag("--branches", branches, "continue every cycle that was found");
    add_whole_number(command, "--longest-branch", longest_branch, "K", 1, 128,
                     "longest period that --branches continues (default 12)");
}

DiagramSettings settings_of(const BifurcateOptions& options, const ParameterRange& along) {
    SceneOptions scene = options.scene;
    scene.set(along.name, fmt::format("{:.17g}", along.low));
    return {scene.scene<double>(Extensions::followed),
            along,
            options.settings,
            options.start.speed(),
            options.start.seed(),
            options.starts,
            options.longest_branch,
            options.risk,
            options.error};
}

namespace {

void check(const BifurcateOptions& options, const ParameterRange& along) {
    constexpr const char* names[] = {"S", "psi", "chi", "vn", "vt"};
    if (std::find(std::begin(names), std::end(names), options.observable) == std::end(names))
        throw BadInput(fmt::format("observable = {} is none of: S, psi, chi, vn, vt", options.observable));
    if (!options.start.is_random())
        throw BadInput("a diagram's starts are random: give --speed and --seed, not --x … or --point");
    options.start.require_one_way();
    check_risk(options.risk, options.error, options.settings.exhaustive);
    if (options.starts == 0 && !options.follow) throw BadInput("starts = 0 needs --follow");
    const DiagramSettings settings = settings_of(options, along);
    options.scene.require_inertia_along(settings.scene, along.parameter);
    for (const double value : {along.low, along.high}) {
        const Scene<double> scene = column_scene(settings, value);
        if (scene.is_disk() && options.observable == "chi") throw BadInput("observable = chi: a disk has none");
        flight_from(make_body(scene), std::get<LabStart<double>>(column_start(settings, scene, 0)));
    }
}

/// What is to be done; nothing is yet. @throws BadInput
Diagram plan(BifurcateOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    options.settings.accuracy = options.output.accuracy();
    Diagram diagram;
    diagram.along = parameter_range_from(options.along, true, false);
    check(options, diagram.along);
    for (const double value : diagram.along.columns) diagram.columns.push_back({value, true, {}, {}});
    return diagram;
}

std::string interruption_in_words(const Diagram& diagram, const std::string& record) {
    const auto whole = std::count_if(diagram.columns.begin(), diagram.columns.end(),
                                     [](const DiagramColumn& column) { return column.complete; });
    return fmt::format("swirl: interrupted; {} of {} columns are whole{}", whole, diagram.along.columns.size(),
                       record.empty() ? "" : fmt::format(", and what is done is in '{}'", record));
}

int draw_diagram(BifurcateOptions& options, HandOut& hand_out) {
    Diagram diagram = plan(options);
    require_output(options.output, {options.scene.file()});
    require_creatable(options.output);
    note_interruptions();
    const auto begin = std::chrono::steady_clock::now();
    sample_columns(options, diagram, hand_out);
    const DiagramSettings settings = settings_of(options, diagram.along);
    const RunControl control = run_control(options.output);
    if (options.follow) follow_columns(settings, control, diagram);
    keep_finished(diagram);
    find_steady_modes(settings, control, diagram);
    if (options.branches && !is_interrupted()) continue_attractors(settings, control, diagram);
    diagram.interrupted = is_interrupted();
    finish_up();
    if (!options.output.record.empty()) {
        RecordWriter record =
            create_record(options.output, "Attractors of a swirled polygon over one parameter", options.scene.units());
        write_diagram_record(record, options, diagram);
    }
    if (options.output.json)
        write_diagram_document(options, diagram);
    else if (!options.output.quiet)
        print_diagram(options, diagram);
    if (diagram.interrupted && !options.output.quiet)
        report(interruption_in_words(diagram, options.output.record));
    else if (!options.output.quiet && !options.output.json)
        report(fmt::format("swirl: {:.2f} s",
                           std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count()));
    return diagram.interrupted ? exit_interrupted : exit_done;
}

}  // namespace

int bifurcate(BifurcateOptions& options) {
    return on_all_ranks(
        options.output.quiet, options.output.threads, [&] { return work_of(options, plan(options)); },
        [&](HandOut& hand_out) { return draw_diagram(options, hand_out); });
}

}  // namespace swirl::apps::bifurcate
