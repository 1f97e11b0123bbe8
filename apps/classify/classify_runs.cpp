#include "apps/classify/classify_runs.hpp"

#include "apps/classify/runs_document.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/ranks/hand_out.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/modes/run_verdict.hpp"

#include <fmt/format.h>

#include <numeric>
#include <optional>
#include <span>
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
Scene<double> planned(ClassifyCommandOptions& options) {
    if (!(options.input.record.empty() && options.input.series.file.empty()))
        throw BadInput(
            fmt::format("runs = {}: several runs are of a scene; a record or a series is one", options.runs));
    options.input.is_series(options.scene, options.start);  // what is for a series alone is refused
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const Scene<double> scene = options.scene.scene<double>();
    options.output.accuracy();  // a wrong name is reported before any work
    check(options);
    return scene;
}

/// Run number r is piece r. It holds what it uses: after an interruption it may outlive the command.
NamedWork work_of(const ClassifyCommandOptions& options, const Scene<double>& scene) {
    const double speed = options.start.speed();
    const std::uint64_t seed = options.start.seed();
    const NamingOptions naming{options.settings, options.output.accuracy(), is_interrupted};
    const auto work = [scene, speed, seed, naming](std::span<const std::size_t> pieces, const KeepPiece& keep) {
        std::vector<SceneStart> starts;
        for (const std::size_t r : pieces) starts.push_back({scene, random_start(scene.beta, speed, seed + r, 0)});
        name_modes(starts, naming,
                   [pieces, seed, &keep](std::size_t place, const NamedMode& named, const OrbitSamples&) {
                       keep({pieces[place], packed(run_verdict(seed + pieces[place], named))});
                   });
    };
    Settings settings = scene_settings(scene);
    settings.emplace_back("speed", speed);
    settings.emplace_back("seed", seed);
    settings.emplace_back("transient", naming.settings.transient);
    settings.emplace_back("collisions", naming.settings.collisions);
    settings.emplace_back("exhaustive", naming.settings.exhaustive);
    settings.emplace_back("threshold", naming.settings.recurrence_threshold);
    settings.emplace_back("max_period", naming.settings.period.max_period);
    settings.emplace_back("accuracy", options.output.accuracy_name);
    return {name_of_work(settings), work, most_named_together()};
}

/// The finished runs, by seed.
std::vector<RunVerdict> follow_all(const ClassifyCommandOptions& options, const Scene<double>& scene,
                                   HandOut& hand_out) {
    std::vector<std::size_t> runs(static_cast<std::size_t>(options.runs));
    std::iota(runs.begin(), runs.end(), std::size_t{0});
    std::vector<std::optional<RunVerdict>> results(runs.size());
    Progress progress("classify", static_cast<double>(runs.size()), options.output.quiet);
    hand_out.run(runs, options.output.threads, work_of(options, scene), progress,
                 [&](const PieceResult& piece) { results[piece.piece] = unpacked<RunVerdict>(piece.bytes); });
    std::vector<RunVerdict> whole;
    for (const auto& result : results)
        if (result) whole.push_back(*result);
    return whole;
}

/// What several runs tell together; after an interruption only which attractors they share.
void compare_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, RunsFound& found) {
    const double speed = options.start.speed();
    if (!is_interrupted())
        found.escape = escape_of(scene, speed, found.runs, options.output.accuracy(), run_control(options.output));
    if (found.escape) name_remaining(*found.escape, found.runs);
    found.attractors = attractors_of(found.runs);
    for (std::size_t a = 0; a < found.attractors.size(); ++a)
        for (const std::size_t r : found.attractors[a].runs) found.runs[r].attractor = static_cast<std::int64_t>(a);
    std::vector<SettledRun> settled;
    for (const RunVerdict& run : found.runs) settled.push_back({run.kind, run.mean_spin});
    found.steady = steady_shares(scene, settled);
    // Verdicts with all their evidence are not kept, run by run: this one is made again.
    const std::uint64_t seed = found.runs[found.attractors.front().runs.front()].seed;
    NamedMode first = name_mode(scene, random_start(scene.beta, speed, seed, 0), options.settings,
                                options.output.accuracy(), is_interrupted);
    if (is_interrupted()) return;
    if (found.escape) name_remaining(*found.escape, first);
    found.first = std::move(first);
}

int name_runs(ClassifyCommandOptions& options, HandOut& hand_out) {
    require_output(options.output, {options.scene.file(), options.input.record, options.input.series.file});
    const Scene<double> scene = planned(options);
    require_creatable(options.output);
    note_interruptions();
    RunsFound found;
    found.runs = follow_all(options, scene, hand_out);
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
        options.output.quiet, options.output.threads, [&] { return work_of(options, planned(options)); },
        [&](HandOut& hand_out) { return name_runs(options, hand_out); });
}

}  // namespace swirl::apps::classify
