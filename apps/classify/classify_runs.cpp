#include "apps/classify/classify_runs.hpp"

#include "apps/branches/section_point.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/escape_document.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/steady_share_table.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/output/points_in_words.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/ranks/hand_out.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

namespace swirl::apps::classify {

namespace {

void check(const ClassifyCommandOptions& options) {
    if (!options.start.is_random())
        throw BadInput(
            fmt::format("runs = {}: several runs have random starts: give --speed and --seed, not --x … "
                        "or --point",
                        options.runs));
    options.start.require_one_way();
    options.start.require_seeds(static_cast<std::uint64_t>(options.runs));
}

/// What is to be done; nothing is yet. @throws BadInput
Scene<double> plan(ClassifyCommandOptions& options) {
    if (!(options.input.record.empty() && options.input.series.file.empty()))
        throw BadInput(
            fmt::format("runs = {}: several runs are of a scene; a record or a series is one", options.runs));
    options.input.is_series(options.scene, options.start);  // what is for a series alone is refused
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const Scene<double> scene = options.scene.scene<double>(OverFloor::followed);
    options.output.accuracy();  // a wrong name is reported before any work
    check(options);
    return scene;
}

RiskPieces risk_pieces_of(const ClassifyCommandOptions& options) {
    return {static_cast<std::size_t>(options.runs), early_look(options.settings)};
}

/// Run number r is piece r where it is followed to the limits. It holds what it uses: after an interruption it may
/// outlive the command.
NamedWork work_of(const ClassifyCommandOptions& options, const Scene<double>& scene) {
    const double speed = options.start.speed();
    const std::uint64_t seed = options.start.seed();
    const NamingOptions naming{options.settings, options.output.accuracy(), interruption()};
    const auto work = [scene, speed, seed, naming, numbers = risk_pieces_of(options)](
                          std::span<const std::size_t> pieces, const KeepPiece& keep) {
        for (const RiskPieces::Group& group : numbers.groups(pieces)) {
            std::vector<SceneStart> starts;
            for (const std::size_t r : group.runs)
                starts.push_back({scene, random_start(scene.beta, speed, seed + r, 0)});
            NamingOptions to_look = naming;
            to_look.look = group.look;
            name_modes(starts, to_look, [&](std::size_t place, const NamedMode& named, const OrbitSamples&) {
                const std::size_t run = group.runs[place];
                keep({numbers.number(run, group.look), packed(run_verdict(seed + run, named))});
            });
        }
    };
    Settings settings = scene_settings(scene);
    settings.emplace_back("speed", speed);
    settings.emplace_back("seed", seed);
    settings.emplace_back("transient", naming.settings.transient);
    settings.emplace_back("collisions", naming.settings.collisions);
    settings.emplace_back("exhaustive", naming.settings.exhaustive);
    settings.emplace_back("risk", options.risk);
    settings.emplace_back("threshold", naming.settings.recurrence_threshold);
    settings.emplace_back("max_period", naming.settings.period.max_period);
    settings.emplace_back("accuracy", options.output.accuracy_name);
    return {name_of_work(settings), work, most_named_together()};
}

/// Runs, and what is known of them.
struct FollowedRuns {
    const ClassifyCommandOptions& options;
    const Scene<double>& scene;
    HandOut& hand_out;
    std::vector<RunVerdict> results;
    std::vector<char> done;          ///< 1 of those whose verdict is kept
    std::vector<std::int64_t> look;  ///< of each the look that gave its verdict; 0: the limits
};

/// Runs that were followed, to the look (0: to the limits). None if it was interrupted.
std::optional<std::vector<SeenRun>> follow(FollowedRuns& followed, std::span<const std::size_t> runs,
                                           std::int64_t look) {
    const ClassifyCommandOptions& options = followed.options;
    const RiskPieces numbers = risk_pieces_of(options);
    std::vector<std::size_t> pieces;
    for (const std::size_t run : runs) pieces.push_back(numbers.number(run, look));
    Progress progress("classify", static_cast<double>(pieces.size()), options.output.quiet);
    const auto keep = [&](const PieceResult& piece) {
        const std::size_t run = numbers.run(piece.piece);
        followed.results[run] = unpacked<RunVerdict>(piece.bytes);
        followed.done[run] = look == 0 ? 1 : 0;
        followed.look[run] = look;
    };
    const bool all =
        followed.hand_out.run(pieces, options.output.threads, work_of(options, followed.scene), progress, keep);
    if (!all) return std::nullopt;
    std::vector<SeenRun> seen;
    for (const std::size_t run : runs) {
        const RunVerdict& result = followed.results[run];
        seen.push_back(seen_of(result.kind, result.outcome, result.largest_exponent, result.mean_errors.per_time));
    }
    return seen;
}

/// Follows all at the risk that is allowed.
void follow_all(const ClassifyCommandOptions& options, const Scene<double>& scene, HandOut& hand_out,
                RunsFound& found) {
    const auto count = static_cast<std::size_t>(options.runs);
    FollowedRuns followed{options,
                          scene,
                          hand_out,
                          std::vector<RunVerdict>(count),
                          std::vector<char>(count, 0),
                          std::vector<std::int64_t>(count, 0)};
    std::vector<std::size_t> all(count);
    std::iota(all.begin(), all.end(), std::size_t{0});
    RunsAtRisk runs;
    runs.follow = [&](std::span<const std::size_t> some, std::int64_t look) { return follow(followed, some, look); };
    runs.keep = [&](std::size_t run) { followed.done[run] = 1; };
    // Each is a cell of its own: one escape tells of all runs of a scene alike, as the sample does.
    const auto at_risk = follow_at_risk({count, 1, options.risk, options.start.seed(), early_look(options.settings),
                                         options.error, last_look(options.settings)},
                                        all, runs);
    if (at_risk && options.risk > 0) found.risk = {at_risk->evidence};
    std::vector<char> is_sampled(count, at_risk && at_risk->evidence.impacts > 0 ? 0 : 1);
    if (at_risk)
        for (const std::size_t run : at_risk->sample) is_sampled[run] = 1;
    for (const std::size_t run : all) {
        if (!followed.done[run]) continue;
        const RunVerdict& result = followed.results[run];
        const bool is_called = followed.look[run] != 0 && result.kind == analysis::Kind::chaotic;
        if (is_called && !at_risk) continue;  // interrupted: what it was called on is not known any more
        found.runs.push_back(result);
        found.called.push_back(is_called ? followed.look[run] : 0);
        if (is_sampled[run]) found.sample.push_back(result);
    }
}

/// The verdict on one of them, with all of its evidence.
NamedMode verdict_on(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found,
                     std::size_t run) {
    NamingOptions naming{options.settings, options.output.accuracy(), interruption()};
    naming.look = found.called[run];
    return name_alone({scene, random_start(scene.beta, options.start.speed(), found.runs[run].seed, 0)}, naming);
}

/// What several runs tell together; after an interruption only which attractors they share.
void compare_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, RunsFound& found) {
    if (!is_interrupted())
        found.escape = escape_of(scene, options.start.speed(), found.sample, options.output.accuracy(),
                                 run_control(options.output));
    if (found.escape) name_remaining(*found.escape, found.runs);
    found.attractors = attractors_of(found.runs);
    for (std::size_t a = 0; a < found.attractors.size(); ++a)
        for (const std::size_t r : found.attractors[a].runs) found.runs[r].attractor = static_cast<std::int64_t>(a);
    std::vector<SettledRun> settled;
    for (const RunVerdict& run : found.runs) settled.push_back({run.kind, run.mean_spin});
    found.steady = steady_shares(scene, settled);
    // Verdicts with all their evidence are not kept, run by run: this one is made again.
    NamedMode first = verdict_on(options, scene, found, found.attractors.front().runs.front());
    if (is_interrupted()) return;
    if (found.escape) name_remaining(*found.escape, first);
    found.first = std::move(first);
}

int name_runs(ClassifyCommandOptions& options, HandOut& hand_out) {
    require_output(options.output, {options.scene.file(), options.input.record, options.input.series.file});
    const Scene<double> scene = plan(options);
    require_creatable(options.output);
    note_interruptions();
    RunsFound found;
    follow_all(options, scene, hand_out, found);
    if (!found.runs.empty()) compare_runs(options, scene, found);
    const bool interrupted = is_interrupted();
    finish_up();
    if (!options.output.record.empty() && !found.runs.empty()) {
        RecordWriter record =
            create_record(options.output, "Modes of a swirled polygon from several starts", options.scene.units());
        write_runs(record.root(), options, scene, found);
        record.finish();
    }
    if (interrupted && !options.output.quiet)
        report(fmt::format("swirl: interrupted; {} of {} runs were finished", found.runs.size(), options.runs));
    if (found.runs.empty()) return exit_interrupted;
    if (options.output.json)
        write_runs_document(options, scene, found);
    else if (!options.output.quiet)
        print_runs(options, scene, found);
    return interrupted ? exit_interrupted : exit_done;
}

}  // namespace

int classify_runs(ClassifyCommandOptions& options) {
    return on_all_ranks(
        options.output.quiet, options.output.threads, [&] { return work_of(options, plan(options)); },
        [&](HandOut& hand_out) { return name_runs(options, hand_out); });
}

namespace {

/// How many runs have each value, in the enumerators' order.
template <class Enum>
std::map<Enum, std::size_t> counts_of(const std::vector<RunVerdict>& runs, Enum RunVerdict::*member) {
    std::map<Enum, std::size_t> counts;
    for (const auto& run : runs) ++counts[run.*member];
    return counts;
}

double share(std::size_t count, const RunsFound& found) {
    return static_cast<double>(count) / static_cast<double>(found.runs.size());
}

template <class Enum>
void write_shares(JsonWriter& json, std::string_view key, const RunsFound& found, Enum RunVerdict::*member) {
    json.key(key);
    json.begin_object();
    for (const auto& [value, count] : counts_of(found.runs, member)) json.member(name_of(value), share(count, found));
    json.end_object();
}

Table<RunVerdict> runs_table() {
    using Run = RunVerdict;
    const auto errors = mean_error_fields<Run>(&Run::mean_errors, "standard error of mean_S along the run");
    Table<Run> table{
        {"run"},
        {Field<Run>{"seed", &Run::seed, "", "seed of the random start"}.stored_as(ElementType::string),
         {"attractor", &Run::attractor, "1", "place in the group attractors"},
         {"mode", &Run::mode, "", "mode that the run settled on"},
         kind_field<Run>(&Run::kind),
         {"outcome", &Run::outcome, "", "how the orbit ended"},
         period_field<Run>(&Run::period),
         Field<Run>{"impacts", &Run::impacts, "1", "impacts followed"}.record_only(),
         {"mean_S", &Run::mean_spin, "1", "time mean of S"},
         {"mean_S_per_impact", &Run::mean_spin_per_impact, "1", "mean of S over impacts"},
         errors.per_time,
         errors.per_impact,
         errors.kind,
         {"recurrence_rate", &Run::recurrence_rate, "1", "RC of S"},
         {"ln_multiplier", &Run::ln_multiplier, "1", "of a cycle: ln of its largest |multiplier|, DF^period"},
         {"largest_exponent", &Run::largest_exponent, "1", "largest Lyapunov exponent per impact"},
         {"largest_exponent_error", &Run::largest_exponent_error, "1", "its standard error"}}};
    const auto driven = driven_fields<Run>(&Run::growth, &Run::limit_spin);
    table.fields.insert(table.fields.end(), driven.begin(), driven.end());
    return table;
}

const std::vector<double>& point_of(const SharedAttractor& a, const RunsFound& found) {
    return found.runs[a.runs.front()].point;
}

std::size_t number_of(const SharedAttractor& a, const RunsFound& found) {
    return static_cast<std::size_t>(&a - found.attractors.data()) + 1;
}

///   d  coordinates of a section point
Table<SharedAttractor> attractors_table(const RunsFound& found, std::size_t d) {
    using F = Field<SharedAttractor>;
    const auto first = [&found](auto member) {
        return [&found, member](const SharedAttractor& a) { return found.runs[a.runs.front()].*member; };
    };
    const auto in_percent = [](const Value& value) {
        return fmt::format(" {:>6.2f} %", 100 * std::get<double>(value));
    };
    const auto number = [&found](const SharedAttractor& a) { return static_cast<std::int64_t>(number_of(a, found)); };
    const auto point = [&found](const SharedAttractor& a) { return point_of(a, found); };
    Table<SharedAttractor> table{
        {"attractor"},
        {F{"number", number, no_column}.table_only().shown("no.", "  {:>4}"),
         F{"share", [&found](const SharedAttractor& a) { return share(a.runs.size(), found); }, "1",
           "share of the runs"}
             .shown("share", {" {:>8}", in_percent}),
         F{"mode", first(&RunVerdict::mode), "", "mode of these runs"}.shown("mode", "  {:<12}"),
         kind_field<SharedAttractor>(first(&RunVerdict::kind)).shown("kind", " {:<19}"),
         F{"outcome", first(&RunVerdict::outcome), "", "how their orbits ended"},
         period_field<SharedAttractor>(first(&RunVerdict::period)).shown("period", dash_for_zero(" {:>6}")),
         F{"mean_S", &SharedAttractor::mean_spin, "1", "mean of the runs' time means"},
         F{"mean_S_error", &SharedAttractor::mean_spin_error, "1",
           "its standard error over the runs; of one run its own"},
         F{"mean_S_in_words",
           [&found](const SharedAttractor& a) {
               const RunVerdict& run = found.runs[a.runs.front()];
               return spin_in_words(a.mean_spin, a.mean_spin_error, run.kind == analysis::Kind::chaotic,
                                    way_in_words(run.growth, run.limit_spin));
           },
           no_column}
             .table_only()
             .shown("mean S", " {:>17}"),
         F{"largest_exponent", &SharedAttractor::largest_exponent, "1", "mean over the runs, per impact"}.shown(
             "exponent", " {:>10.4g}"),
         {"ln_multiplier", first(&RunVerdict::ln_multiplier), "1", "of a cycle: ln of its largest |multiplier|"},
         {"recurrence_rate", &SharedAttractor::recurrence_rate, "1", "mean over the runs"},
         F{"point", point, "1", "a cycle's first state, of the first run"}
             .along({"coordinate"}, d)
             .json_written(
                 [point](JsonWriter& json, const SharedAttractor& a) { write_point_or_null(json, point(a)); }),
         F{"seed", first(&RunVerdict::seed), "", "seed of the first of them"}
             .stored_as(ElementType::string)
             .shown("seed", "  {}")},
        {"seed", "mode", "kind", "outcome", "period"}};
    const auto driven = driven_fields<SharedAttractor>(first(&RunVerdict::growth), first(&RunVerdict::limit_spin));
    table.fields.insert(table.fields.end(), driven.begin(), driven.end());
    return table;
}

std::size_t dimension_of(const Scene<double>& scene) {
    return scene.is_disk() ? disk_dimension : polygon_dimension;
}

/// Where the cycles are, by the table's numbers, and how to go on from them.
std::string points_of(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found) {
    const auto units = options.scene.units();
    std::string lines;
    for (const SharedAttractor& a : found.attractors)
        if (const auto& point = point_of(a, found); !point.empty())
            lines += fmt::format("  {:>4}  {}\n", number_of(a, found), point_in_words(point, units));
    if (lines.empty()) return "";
    const std::string file = options.output.record.empty() ? "-o FILE.h5, then swirl continue FILE.h5"
                                                           : "swirl continue " + options.output.record;
    return fmt::format("  points {}:\n{}  to go on from one: {} --orbit I\n", point_heading(dimension_of(scene), units),
                       lines, file);
}

}  // namespace

void write_runs_document(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found) {
    print_document([&](JsonWriter& json) {
        write_scene(json, scene, options.scene, &options.start);
        if (found.first) write_verdict(json, *found.first, options.settings, options.risk, options.error);
        write_shares(json, "modes", found, &RunVerdict::mode);
        write_shares(json, "kinds", found, &RunVerdict::kind);
        json.key("escape");
        write_escape(json, found.escape);
        write_risk(json, found.risk);
        write_json(json, "attractors", attractors_table(found, dimension_of(scene)), found.attractors);
        write_json(json, "steady_modes", steady_share_table(), found.steady);
        write_json(json, "runs", runs_table(), found.runs);
        if (!found.first) json.member("outcome", "interrupted");
    });
}

void write_runs(const RecordGroup& root, const ClassifyCommandOptions& options, const Scene<double>& scene,
                const RunsFound& found) {
    write_scene(root, scene, &options.start);
    if (found.first) write_verdict(root.group("mode"), *found.first, options.settings, options.risk, options.error);
    const RecordGroup attractors = root.group("attractors");
    write_coordinate_names(attractors, static_cast<Eigen::Index>(dimension_of(scene)));
    write_record(attractors, attractors_table(found, dimension_of(scene)), found.attractors);
    if (found.escape) write_escape(root.group("escape"), *found.escape);
    write_risk(root, found.risk);
    if (!found.steady.empty()) write_record(root.group("steady_modes"), steady_share_table(), found.steady);
    const RecordGroup runs = root.group("runs");
    runs.attribute("wanted", options.runs);  // more than there are if interrupted
    write_record(runs, runs_table(), found.runs);
}

void print_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, const RunsFound& found) {
    const auto units = options.scene.units();
    fmt::print("{}\n{}  {} runs:", scene_in_words(scene), units_in_words(units), found.runs.size());
    for (const auto& [mode, count] : counts_of(found.runs, &RunVerdict::mode))
        fmt::print(" {} {:.4g} %", name_of(mode), 100 * share(count, found));
    fmt::print("\n");
    if (found.escape) fmt::print("{}\n", wrapped("  " + in_words(*found.escape), 4));
    for (const RiskEvidence& evidence : found.risk) fmt::print("{}\n", wrapped("  " + in_words(evidence), 4));
    print_table(in_units(attractors_table(found, dimension_of(scene)), units), found.attractors);
    fmt::print("{}", points_of(options, scene, found));
    for (const SteadyShare& mode : found.steady)
        if (mode.share == 0)
            fmt::print("  no start came to the steady mode with S {:.10g} (|multiplier| {:.4g}, flight time {})\n",
                       mode.spin, mode.multiplier, with_unit(mode.flight_time, units, "1/omega_s"));
    if (found.first)
        fmt::print("the first of them, seed {}:\n{}", found.runs[found.attractors.front().runs.front()].seed,
                   table_of(*found.first, options.verbose, units));
}

}  // namespace swirl::apps::classify
