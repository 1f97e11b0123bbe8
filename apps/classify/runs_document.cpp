#include "apps/classify/runs_document.hpp"

#include "apps/branches/section_point.hpp"
#include "apps/modes/escape_document.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/modes/risk_document.hpp"
#include "apps/modes/steady_share_table.hpp"
#include "apps/modes/verdict_document.hpp"
#include "apps/output/points_in_words.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace swirl::apps::classify {

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
    for (const RiskEvidence& evidence : found.risk)
        fmt::print("{}\n", wrapped("  " + in_words(evidence, options.error), 4));
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
