#include "apps/recurrence/recurrence_command.hpp"

#include "analysis/threads.hpp"
#include "apps/command_line/interruption.hpp"
#include "apps/command_line/numbers.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/input/each_body.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/recurrence/recurrence_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>

namespace swirl::apps::recurrence {

namespace recurrence = analysis::recurrence;

const char* const recurrence_details =
    R"(
Two points recur if they are at most the threshold apart. Lines of the plot are runs of such pairs, along its diagonals (the
orbit repeats itself) or upright (it stays):
  RR            recurrence rate: share of the pairs that recur
  DET, LAM      determinism, laminarity: share of the recurring pairs in diagonal, in upright lines
  L, TT         mean length of these two kinds of lines (TT: trapping time)
  Lmax, Vmax    the longest of each; DIV is 1/Lmax
  ENTR, VENTR   entropy of their lengths (natural logarithm)
  MRT, RTE      mean recurrence time, and the entropy of recurrence times
  TREND         how much the rate falls away from the main diagonal, per 1000 points
  RC            recurrence rate of Sun 2019, the main diagonal counted: 1/k of k values equally often
The Theiler window leaves out pairs of points that are near in time.

Several thresholds (--threshold 0.1,0.2) are counted in one pass; RR ... RC are then lists, in the order of the list
`thresholds`. --threshold is in SI units where the scene is and the observable has a unit (x, vn, ...; S has none). A cross
recurrence (--cross, --cross-column) has the first series in its rows and no RC. Gaps of a measured series are to lines and
recurrence times what the border of the matrix is: they end there, unless --join-gaps. An orbit that ends early is quantified as
far as it came: the outcome says why, and the exit code is 3.

--sample-pairs K is for series so long that n^2 pairs are out of reach: RR, DET, L, LAM, TT and RC are estimated from K pairs
(1000 or more) drawn at random, each with its standard error (some 4 errors hold nearly always); the other measures need all
pairs and are left out. Up to some 5000 points all pairs are counted as fast.

Examples:
  swirl recurrence --sides 6 --alpha 0.3 --beta 0.1 --mu 0.1 --restitution 1 --collisions 2000
  swirl recurrence --sides 6 --alpha 0.4 --beta 0.5 --mu 0.5 --restitution 0.9 --observable psi,chi --threshold 1e-6
  swirl recurrence --sides 6 --alpha 0.3 --beta 0.5 --mu 0.5 --restitution 1 --collisions 300000 --sample-pairs 100000)";

namespace {

/// Of fewer pairs some ten recur where RR is 0.01, and no error is known.
constexpr std::int64_t fewest_pairs = 1000;

/// Window and image against the numbers of points.
void check_sizes(const RecurrenceOptions& options, int window, const recurrence::Points& rows,
                 const recurrence::Points& columns) {
    const std::size_t longest = std::max(rows.rows(), columns.rows()), shortest = std::min(rows.count, columns.count);
    if (window > 0 && static_cast<std::size_t>(window) >= longest)
        throw BadInput(
            fmt::format("theiler = {} leaves no pair of {} points; allowed: 0 to {}", window, longest, longest - 1));
    if (options.image > shortest)
        throw BadInput(
            fmt::format("--image = {} is outside its range: 1 to {}, the number of points", options.image, shortest));
}

/// An estimate from random pairs, in place of counts of all.
void estimate(const RecurrenceOptions& options, const recurrence::Points& points, Quantification& result) {
    const double delta = result.thresholds.delta.front();
    result.sampled = recurrence::sample_pairs(points, delta, static_cast<std::uint64_t>(options.sampled_pairs),
                                              options.sample_seed, result.conventions);
    const recurrence::Measures& m = result.sampled->measures;
    // RC has the pairs that a window of 1 leaves, and is with <=.
    const bool tells_rc = recurrence::theiler_window(result.conventions, false) == 1 && !result.conventions.strict;
    const double n = static_cast<double>(points.count);
    result.results.push_back(
        {delta, m, tells_rc ? (m.RR * (n - 1) + 1) / n : std::nan(""), tells_rc ? m.RR : std::nan("")});
}

Quantification quantify(const RecurrenceOptions& options, const RecurrencePoints& points,
                        const std::optional<RecurrencePoints>& cross) {
    Quantification result;
    result.conventions = options.conventions.settings();
    result.thresholds = thresholds_of(options, points, cross.has_value(), result.conventions);
    if (!points.enough || (cross && !cross->enough)) return result;
    check_sizes(options, recurrence::theiler_window(result.conventions, cross.has_value()), points.points,
                cross ? cross->points : points.points);
    const auto& deltas = result.thresholds.delta;
    if (options.sampled_pairs > 0) {
        estimate(options, points.points, result);
        return result;
    }
    result.lines = cross ? recurrence::count_cross_lines(points.points, cross->points, deltas, result.conventions)
                         : recurrence::count_lines(points.points, deltas, result.conventions);
    recurrence::Settings paper;  // RC is always with <=
    paper.norm = result.conventions.norm;
    for (std::size_t k = 0; k < deltas.size(); ++k) {
        recurrence::RecurrenceRate rate;
        if (!cross && result.conventions.strict)
            rate = recurrence::recurrence_rate(points.points, deltas[k], paper);
        else if (!cross)
            rate = {result.lines[k].points, points.points.count, points.points.count};
        result.results.push_back({deltas[k], recurrence::measures(result.lines[k], result.conventions),
                                  cross ? std::nan("") : rate.with_diagonal(),
                                  cross ? std::nan("") : rate.without_diagonal()});
    }
    if (options.image > 0)
        result.image =
            cross ? recurrence::cross_recurrence_image(points.points, cross->points, deltas.front(), options.image,
                                                       result.conventions)
                  : recurrence::recurrence_image(points.points, deltas.front(), options.image, result.conventions);
    return result;
}

std::size_t thresholds_given(const RecurrenceOptions& options) {
    std::size_t values = 0;
    for (const auto* texts : {&options.thresholds, &options.thresholds_std, &options.rates})
        for (const auto& text : *texts) values += values_in(text);
    return values;
}

/// What is not for random pairs.
void check_sampling(const RecurrenceOptions& options) {
    if (options.sampled_pairs == 0 && options.sample_seed != 1)
        throw BadInput(fmt::format("sample-seed = {} is of --sample-pairs", options.sample_seed));
    if (options.sampled_pairs == 0) return;
    const auto refuse = [&](const std::string& why) {
        throw BadInput(fmt::format("sample-pairs = {}: {}", options.sampled_pairs, why));
    };
    if (!options.cross.empty() || !options.cross_column.empty())
        refuse("pairs are drawn of one series, not of --cross");
    if (options.image > 0) refuse("--image is of all pairs");
    if (!options.rates.empty()) refuse("--recurrence-rate looks at all pairs: give --threshold or --threshold-std");
    if (thresholds_given(options) > 1) refuse("give one threshold");
    const std::string obstacle = recurrence::obstacle_to_sampling(options.conventions.settings());
    if (!obstacle.empty()) refuse(obstacle);
}

void check_flags(const RecurrenceOptions& options) {
    options.conventions.settings();
    if (options.output.accuracy() != Accuracy::double_precision && options.input.kind() != InputKind::scene)
        throw BadInput(fmt::format("accuracy = {} is an orbit's that is followed", options.output.accuracy_name));
    check_sampling(options);
    if (options.image == 0) return;
    if (options.output.record.empty() && !options.output.json)
        throw BadInput("--image goes into a record or a document: give -o FILE.h5 or --json");
    if (thresholds_given(options) > 1) throw BadInput("--image takes one threshold");
}

}  // namespace

void RecurrenceOptions::add_to(Flags& command) {
    input.add_to(command);
    conventions.add_to(command);
    output.add_to(command);
    Flags recurrence = command.under("Recurrence");
    const auto list = [&](const char* flag, std::vector<std::string>& target, const char* type, const char* help) {
        recurrence.add_option(flag, target, type, help)->allow_extra_args(false);
    };
    list("--threshold", thresholds, "D", "delta; several, separated by commas: one pass");
    list("--threshold-std", thresholds_std, "F", "delta in standard deviations of the observable (default 0.1)");
    list("--recurrence-rate", rates, "R", "the smallest delta that gives this recurrence rate");
    recurrence
        .add_option("--observable", observables, "NAME",
                    "of an orbit: S (default), psi, chi, vn, vt, x, y, ..., or a comma list of coordinates")
        ->offer({"S", "psi", "chi", "vn", "vt", "x", "y"});
    add_whole_number(recurrence, "--dimension", dimension, "M", 1, 1'000'000, "of the delay embedding (default 1)");
    add_whole_number(recurrence, "--delay", delay, "L", 1, 1'000'000'000, "of the embedding, in points (default 1)");
    recurrence.add_option("--period", period, "P", "the measured series is an angle of this period (360, say)");
    recurrence.add_option("--resample", resample, "DT", "make a measured series even: linear, this spacing; gaps stay");
    recurrence.add_flag("--join-gaps", join_gaps,
                        "lines of a measured series go on across its gaps, as if there were none");
    recurrence.add_option("--cross", cross, "FILE", "cross recurrence with another series, or another record");
    recurrence.add_option("--cross-column", cross_column, "NAME",
                          "the second series' column (of --cross, or of --series)");
    add_whole_number(recurrence, "--sample-pairs", sampled_pairs, "K", fewest_pairs, 1'000'000'000'000,
                     "estimate RR, DET, L, LAM, TT and RC from K random pairs of points, with errors");
    add_seed(recurrence, sample_seed, "of these pairs (default 1)", nullptr, "--sample-seed")->type_name("SEED");
    add_whole_number(recurrence, "--image", image, "PIXELS", 1, 20'000,
                     "the recurrence plot, down-sampled, into the record or the document");
}

int quantify_recurrence(RecurrenceOptions& options) {
    check_flags(options);
    if (!options.input.series.each.empty())
        return for_each_body(options.input.series, options.input.scene, options.input.start, options.output,
                             [&] { return quantify_recurrence(options); });
    std::vector<std::string> inputs = options.input.files();
    inputs.push_back(options.cross);
    std::optional<RecordWriter> record = open_record(options.output, "Recurrence quantification", inputs);
    const RecurrencePoints points = main_points(options);
    if (points.orbit && points.orbit->outcome == "interrupted" && is_interrupted()) return exit_interrupted;
    const std::optional<RecurrencePoints> cross = cross_points(options);
    for (const std::string& file : {options.input.record, is_hdf5_file(options.cross) ? options.cross : ""})
        warn_without_checksum(file, options.output.quiet);
    exit_when_interrupted();
    const Quantification result =
        analysis::on_threads(options.output.threads, [&] { return quantify(options, points, cross); });
    const RecurrenceReport report{options, points, cross, result};
    if (record) {
        if (points.orbit) scale_columns(*record, *points.orbit);
        write_record(record->root(), report);
        record->finish();
    }
    if (options.output.json)
        write_json(report);
    else if (!options.output.quiet)
        print_table(report);
    const bool cut = options.input.kind() == InputKind::scene && points.orbit->outcome != "completed";
    return cut ? exit_numerical_ending : exit_done;
}

}  // namespace swirl::apps::recurrence
