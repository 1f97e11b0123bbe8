#include "apps/continue/continue_command.hpp"

#include "analysis/cycles/cycle.hpp"
#include "analysis/cycles/multi_shooting.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/parameter_range.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/continue/beginning.hpp"
#include "apps/studies/cycles/near_orbit.hpp"
#include "apps/studies/scene_map/shooting_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace swirl::apps::continuation {

const char* const continue_details =
    R"(Follows a cycle over one parameter, both ways within A:B and through folds, by pseudo-arclength. The cycle is that near
--from, that of a RECORD of orbits, classify, describe, continue or bifurcate (--orbit I: row I, as `swirl show` numbers
them; in the record's scene), or what the scene's start settles on (--from attractor; exit code 3 if that is no cycle).
Special points are located to rounding and named: fold, flip, neimark-sacker, branch-point, and the map's borders
stick-slip, two-vertices, grazing, landing (border where none of these is seen), with the word on either side. A branch is
followed on where its word changes. At flips and branch points it is switched (--switch); a known branch is left out.

A branch begins or ends for one of these reasons:
  range          it leaves A:B
  closed         it comes back to its beginning
  border         it ends at a border of the map
  family         there is no curve over the parameter from there on
  halved         it ends at the flip of a cycle of half its period
  switched       it begins at another branch's special point
  not-converged  no cycle was found to go on with
  most-points    it has 20,000 points each way
  stopped        it was interrupted
--along S=A:B or tau=A:B follows a family (the disk at e = 1) along itself instead, by S or by its return time.

Normal forms: flip xi' = (-1 + a d) xi + b xi^3 (supercritical: b > 0), neimark-sacker z' = z e^(i theta)(1 + a d + b|z|^2)
(supercritical: Re b < 0), fold xi' = xi + a d + b xi^2.

Examples:
  swirl continue --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --from=-0.0839,0.028,-0.5542,0.8898,-0.9793 --along alpha=0.3:0.5
  swirl continue --sides disk --alpha 0.3 --beta 0.1 --mu 0.5 --restitution 1 --from=0,-0.43056,0.19151,-0.30504 --along tau=1:3
  swirl continue --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --from attractor --along alpha=0.39:0.41)";

void ContinueOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    add_file(command, "record", record, "RECORD.h5", "a record that holds the cycle, with its scene");
    add_whole_number(command, "--orbit", orbit, "I", 1, most_impacts, "which of the record's cycles, from 1");
    command
        .add_option(
            "--from", from, "",
            "psi,chi,vn,vt,S near a point of the cycle (a disk drops chi), or attractor: what the start settles on")
        ->offer({"attractor"});
    command.add_option("--along", along, "", "NAME=A:B: " + parameters_in_words(RangesOver::families))
        ->offer(parameters_to_offer(RangesOver::families));
    add_whole_number(command, "--period", its_period, "K", 1, 256, "of the cycle near that point (default 1)");
    add_whole_number(command, "--switch", switches, "DEPTH", 0, 16,
                     "how many flips and branch points to switch at one after another (default 1)");
    command.add_option("--longest-step", longest_step, "H", "along the branch, 1e-6 to 1 (default 0.02)");
}

namespace {

/// Over a parameter a cycle must be isolated, along itself it must be a member of a family of one parameter.
bool lies_on_curve(const Scene<double>& scene, Accuracy accuracy, const ParameterRange& along,
                   const analysis::CyclePoints& cycle) {
    const auto map = shooting_map_of(scene, accuracy);
    const auto shooting = analysis::shooting_residual(map, cycle, 0);
    return shooting.alive && analysis::family_directions(shooting, map.dimension).cols() == (along.parameter ? 0 : 1);
}

Settings settings_of(const ContinueOptions& options, const Beginning& beginning) {
    return {{"from", beginning.from},
            {"along", parameter_range_from(options.along, false, true).name},
            {"range", options.along},
            {"period", std::int64_t{beginning.period}},
            {"switch", std::int64_t{options.switches}},
            {"longest_step", options.longest_step},
            {"accuracy", options.output.accuracy_name}};
}

void write_document(const ContinueOptions& options, const Beginning& beginning, const SceneBranches& system,
                    const std::vector<analysis::Branch>& branches) {
    print_document([&](JsonWriter& json) {
        write_scene(json, beginning.scene, options.scene);
        write_branches(json, system, branches);
        write_json(json, "settings", settings_of(options, beginning));
    });
}

}  // namespace

int continue_orbit(ContinueOptions& options) {
    options.scene.read_file(options.output.quiet);
    options.from = point_without_units(options.from, options.scene.units());
    if (options.along.starts_with("tau="))
        options.along = range_without_units(options.along, options.scene.units(), "1/omega_s");
    const ParameterRange along = parameter_range_from(options.along, false, true);
    const Beginning beginning = beginning_of(options);
    const Scene<double>& scene = beginning.scene;
    if (options.record.empty()) options.scene.require_inertia_along(scene, along.parameter);
    const Accuracy accuracy = options.output.accuracy();
    if (!(options.longest_step >= 1e-6 && options.longest_step <= 1))  // NaN passes a range of the parser
        throw BadInput(fmt::format("longest-step = {:g} is outside its range: 1e-6 to 1", options.longest_step));
    if (along.parameter)
        for (const double end : {along.low, along.high}) validated(with_parameter(scene, *along.parameter, end));
    SceneBranches system = scene_branches(scene, along, accuracy, interruption());
    const double p = value_of(scene, along);
    if (along.parameter && (p < along.low || p > along.high))
        throw BadInput(fmt::format("{} = {:g} of the scene is outside the range of --along: {:g} to {:g}", along.name,
                                   p, along.low, along.high));
    system.options.longest_step = options.longest_step;
    system.options.first_step = std::min(1e-3, options.longest_step);
    if (!beginning.why_none.empty()) report(beginning.why_none);
    auto cycle = cycles::cycle_from({scene, beginning.points}, beginning.period, system.map, p);
    if (!cycle.empty() && !lies_on_curve(scene, accuracy, along, cycle)) {
        report(fmt::format("swirl: the cycle is {}",
                           along.parameter
                               ? "a member of a family: follow it by --along S=A:B or tau=A:B"
                               : "not a member of a family of one parameter: --along a parameter of the scene"));
        cycle.clear();
    }
    std::optional<RecordWriter> record = open_record(options.output, "Branches of cycles of a swirled polygon",
                                                     {options.scene.file(), options.record}, options.scene.units());
    note_interruptions();
    std::vector<analysis::Branch> branches(1);
    Progress progress("continue", along.high - along.low, options.output.quiet);
    system.options.progress = [&](double value) { progress.at(value - along.low); };
    if (cycle.empty() || !analysis::continue_branch(system.map, cycle, p, system.options, branches.front()))
        branches.clear();
    follow_switches(system, branches, options.switches);
    finish_up();
    if (record) {
        write_attributes(record->root().group("scene"), scene_settings(scene));
        write_attributes(record->root().group("settings"), settings_of(options, beginning));
        write_branches(record->root(), system, branches);
        record->finish();
    }
    if (options.output.json)
        write_document(options, beginning, system, branches);
    else if (!options.output.quiet && branches.empty() && beginning.why_none.empty())
        fmt::print("no cycle of period {} was found from {}\n", beginning.period,
                   options.record.empty() ? "--from" : "the record's");
    else if (!options.output.quiet)
        print_branches(system, along, branches, options.scene.units());
    if (is_interrupted()) return exit_interrupted;
    return branches.empty() ? exit_numerical_ending : exit_done;
}

}  // namespace swirl::apps::continuation
