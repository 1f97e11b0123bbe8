#include "apps/classify/classify_runs.hpp"

#include "apps/classify/runs_document.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/progress.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/run_control.hpp"
#include "apps/command_line/standard_streams.hpp"
#include "apps/ranks/hand_out.hpp"
#include "apps/ranks/packed.hpp"
#include "apps/studies/modes/attractors.hpp"
#include "apps/studies/modes/early_chaos.hpp"
#include "apps/studies/modes/escape.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <utility>
#include <vector>

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
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
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

}  // namespace swirl::apps::classify
