#include "apps/classify/classify_command.hpp"

#include "apps/branches/section_point.hpp"
#include "apps/classify/classify_runs.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/input/each_body.hpp"
#include "apps/modes/classify_flags.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/output/points_in_words.hpp"
#include "apps/output/wrapped.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::classify {

const char* const classify_details =
    R"(The modes are steady (one state), quasi-steady (a cycle or a torus of states), chaotic and undecided. One line says what
was found and why, one what would change it; --verbose lists all evidence. The kind is finer:
  fixed-point, family  steady: the same state after every impact; one of a continuum of such states
  cycle                quasi-steady: the states repeat after `period` impacts
  quasi-periodic       quasi-steady: the states fill a torus
  landing              quasi-steady: a cycle that stays on the wall for a while
  rolling              steady, on the wall, at rest in the co-rotating frame (also called snaking)
  rolling-librating, rolling-circulating, sliding, two-vertex
                       motions on the wall (outcome in-contact)
  accelerated          friction at e = 1 drives the body along a diameter; its energy grows without end
  chord                friction at e = 1 drives it along a chord without slip, up to a limit of S
                       (map/chords/README.md)
  chaotic              the largest Lyapunov exponent is positive
  riding               steady, off the wall for ever, or held at it: a floor that drags or rubs takes the body along, S = 0
  transient            undecided: the orbit is still settling
An orbit without any contact is undecided, unless it rides.

An orbit is followed until nothing can change its verdict (an attracting cycle), at most through --transient and
--collisions; --exhaustive follows all of these impacts.

--runs R judges R starts, the r-th with --seed SEED+r. It lists the shares of modes and kinds, and the coexisting
attractors, numbered, the most shared first, each with the seed of one run: `swirl classify --seed SEED` prints that one's
point. In a record (-o) `swirl continue RECORD --orbit I` and `swirl certify RECORD --orbit I` know cycles by these numbers.
Runs of one kind and period with the same mean S (to 1e-6) share an attractor; chaotic runs, undecided ones and members of
a continuum (family, torus, libration, circulation) are grouped by kind alone. The verdict at top level is that of the
first attractor. If interrupted, the finished runs are kept.

--risk P calls chaos of several runs early, where less than a share P of the runs called so has another verdict at the
limits (95 %): a random sample of some 6/P runs, followed to them, tells. Of one run there is no sample, and nothing is saved
below a risk of 0.91.

Examples:
  swirl classify --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9
  swirl classify --sides 6 --alpha 0.635 --beta 0.5 --mu 0.5 --restitution 0.95 --runs 16
  swirl classify --sides 6 --alpha 0.15 --beta 0.5 --mu 0.5 --restitution 0.95 --runs 400 --risk 0.05
  swirl classify --sides 6 --alpha 0.3 --beta 0.2 --mu 0.5 --restitution 0.9 --drag 0.2)";

void ClassifyCommandOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    output.add_to(command);
    add_classify_flags(command, settings);
    add_risk_flags(command, risk, error);
    add_whole_number(command, "--max-period", settings.period.max_period, "K", 1, 1'000'000,
                     "longest period looked for (default 4096, of a series 256)");
    add_whole_number(command, "--runs", runs, "R", 1, 1'000'000,
                     "random starts, from --seed on: the shares of coexisting modes");
    command.add_flag("--verbose", verbose, "the table lists the numbers and all of the evidence")->group("Output");
    input.add_to(command);
}

namespace {

/// As much of the tail as a figure shows.
constexpr std::size_t most_kept = 2000;

/// Group `tail`: the section points of the first impacts that the verdict rests on; none where the orbit ended.
///   impacts  of the orbit; each point of the tail had a next one, the last included
void write_tail(const RecordGroup& root, const std::vector<Eigen::VectorXd>& points, std::int64_t impacts) {
    if (points.empty()) return;
    const RecordGroup group = root.group("tail");
    const std::size_t kept = std::min(points.size(), most_kept);
    std::vector<double> values;
    for (std::size_t i = 0; i < kept; ++i) values.insert(values.end(), points[i].begin(), points[i].end());
    group.attribute("first", impacts - std::ssize(points));
    group.dimension("impact", kept);
    write_coordinate_names(group, points.front().size());
    group.write<double>("points", {"impact", "coordinate"}, values, {"1", "section point just after each impact", {}});
}

/// Where the cycle is that a verdict found, and how to go on from it.
std::string cycle_in_words(const std::vector<double>& point, const std::optional<Units>& units) {
    if (point.empty()) return "";
    return fmt::format(
        "  point {}:\n    {}\n  to go on from it: swirl continue --from attractor, or -o FILE.h5 and its record\n",
        point_heading(point.size(), units), point_in_words(point, units));
}

/// The verdict at the look at which chaos of one run is called, if that tells; else at the limits.
NamedMode name_at_risk(const ClassifyCommandOptions& options, const SceneStart& start, OrbitSamples* samples) {
    NamingOptions naming{options.settings, options.output.accuracy(), interruption()};
    naming.look = look_of_one(options.risk, options.settings);
    if (naming.look > 0) {
        NamedMode named = name_alone(start, naming, samples);
        const SeenRun seen =
            seen_of(named.verdict.kind, named.outcome, named.verdict.largest_exponent, named.mean_errors.per_time);
        if (seen.known || (seen.chaotic && !(seen.mean_error > options.error))) return named;
        if (samples) *samples = {};
        naming.look = 0;
    }
    return name_alone(start, naming, samples);
}

int classify_one(ClassifyCommandOptions& options, const Scene<double>& scene,
                 const std::optional<RecordedOrbit>& recorded) {
    const Start<double> start = options.start.start<double>(scene);
    std::optional<RecordWriter> record =
        open_record(options.output, "Mode of a swirled polygon", {options.scene.file(), options.input.record},
                    options.scene.units());
    exit_when_interrupted();
    const Accuracy accuracy = options.output.accuracy();
    OrbitSamples samples;
    OrbitSamples* const seen = record ? &samples : nullptr;
    const NamedMode named = recorded ? name_recorded(scene, start, *recorded, options.settings, accuracy, seen)
                                     : name_at_risk(options, {scene, start}, seen);
    exit_when_interrupted();
    if (record) {
        const RecordGroup root = record->root();
        write_scene(root, scene, &options.start);
        write_verdict(root.group("mode"), named, options.settings, options.risk, options.error);
        write_tail(root, samples.points, named.impacts);
        record->finish();
    }
    if (options.output.json) {
        print_document([&](JsonWriter& json) {
            write_scene(json, scene, options.scene, &options.start);
            write_verdict(json, named, options.settings, options.risk, options.error);
        });
    } else if (!options.output.quiet) {
        const auto units = options.scene.units();
        const std::string risk =
            risk_of_one_in_words(options.risk, look_of_one(options.risk, options.settings), options.error);
        fmt::print("{}\n{}{}{}{}", scene_in_words(scene), units_in_words(units),
                   table_of(named, options.verbose, units), cycle_in_words(named.verdict.point, units),
                   risk.empty() ? "" : wrapped("  " + risk, 4) + "\n");
    }
    return exit_done;
}

}  // namespace

int classify_scene(ClassifyCommandOptions& options) {
    check_risk(options.risk, options.error, options.settings.exhaustive);
    if (options.runs > 0) return classify_runs(options);
    require_output(options.output, {options.scene.file(), options.input.record, options.input.series.file});
    if (options.risk > 0 && !(options.input.record.empty() && options.input.series.file.empty()))
        throw BadInput(fmt::format("risk = {:g}: a record or a series is as long as it is: no impacts are left out",
                                   options.risk));
    if (options.input.is_series(options.scene, options.start)) {
        const auto judge = [&] {
            return classify_measured(options.input, options.scene, options.start, options.output, options.verbose);
        };
        if (options.input.series.each.empty()) return judge();
        return for_each_body(options.input.series, options.scene, options.start, options.output, judge);
    }
    const auto recorded = options.input.recorded(options.scene, options.start);
    if (recorded) {
        warn_without_checksum(options.input.record, options.output.quiet);
        options.settings.transient = recorded->first;
        options.settings.collisions = recorded->collisions;
    }
    options.scene.read_file(options.output.quiet);
    options.start.take_from(options.scene);
    const Scene<double> scene = options.scene.scene<double>(Extensions::followed);
    options.output.accuracy();  // a wrong name is reported before any work
    return classify_one(options, scene, recorded);
}

}  // namespace swirl::apps::classify
