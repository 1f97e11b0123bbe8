#include "apps/classify/classify_series.hpp"

#include "analysis/classification/classify_angle.hpp"
#include "analysis/classification/classify_series.hpp"
#include "apps/command_line/record_input.hpp"
#include "apps/command_line/record_output.hpp"
#include "apps/input/input_options.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/output/write_table.hpp"
#include "apps/record/record_reader.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace swirl::apps::classify {

const char* const classify_series_details =
    R"(Of a record of simulate the orbit that it holds is judged: its second half, or all of it if --skip left out its
beginning, unless --transient and --collisions say which impacts. A measured series (--series, or a record without a
scene) is judged without the map: does it repeat within its noise, are there
lines in its spectrum, is it predicted better than noise and do neighbours part at a rate that all embeddings
agree on? Little or disagreeing evidence gives undecided. With --noise SIGMA a constant with noise is known for
steady. The longest segment without a gap counts.)";

namespace {

/// The longest run of samples without a gap.
MeasuredSeries longest_stretch(const MeasuredSeries& series) {
    std::size_t best = 0, best_begin = 0, begin = 0;
    for (std::size_t i = 0; i <= series.values.size(); ++i) {
        if (i < series.values.size() && !std::isnan(series.values[i])) continue;
        if (i - begin > best) best = i - begin, best_begin = begin;
        begin = i + 1;
    }
    return part_of(series, best_begin, best);
}

/// S holds from one impact to the next.
double time_mean(const MeasuredSeries& series) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < series.values.size(); ++i)
        sum += series.values[i] * (series.times[i + 1] - series.times[i]);
    return sum / (series.times.back() - series.times.front());
}

struct SeriesVerdict {
    MeasuredSeries whole, used;
    analysis::ClassifySeriesOptions options;
    analysis::Classification verdict;
};

Table<SeriesVerdict> verdict_table(const SeriesVerdict& v) {
    using Verdict = analysis::Classification;
    const double none = Verdict::unknown, spacing = v.used.spacing;
    const bool flow = v.options.sampled_flow;
    const auto of = [](auto member) { return [member](const SeriesVerdict& row) { return row.verdict.*member; }; };
    const auto per_time = [&](double Verdict::*member) {
        return [=](const SeriesVerdict& row) { return flow ? row.verdict.*member / spacing : none; };
    };
    const auto per_impact = [&](double Verdict::*member) {
        return [=](const SeriesVerdict& row) { return flow ? none : row.verdict.*member; };
    };
    return {{},
            {{"mode", of(&Verdict::mode)},
             kind_field<SeriesVerdict>(of(&Verdict::kind)),
             period_field<SeriesVerdict>(of(&Verdict::period)),
             {"mean_S",
              [=](const SeriesVerdict& row) {
                  if (row.whole.quantity == distance_of_position) return none;
                  return flow ? row.verdict.mean : row.used.time.empty() ? none : time_mean(row.used);
              }},
             {"mean_S_per_impact", per_impact(&Verdict::mean_per_step)},
             {"recurrence_rate", of(&Verdict::recurrence_rate)},
             {"recurrence_rate_without_diagonal", of(&Verdict::recurrence_rate_without_diagonal)},
             {"largest_exponent", per_impact(&Verdict::largest_exponent)},
             {"largest_exponent_error", per_impact(&Verdict::largest_exponent_error)},
             {"largest_exponent_per_time", per_time(&Verdict::largest_exponent)},
             {"largest_exponent_per_time_error", per_time(&Verdict::largest_exponent_error)}}};
}

std::string rows_of(const SeriesVerdict& v) {
    return v.options.sampled_flow ? "samples" : "impacts";
}

Settings settings_of(const SeriesVerdict& v) {
    return {{"rows", rows_of(v)},
            {"samples_used", static_cast<std::int64_t>(v.used.values.size())},
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

void print_verdict(const SeriesVerdict& v, bool verbose) {
    fmt::print("series: {}; rows are {}, {} used\n  {}\n  {}\n  because: {}\n", series_in_words(v.whole), rows_of(v),
               v.used.values.size(), mode_in_words(v.verdict), sureness_in_words(v.verdict),
               reason_in_words(v.verdict));
    if (verbose) fmt::print("{}{}", lines_of(verdict_table(v), v), table_of(v.verdict.evidence));
}

/// Of an angle from the angle itself, whose differences its S are; 0 at the first row.
analysis::Classification verdict_of(const SeriesVerdict& v) {
    const bool enough = v.used.values.size() + 1 >= analysis::fewest_angles;
    if (v.whole.quantity != spin_of_angle || !v.used.even || !enough)
        return analysis::classify_series(v.used.values, v.options);
    const double spacing = v.used.spacing * v.used.swirl_rate;
    std::vector<double> angle{0};
    for (const double spin : v.used.values) angle.push_back(angle.back() + spin * spacing);
    return analysis::classify_angle(angle, spacing, v.options);
}

bool is_sampled_flow(const ClassifyInput& input, const MeasuredSeries& series) {
    if (input.rows == "samples") return true;
    if (input.rows == "impacts") return false;
    if (!input.rows.empty()) throw BadInput(fmt::format("rows = '{}' is none of: impacts, samples", input.rows));
    return series.is_motion() || (!series.time.empty() && series.even);
}

}  // namespace

void ClassifyInput::add_to(Flags& command) {
    command.add_option("RECORD,--record", record, "a record of swirl simulate: the orbit that it holds")
        ->type_name("FILE.h5")
        ->group("Input");
    series.add_to(command, false);
    command.add_option("--rows", rows, "of a series: impacts, or samples in time (default: samples if times are even)")
        ->type_name("NAME")
        ->group("Input");
    command.add_option("--noise", noise, "standard deviation of a series' noise, if known; of --angle in its unit")
        ->type_name("SIGMA")
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
        if (series.given() || !rows.empty() || noise != 0)
            throw BadInput(
                "--column, --position, --time, --degrees, --symmetry, --rows and --noise are a series'; --series FILE "
                "is missing");
        return false;
    }
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
    v.whole = input.record.empty() ? source.measured() : read_series_record(input.record);
    warn_without_checksum(input.record, output.quiet);
    v.used = longest_stretch(v.whole);
    v.options.noise = input.noise * (input.series.degrees ? pi<double>() / 180 : 1);
    v.options.sampled_flow = is_sampled_flow(input, v.used);
    if (const auto threshold = input.threshold_->real()) v.options.recurrence_threshold = *threshold;
    if (const auto period = input.max_period_->number()) v.options.max_period = static_cast<int>(*period);
    std::optional<RecordWriter> record =
        open_record(output, "Mode of a measured series", {input.record, input.series.file});
    v.verdict = verdict_of(v);
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
