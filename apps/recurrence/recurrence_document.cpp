#include "apps/recurrence/recurrence_document.hpp"

#include "apps/recurrence/convention_names.hpp"

#include <algorithm>
#include <cmath>

namespace swirl::apps::recurrence {

using analysis::recurrence::LineHistograms;
using analysis::recurrence::Measures;

namespace {

struct MeasureName {
    const char* name;
    double Measures::*member;
    const char* long_name;
};

constexpr std::array<MeasureName, 13> measure_names = {{
    {"RR", &Measures::RR, "recurrence rate"},
    {"DET", &Measures::DET, "determinism: share of the points in diagonal lines"},
    {"L", &Measures::L, "mean length of diagonal lines"},
    {"Lmax", &Measures::Lmax, "longest diagonal line"},
    {"DIV", &Measures::DIV, "divergence, 1 / Lmax"},
    {"ENTR", &Measures::ENTR, "entropy of the lengths of diagonal lines"},
    {"LAM", &Measures::LAM, "laminarity: share of the points in vertical lines"},
    {"TT", &Measures::TT, "trapping time: mean length of vertical lines"},
    {"Vmax", &Measures::Vmax, "longest vertical line"},
    {"VENTR", &Measures::VENTR, "entropy of the lengths of vertical lines"},
    {"MRT", &Measures::MRT, "mean recurrence time"},
    {"RTE", &Measures::RTE, "entropy of the recurrence times"},
    {"TREND", &Measures::TREND, "slope of the recurrence rate away from the main diagonal, per 1000 points"},
}};

struct NamedList {
    std::string name;
    std::vector<double> values;  ///< one a threshold
    std::string long_name;
};

std::vector<NamedList> lists_of(const Quantification& result) {
    std::vector<NamedList> lists;
    for (const auto& measure : measure_names) {
        lists.push_back({measure.name, {}, measure.long_name});
        for (const auto& m : result.measures) lists.back().values.push_back(m.*measure.member);
    }
    lists.push_back({"RC", result.rc, "the paper's recurrence rate, main diagonal counted"});
    lists.push_back({"RC_without_diagonal", result.rc_without_diagonal, "the same over pairs of different points"});
    return lists;
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
    if (cross) settings.emplace_back("cross_points", static_cast<std::int64_t>(report.cross->points.count));
    if (!options.period.empty()) settings.emplace_back("period", number_from<double>("period", options.period));
    return settings;
}

std::vector<std::string> notes_of(const RecurrenceReport& report) {
    std::vector<std::string> notes = report.points.notes;
    if (report.cross)
        for (const auto& note : report.cross->notes) notes.push_back("second series: " + note);
    if (report.result.thresholds.floored)
        notes.push_back("the observable is constant to rounding: the threshold is 1e-12 of its size");
    if (!report.points.enough) notes.push_back("the orbit ended before there was a pair of points");
    return notes;
}

void write_image(JsonWriter& json, const analysis::recurrence::Image& image) {
    json.key("image");
    json.begin_array(JsonLayout::rows);
    for (std::size_t a = 0; a < image.pixels; ++a) {
        json.begin_array();
        for (std::size_t b = 0; b < image.pixels; ++b) json.value(image.density[a * image.pixels + b]);
        json.end_array();
    }
    json.end_array();
}

/// Rows of a table of counts, as long as the longest: a threshold each.
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
    group.dimension(dimension, longest);
    group.write<std::int64_t>(name, {"threshold", dimension}, counts, {"1", long_name, {}});
}

}  // namespace

void write_json(const RecurrenceReport& report) {
    const auto& result = report.result;
    JsonWriter json(stdout);
    json.begin_object(JsonLayout::rows);
    if (report.points.orbit) write_orbit(json, *report.points.orbit);
    if (report.points.series) write_json(json, "series", series_settings(*report.points.series));
    if (!report.points.resampled.empty()) write_json(json, "resampled", report.points.resampled);
    if (report.cross && report.cross->series) write_json(json, "cross_series", series_settings(*report.cross->series));
    const bool single = result.thresholds.given.size() == 1;
    for (const auto& list : lists_of(result)) {
        if (single) {
            json.member(list.name, list.values.empty() ? std::nan("") : list.values.front());
            continue;
        }
        json.key(list.name);
        json.begin_array();
        for (const double value : list.values) json.value(value);
        json.end_array();
    }
    if (!single) {
        json.key("thresholds");
        json.begin_array();
        for (const double value : result.thresholds.delta) json.value(value);
        json.end_array();
    }
    if (result.image) write_image(json, *result.image);
    json.key("notes");
    json.begin_array(JsonLayout::rows);
    for (const auto& note : notes_of(report)) json.value(std::string_view(note));
    json.end_array();
    write_json(json, "settings", settings_of(report));
    json.member("swirl_version", std::string_view(version()));
    json.end_object();
    json.finish();
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
    if (result.lines.empty()) return;
    group.dimension("threshold", result.lines.size());
    group.write<double>("threshold", {"threshold"}, result.thresholds.delta,
                        {"1", "distance within which points recur", {}});
    for (const auto& list : lists_of(result))
        group.write<double>(list.name, {"threshold"}, list.values, {"1", list.long_name, {}});
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

void print_table(const RecurrenceReport& report) {
    const auto& result = report.result;
    if (report.points.orbit)
        fmt::print("{} after {} impacts\n", report.points.orbit->outcome, report.points.orbit->impacts);
    const auto line = [](const std::string& name, const std::vector<double>& values) {
        fmt::print("{:<22}", name);
        for (const double value : values) fmt::print(" {:>18.12g}", value);
        fmt::print("\n");
    };
    fmt::print("{:<22} {:>18}\n", "points", report.points.points.count);
    line("threshold", result.thresholds.delta);
    for (const auto& list : lists_of(result)) line(list.name, list.values);
    for (const auto& note : notes_of(report)) fmt::print("note: {}\n", note);
}

}  // namespace swirl::apps::recurrence
