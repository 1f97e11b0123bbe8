#include "apps/classify/classify_series.hpp"

#include "analysis/classification/classify_angle.hpp"
#include "analysis/classification/classify_series.hpp"
#include "analysis/special_values.hpp"
#include "apps/classify/series_means.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/input/angle_stretch.hpp"
#include "apps/input/column_names.hpp"
#include "apps/input/input_options.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/modes/verdict_in_words.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

namespace swirl::apps::classify {

const char* const classify_series_details =
    R"(A record of simulate is judged by the orbit in it: by its second half, or by all of it if --skip left out the beginning,
unless --transient and --collisions say which impacts count.

A measured series (--series, or a record without a scene) is judged without the map by four questions. Does it repeat
within its noise? Does its spectrum have lines? Is it predicted better than noise with the same spectrum, values and
transitions? Do neighbours part at one rate? Where the evidence is little or disagrees, the mode is undecided. The rate
is the largest exponent, with an error that covers what biases it; chaos in which neighbours are too far apart for it,
as in short or noisy series, has none. --noise SIGMA lets a constant with
noise count as steady. The longest segment without a gap counts; gaps of up to three rows in an angle are bridged. A
position is never called steady or quasi-steady, since its distance from a centre swings along every flight.)";

namespace {

/// A run of samples without a gap.
struct Stretch {
    std::size_t begin = 0, count = 0;
};

Stretch longest_stretch(const MeasuredSeries& series) {
    std::size_t best = 0, best_begin = 0, begin = 0;
    for (std::size_t i = 0; i <= series.values.size(); ++i) {
        if (i < series.values.size() && !std::isnan(series.values[i])) continue;
        if (i - begin > best) best = i - begin, best_begin = begin;
        begin = i + 1;
    }
    return {best_begin, best};
}

MeasuredSeries part_of(const MeasuredSeries& series, const Stretch& stretch) {
    return part_of(series, stretch.begin, stretch.count);
}

struct SeriesVerdict {
    MeasuredSeries whole, used;
    std::size_t rows_used = 0, rows_bridged = 0;
    analysis::ClassifySeriesOptions options;
    analysis::Classification verdict;
    MeanErrors mean_errors;
};

/// Over the time of the values judged; NaN where a series has none.
double mean_spin_of(const SeriesVerdict& v) {
    if (v.whole.quantity == distance_of_position) return analysis::nan;
    if (v.options.sampled_flow) return v.verdict.mean;
    return v.used.time.empty() ? analysis::nan : time_mean(v.used);
}

/// "; mean S -0.20 +- 0.03"; of a regular motion, whose measured mean has no error here, to three digits.
std::string mean_in_words(const SeriesVerdict& v) {
    const double mean = mean_spin_of(v);
    if (!std::isfinite(mean)) return "";
    const bool has_error = v.mean_errors.kind != MeanKind::none;
    return "; mean S " + (has_error ? apps::mean_in_words(mean, v.mean_errors) : fmt::format("about {:.3g}", mean));
}

Table<SeriesVerdict> verdict_table(const SeriesVerdict& v) {
    using Verdict = analysis::Classification;
    const double spacing = v.used.spacing;
    const bool flow = v.options.sampled_flow;
    const auto of = [](auto member) { return [member](const SeriesVerdict& row) { return row.verdict.*member; }; };
    const auto errors = mean_error_fields<SeriesVerdict>(&SeriesVerdict::mean_errors);
    const auto per_time = [&](double Verdict::*member) {
        return [=](const SeriesVerdict& row) { return flow ? row.verdict.*member / spacing : analysis::nan; };
    };
    const auto per_impact = [&](double Verdict::*member) {
        return [=](const SeriesVerdict& row) { return flow ? analysis::nan : row.verdict.*member; };
    };
    return {{},
            {{"mode", of(&Verdict::mode), no_column},
             kind_field<SeriesVerdict>(of(&Verdict::kind)),
             period_field<SeriesVerdict>(of(&Verdict::period)),
             {"mean_S", mean_spin_of, no_column},
             {"mean_S_per_impact", per_impact(&Verdict::mean_per_step), no_column},
             errors.per_time,
             errors.per_impact,
             errors.bound,
             errors.kind,
             {"recurrence_rate", of(&Verdict::recurrence_rate), no_column},
             {"recurrence_rate_without_diagonal", of(&Verdict::recurrence_rate_without_diagonal), no_column},
             {"largest_exponent", per_impact(&Verdict::largest_exponent), no_column},
             {"largest_exponent_error", per_impact(&Verdict::largest_exponent_error), no_column},
             {"largest_exponent_per_time", per_time(&Verdict::largest_exponent), no_column},
             {"largest_exponent_per_time_error", per_time(&Verdict::largest_exponent_error), no_column}}};
}

std::string rows_of(const SeriesVerdict& v) {
    return v.options.sampled_flow ? "samples" : "impacts";
}

Settings settings_of(const SeriesVerdict& v) {
    return {{"rows", rows_of(v)},
            {"samples_used", static_cast<std::int64_t>(v.rows_used)},
            {"samples_bridged", static_cast<std::int64_t>(v.rows_bridged)},
            {"first_time_used", v.used.times.front()},
            {"noise", v.options.noise},
            {"largest_noise", v.options.largest_noise},
            {"threshold", v.options.recurrence_threshold},
            {"max_period", std::int64_t{v.options.max_period}}};
}

void write_document(const SeriesVerdict& v) {
    print_document([&](JsonWriter& json) {
        write_json(json, "series", series_settings(v.whole));
        write_members(json, verdict_table(v), v);
        write_evidence(json, v.verdict.evidence);
        write_json(json, "settings", settings_of(v));
    });
}

void write_to_record(const RecordGroup& root, const SeriesVerdict& v) {
    write_series(root, v.whole);
    const RecordGroup group = root.group("mode");
    write_attributes(group, verdict_table(v), v);
    write_attributes(group.group("settings"), settings_of(v));
    write_evidence(group, v.verdict.evidence);
}

/// Of samples in time per unit of their times, or per sample if they have none.
ExponentUnit exponent_unit(const SeriesVerdict& v) {
    if (!v.options.sampled_flow) return {1, "per impact", "measured"};
    if (v.whole.time.empty()) return {1, "per sample", "measured"};
    return {v.used.spacing, fmt::format("per unit of {}", printable(v.whole.time)), "measured"};
}

void print_verdict(const SeriesVerdict& v, bool verbose) {
    const std::string bridged = v.rows_bridged > 0 ? fmt::format(", {} of them bridged", v.rows_bridged) : "";
    fmt::print("{}\n{}  {}{}\n{}",
               wrapped(fmt::format("series: {}; rows are {}, {} used{}", series_in_words(v.whole), rows_of(v),
                                   v.rows_used, bridged),
                       2),
               notes_in_lines(v.whole), mode_in_words(v.verdict), mean_in_words(v),
               verdict_in_lines(v.verdict, {}, exponent_unit(v)));
    if (verbose) fmt::print("{}{}", lines_of(verdict_table(v), v), table_of(v.verdict.evidence));
}

void leave_undecided(SeriesVerdict& v, analysis::Evidence reason) {
    v.verdict.mode = analysis::Mode::undecided;
    v.verdict.kind = analysis::Kind::none;
    v.verdict.period = 0;
    v.verdict.evidence.push_back(std::move(reason));
}

/// Of an angle that was sampled in time: from the angle itself.
void judge_angle(SeriesVerdict& v) {
    const AngleStretch stretch = longest_stretch(v.whole.angle);
    v.rows_used = stretch.angles.size();
    v.rows_bridged = stretch.bridged;
    v.used = part_of(v.whole, stretch.first, stretch.angles.size() - 1);
    v.verdict.steps = static_cast<std::int64_t>(v.rows_used);
    if (!stretch.is_even())
        return leave_undecided(
            v, {"deviation of the times from even ones in rows", stretch.largest_deviation, 0.5,
                fmt::format("times are {:.3g} rows away from even ones: rows are missing or out of step",
                            stretch.largest_deviation),
                "at most 0.5 rows: the spectrum of the angle decides; or --rows impacts, if rows are "
                "impacts"});
    if (v.rows_used < analysis::fewest_angles)
        return leave_undecided(
            v, {"rows of the angle in one stretch", static_cast<double>(v.rows_used),
                static_cast<double>(analysis::fewest_angles),
                fmt::format("{} rows are in one stretch, {} are needed", v.rows_used, analysis::fewest_angles),
                fmt::format("{} rows or more in one stretch: the spectrum of the angle decides",
                            analysis::fewest_angles)});
    v.verdict = analysis::classify_angle(stretch.angles, stretch.spacing * v.whole.swirl_rate, v.options,
                                         v.whole.angle.resolution);
    if (v.whole.is_unwrapped()) return;
    v.verdict.mean = analysis::nan;
    leave_undecided(v, {"largest turn from row to row, in half periods", v.whole.largest_turn, sure_turn,
                        fmt::format("the body turns by {:.3g} of half a period from row to row: which way is a guess",
                                    v.whole.largest_turn),
                        "at most 0.9, so more rows a second: the lines and the continuum of the spectrum decide"});
}

/// The noise of S, where that of the angle was given: √2 σ / (ω_s Δt), its root mean square.
double noise_of_spin(const MeasuredSeries& series, double of_angle) {
    double sum = 0;
    const auto& t = series.angle.times;
    for (std::size_t i = 1; i < t.size(); ++i) sum += 1 / ((t[i] - t[i - 1]) * (t[i] - t[i - 1]));
    return of_angle * std::sqrt(2 * sum / static_cast<double>(t.size() - 1)) / series.swirl_rate;
}

void judge_values(SeriesVerdict& v) {
    const Stretch longest = longest_stretch(v.whole);
    if (longest.count < analysis::fewest_samples && v.whole.gaps > 0)
        throw BadInput(
            fmt::format("series: the longest of its stretches between {} gaps has {} sample{}; {} or more are needed "
                        "(--rows impacts: a long step is a long flight, no gap; a row without a value is one)",
                        v.whole.gaps, longest.count, longest.count == 1 ? "" : "s", analysis::fewest_samples));
    v.used = part_of(v.whole, longest);
    v.rows_used = longest.count;
    analysis::ClassifySeriesOptions options = v.options;
    if (v.whole.quantity == spin_of_angle) options.noise = noise_of_spin(v.used, options.noise);
    v.verdict = analysis::classify_series(v.used.values, options);
    const bool regular = v.verdict.mode == analysis::Mode::steady || v.verdict.mode == analysis::Mode::quasi_steady;
    if (v.whole.quantity != distance_of_position || !regular) return;
    leave_undecided(v, {"regular in time", 1, 0,
                        "it is steady or quasi-steady, and a distance cannot tell which: it swings along every flight",
                        "S, or an angle, of the same motion, which says which of the two it is"});
}

bool is_sampled_flow(const ClassifyInput& input, const MeasuredSeries& series) {
    if (input.series.rows == "samples") return true;
    if (input.series.rows == "impacts") return false;
    return series.is_motion() || (!series.time.empty() && series.is_film());
}

}  // namespace

void ClassifyInput::add_to(Flags& command) {
    command.add_option("RECORD,--record", record, "FILE.h5", "a record of swirl simulate: the orbit that it holds")
        ->group("Input");
    series.add_to(command, false);
    command
        .add_option("--noise", noise, "SIGMA",
                    "standard deviation of a series' noise, if known; of --angle in its unit")
        ->group("Input");
    transient_ = command.get_option("--transient");
    collisions_ = command.get_option("--collisions");
    threshold_ = command.get_option("--threshold");
    max_period_ = command.get_option("--max-period");
}

bool ClassifyInput::is_series(const SceneOptions& scene, const StartOptions& start) const {
    const bool from_series = !series.file.empty();  // then two flags of scene and start are the series'
    const bool from_scene =
        from_series ? scene.given("swirl-rate") || start.given_beside_angle() : scene.given() || start.given();
    if (!record.empty() && !series.file.empty()) throw BadInput("a record and --series are both given; give one");
    if (from_scene && !record.empty()) throw BadInput("a scene and a record are both given; give one");
    if (from_scene && !series.file.empty()) throw BadInput("a scene and --series are both given; give one");
    if (!series.file.empty()) return true;
    if (record.empty() || !is_series_record(record)) {
        if (series.given() || !series.rows.empty() || noise != 0)
            throw BadInput(fmt::format("{} is a series'; --series FILE is missing", series.given() ? series.flags()
                                                                                    : !series.rows.empty()
                                                                                        ? "--rows " + series.rows
                                                                                        : "--noise"));
        return false;
    }
    if (series.given())
        throw BadInput(fmt::format("{} says what of a file is a series; a record holds one", series.flags()));
    series.check();
    return true;
}

std::optional<RecordedOrbit> ClassifyInput::recorded(SceneOptions& scene, StartOptions& start) const {
    if (record.empty()) return std::nullopt;
    return recorded_orbit(record, transient_->number(), collisions_->number(), scene, start);
}

int classify_measured(const ClassifyInput& input, const SceneOptions& scene, const StartOptions& start,
                      const OutputOptions& output, bool verbose) {
    if (output.accuracy() != Accuracy::double_precision)
        throw BadInput(fmt::format("accuracy = {} is an orbit's that is followed", output.accuracy_name));
    InputOptions source;
    source.series = input.series;
    source.scene = scene;
    source.start = start;
    source.transient = input.transient_->number();
    source.collisions = input.collisions_->number();
    SeriesVerdict v;
    v.whole = input.record.empty() ? source.measured()
                                   : source.part_asked_for(read_series_record(input.record), input.record);
    if (!input.series.file.empty() && input.series.column.empty() && v.whole.quantity == as_measured &&
        names_angle(v.whole.column))
        throw BadInput(
            fmt::format("series '{}': column {} is an angle by its name, and S is its rate: --angle {} "
                        "takes that (of degrees with --degrees), --column {} the values as they stand",
                        input.series.file, v.whole.column, in_one_word(v.whole.column), in_one_word(v.whole.column)));
    warn_without_checksum(input.record, output.quiet);
    v.options.noise = input.noise * (input.series.degrees ? pi<double>() / 180 : 1);
    if (!(v.options.noise >= 0 && std::isfinite(v.options.noise)))
        throw BadInput(fmt::format("noise = {}: must be >= 0, finite", input.noise));
    const Stretch longest = longest_stretch(v.whole);  // a single sample has no steps to look at
    v.options.sampled_flow = is_sampled_flow(input, longest.count > 1 ? part_of(v.whole, longest) : v.whole);
    if (const auto threshold = input.threshold_->real()) v.options.recurrence_threshold = *threshold;
    if (const auto period = input.max_period_->number()) v.options.max_period = static_cast<int>(*period);
    std::optional<RecordWriter> record =
        open_record(output, "Mode of a measured series", {input.record, input.series.file});
    if (v.whole.quantity == spin_of_angle && v.options.sampled_flow)
        judge_angle(v);
    else
        judge_values(v);
    if (v.whole.quantity != distance_of_position)
        v.mean_errors = errors_of_series(v.verdict, v.used, v.options.sampled_flow);
    if (record) {
        write_to_record(record->root(), v);
        record->finish();
    }
    if (output.json)
        write_document(v);
    else if (!output.quiet)
        print_verdict(v, verbose);
    return exit_done;
}

}  // namespace swirl::apps::classify
