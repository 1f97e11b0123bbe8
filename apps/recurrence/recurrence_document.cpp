#include "apps/recurrence/recurrence_document.hpp"

#include "apps/modes/verdict_in_words.hpp"
#include "apps/output/write_table.hpp"
#include "apps/recurrence/convention_names.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps::recurrence {

using analysis::recurrence::LineHistograms;
using analysis::recurrence::Measures;

namespace {

constexpr std::size_t counted_as_fast = 5000;  ///< points: all pairs take less time than random ones

/// The measures, a row a threshold.
Table<ThresholdResult> measure_table() {
    using F = Field<ThresholdResult>;
    const auto of = [](auto member) { return [member](const ThresholdResult& row) { return row.measures.*member; }; };
    return {{"threshold"},
            {F{"threshold", &ThresholdResult::delta, "1", "distance within which points recur"}.record_only(),
             {"RR", of(&Measures::RR), "1", "recurrence rate"},
             {"DET", of(&Measures::DET), "1", "determinism: share of the points in diagonal lines"},
             {"L", of(&Measures::L), "1", "mean length of diagonal lines"},
             {"Lmax", of(&Measures::Lmax), "1", "longest diagonal line"},
             {"DIV", of(&Measures::DIV), "1", "divergence, 1 / Lmax"},
             {"ENTR", of(&Measures::ENTR), "1", "entropy of the lengths of diagonal lines"},
             {"LAM", of(&Measures::LAM), "1", "laminarity: share of the points in vertical lines"},
             {"TT", of(&Measures::TT), "1", "trapping time: mean length of vertical lines"},
             {"Vmax", of(&Measures::Vmax), "1", "longest vertical line"},
             {"VENTR", of(&Measures::VENTR), "1", "entropy of the lengths of vertical lines"},
             {"MRT", of(&Measures::MRT), "1", "mean recurrence time"},
             {"RTE", of(&Measures::RTE), "1", "entropy of the recurrence times"},
             {"TREND", of(&Measures::TREND), "1",
              "slope of the recurrence rate away from the main diagonal, per 1000 points"},
             {"RC", &ThresholdResult::rc, "1", "recurrence rate of Sun 2019, main diagonal counted"},
             {"RC_without_diagonal", &ThresholdResult::rc_without_diagonal, "1",
              "the same over pairs of different points"}}};
}

/// Of an estimate: standard errors, as members named as the measures.
Settings errors_of(const RecurrenceReport& report) {
    const Measures& errors = report.result.sampled->errors;
    const double rc = report.result.results.front().rc, n = static_cast<double>(report.points.points.count);
    return {{"RR", errors.RR},
            {"DET", errors.DET},
            {"L", errors.L},
            {"LAM", errors.LAM},
            {"TT", errors.TT},
            {"RC", std::isnan(rc) ? std::nan("") : errors.RR * (n - 1) / n},
            {"RC_without_diagonal", std::isnan(rc) ? std::nan("") : errors.RR}};
}

Settings settings_of(const RecurrenceReport& report) {
    using namespace recurrence_names;
    const auto& options = report.options;
    const auto& s = report.result.conventions;
    const auto& thresholds = report.result.thresholds;
    const ImpactRange range = options.input.range();
    Settings settings;
    if (report.points.orbit) {
        settings = {{"observable", options.observables},
                    {"every", report.points.orbit->every},
                    {"accuracy", options.output.accuracy_name}};
    }
    settings.emplace_back("transient", range.transient);
    if (range.collisions >= 0) settings.emplace_back("collisions", range.collisions);
    const auto one_or_all = [&](const std::string& name, const std::vector<double>& values) {
        if (values.size() == 1)
            settings.emplace_back(name, values.front());
        else if (!values.empty())
            settings.emplace_back(name, values);
    };
    one_or_all("threshold", thresholds.delta);
    if (thresholds.kind != "threshold") one_or_all(thresholds.kind, thresholds.given);
    if (thresholds.floored) settings.emplace_back("threshold_is_rounding_floor", true);
    const bool cross = report.cross.has_value();
    const Settings rest = {
        {"dimension", std::int64_t{options.dimension}},
        {"delay", std::int64_t{options.delay}},
        {"norm", word_of(s.norm, norms)},
        {"theiler", std::int64_t{analysis::recurrence::theiler_window(s, cross)}},
        {"min_diagonal", std::int64_t{s.min_diagonal}},
        {"min_vertical", std::int64_t{s.min_vertical}},
        {"strict", s.strict},
        {"convention", options.conventions.convention.empty() ? "swirl" : options.conventions.convention},
        {"rate_pairs", word_of(s.rate_pairs, pairs)},
        {"recurrence_time", word_of(s.recurrence_time, times)},
        {"triangles", word_of(s.triangles, triangle_choices)},
        {"border_lines", word_of(s.border_lines, borders)},
        {"logarithm", word_of(s.logarithm, logarithms)},
        {"cross", cross},
        {"points", static_cast<std::int64_t>(report.points.points.count)},
        {"points_left_out", static_cast<std::int64_t>(report.points.left_out)}};
    settings.insert(settings.end(), rest.begin(), rest.end());
    if (options.sampled_pairs > 0) {
        settings.emplace_back("sample_pairs", options.sampled_pairs);
        settings.emplace_back("sample_seed", options.sample_seed);
    }
    if (cross) settings.emplace_back("cross_points", static_cast<std::int64_t>(report.cross->points.count));
    if (report.points.series) settings.emplace_back("join_gaps", options.join_gaps);
    if (!options.period.empty()) settings.emplace_back("period", number_from<double>("period", options.period));
    return settings;
}

std::vector<std::string> notes_of(const RecurrenceReport& report) {
    std::vector<std::string> notes = report.points.notes;
    if (report.cross)
        for (const auto& note : report.cross->notes) notes.push_back("second series: " + note);
    if (report.result.thresholds.floored)
        notes.push_back(
            "the observable is constant to rounding: every pair recurs, the threshold is 1e-12 of its size");
    if (report.result.sampled)
        notes.push_back(
            fmt::format("estimated from {} random pairs, of which {} recur; Lmax, DIV, ENTR, Vmax, VENTR, MRT, RTE and "
                        "TREND need all pairs",
                        report.result.sampled->pairs, report.result.sampled->recurrent));
    if (report.result.sampled && report.points.points.count <= counted_as_fast)
        notes.push_back(fmt::format("all pairs of {} points are counted as fast, and exactly: leave out --sample-pairs",
                                    report.points.points.count));
    if (!report.points.enough) notes.push_back("the orbit ended before there was a pair of points");
    return notes;
}

void write_image(JsonWriter& json, const analysis::recurrence::Image& image) {
    json.key("image");
    json.begin_array(JsonLayout::rows);
    for (std::size_t a = 0; a < image.pixels; ++a)
        json.array(std::span(image.density).subspan(a * image.pixels, image.pixels));
    json.end_array();
}

/// Rows of a table of counts, as long as the longest, a threshold each; the place is the length, from 0.
void write_counts(const RecordGroup& group, const char* name, const char* dimension, const char* long_name,
                  const std::vector<LineHistograms>& lines, std::vector<std::uint64_t> LineHistograms::*member) {
    std::size_t longest = 1;
    for (const auto& l : lines) longest = std::max(longest, (l.*member).size());
    std::vector<std::int64_t> counts;
    for (const auto& l : lines) {
        const auto& histogram = l.*member;
        for (std::size_t i = 0; i < longest; ++i)
            counts.push_back(i < histogram.size() ? static_cast<std::int64_t>(histogram[i]) : 0);
    }
    std::vector<std::int64_t> lengths(longest);
    std::iota(lengths.begin(), lengths.end(), std::int64_t{0});
    group.dimension(dimension, longest);
    group.write<std::int64_t>(dimension, {dimension}, lengths, {"1", "in points of the series", {}});
    group.write<std::int64_t>(name, {"threshold", dimension}, counts, {"1", long_name, {}});
}

}  // namespace

void write_json(const RecurrenceReport& report) {
    const auto& result = report.result;
    print_document([&](JsonWriter& json) {
        if (report.points.orbit) write_orbit(json, *report.points.orbit);
        if (report.points.series) write_json(json, "series", series_settings(*report.points.series));
        if (!report.points.resampled.empty()) write_json(json, "resampled", report.points.resampled);
        if (report.cross && report.cross->series)
            write_json(json, "cross_series", series_settings(*report.cross->series));
        if (result.thresholds.given.size() != 1) {
            write_lists(json, measure_table(), result.results);
            json.list("thresholds", result.thresholds.delta);
        } else if (!result.results.empty()) {
            write_members(json, measure_table(), result.results.front());
        } else {
            for (const auto& field : measure_table().fields)
                if (field.in_json) json.member(field.name, std::nan(""));
        }
        if (result.sampled) {
            write_json(json, "standard_errors", errors_of(report));
            json.member("pairs_sampled", static_cast<std::int64_t>(result.sampled->pairs));
            json.member("pairs_recurrent", static_cast<std::int64_t>(result.sampled->recurrent));
        }
        if (result.image) write_image(json, *result.image);
        json.list("notes", notes_of(report), JsonLayout::rows);
        write_json(json, "settings", settings_of(report));
    });
}

void write_record(const RecordGroup& root, const RecurrenceReport& report) {
    const auto& result = report.result;
    if (report.points.orbit) write_orbit(root, *report.points.orbit);
    if (report.points.series) write_series(root, *report.points.series);
    if (!report.points.resampled.empty()) write_attributes(root.group("resampled"), report.points.resampled);
    if (report.cross && report.cross->series) write_series(root.group("cross"), *report.cross->series);
    write_attributes(root.group("settings"), settings_of(report));
    const RecordGroup group = root.group("recurrence");
    group.attribute("notes", fmt::format("{}", fmt::join(notes_of(report), "; ")));
    if (result.sampled) {
        apps::write_record(group, measure_table(), result.results);
        write_attributes(root.group("standard_errors"), errors_of(report));
        return;
    }
    if (result.lines.empty()) return;
    apps::write_record(group, measure_table(), result.results);
    write_counts(group, "diagonal_lines", "diagonal_length", "number of diagonal lines by length", result.lines,
                 &LineHistograms::diagonal);
    write_counts(group, "vertical_lines", "vertical_length", "number of vertical lines by length", result.lines,
                 &LineHistograms::vertical);
    write_counts(group, "recurrence_times", "recurrence_time", "number of recurrence times by time", result.lines,
                 &LineHistograms::recurrence_time);
    if (!result.image) return;
    group.dimension("row", result.image->pixels);
    group.dimension("column", result.image->pixels);
    group.write<double>("image", {"row", "column"}, result.image->density,
                        {"1", "recurrence plot: share of recurrent pairs in each cell", {}});
}

namespace {

/// A measure's value; of one that is estimated with its error, in as many digits as that leaves.
std::string measure_in_words(const RecurrenceReport& report, const std::string& measure, double value) {
    if (report.result.sampled)
        for (const auto& [name, error] : errors_of(report))
            if (const auto* number = std::get_if<double>(&error); name == measure && number && std::isfinite(*number))
                return with_error(value, *number);
    return std::isnan(value) ? "-" : fmt::format("{:.12g}", value);
}

}  // namespace

void print_table(const RecurrenceReport& report) {
    const auto& result = report.result;
    if (report.points.orbit)
        fmt::print("{} after {} impacts\n", report.points.orbit->outcome, report.points.orbit->impacts);
    if (report.points.series)
        fmt::print("series: {}\n{}", series_in_words(*report.points.series), notes_in_lines(*report.points.series));
    fmt::print("{:<22} {:>18}\n{:<22}", "points", report.points.points.count, "threshold");
    const auto units = units_of(report.points);
    const std::string unit = unit_of(report.points);
    for (const double value : result.thresholds.delta) fmt::print(" {:>18.12g}", in_units(value, units, unit));
    if (units) fmt::print(" {}", unit_label(unit));
    for (const auto& field : measure_table().fields) {
        if (!field.in_json) continue;
        fmt::print("\n{:<22}", field.name);
        for (const auto& row : result.results)
            fmt::print(" {:>18}", measure_in_words(report, field.name, std::get<double>(field.read(row))));
    }
    fmt::print("\n");
    for (const auto& note : notes_of(report)) fmt::print("note: {}\n", note);
}

}  // namespace swirl::apps::recurrence
