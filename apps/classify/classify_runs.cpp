#include "apps/classify/classify_runs.hpp"

#include "apps/classify/runs_document.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/parallel_pieces.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/modes/run_verdict.hpp"

#include <optional>
#include <utility>

namespace swirl::apps::classify {

namespace {

/// The finished runs, by seed.
std::vector<RunVerdict> follow_all(const ClassifyCommandOptions& options, const Scene<double>& scene) {
    const auto count = static_cast<std::size_t>(options.runs);
    const double speed = options.start.speed();
    const std::uint64_t seed = options.start.seed();
    const Accuracy accuracy = options.output.accuracy();
    std::vector<std::optional<RunVerdict>> results(count);
    Progress progress("classify", static_cast<double>(count), options.output.quiet);
    run_pieces(count, options.output.threads, progress,
               [&results, &options, scene, speed, seed, accuracy](std::size_t r) -> KeepResult {
                   const auto verdict = classify_run(scene, speed, seed + r, options.settings, accuracy);
                   if (!verdict) return {};
                   return [&results, r, verdict] { results[r] = verdict; };
               });
    std::vector<RunVerdict> whole;
    for (const auto& result : results)
        if (result) whole.push_back(*result);
    return whole;
}

void check(const ClassifyCommandOptions& options) {
    if (!options.start.is_random())
        throw BadInput(
            fmt::format("runs = {}: several runs have random starts: give --speed and --seed, not --x … "
                        "or --point",
                        options.runs));
    options.start.require_one_way();
    options.start.require_seeds(static_cast<std::uint64_t>(options.runs));
}

/// What several runs tell together; after an interruption only which attractors they share.
void compare_runs(const ClassifyCommandOptions& options, const Scene<double>& scene, RunsFound& found) {
    const double speed = options.start.speed();
    if (!is_interrupted()) found.escape = escape_of(scene, speed, found.runs, options.output);
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

}  // namespace

std::optional<RunVerdict> classify_run(const Scene<double>& scene, double speed, std::uint64_t seed,
                                       const analysis::ClassifyOptions& settings, Accuracy accuracy) {
    const NamedMode named =
        name_mode(scene, random_start(scene.beta, speed, seed, 0), settings, accuracy, is_interrupted);
    if (!named.finished) return std::nullopt;
    return run_verdict(seed, named);
}

int classify_runs(const ClassifyCommandOptions& options, const Scene<double>& scene) {
    check(options);
    std::optional<RecordWriter> record =
        open_record(options.output, "Modes of a swirled polygon from several starts",
                    {options.scene.file(), options.input.record}, options.scene.units());
    note_interruptions();
    RunsFound found;
    found.runs = follow_all(options, scene);
    if (!found.runs.empty()) compare_runs(options, scene, found);
    const bool interrupted = is_interrupted();
    finish_up();
    if (record && !found.runs.empty()) {
        write_runs(record->root(), options, scene, found);
        record->finish();
    }
    if (interrupted && !options.output.quiet)
        tell(fmt::format("swirl: interrupted; {} of {} runs were finished", found.runs.size(), options.runs));
    if (found.runs.empty()) return exit_interrupted;
    if (options.output.json)
        write_runs_document(options, scene, found);
    else if (!options.output.quiet)
        print_runs(options, scene, found);
    return interrupted ? exit_interrupted : exit_done;
}

}  // namespace swirl::apps::classify
