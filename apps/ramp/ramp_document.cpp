#include "apps/branches/branch_document.hpp"
#include "apps/modes/mode_fields.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/ramp/ramp_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::ramp {

namespace {

/// A mode with the end of its branch, if branches were continued.
struct ModeRow {
    const RampMode* mode;
    const BranchEnd* end;
};

std::vector<ModeRow> modes_of(const RampResult& result) {
    std::vector<ModeRow> rows;
    for (std::size_t i = 0; i < result.ramp.modes.size(); ++i)
        rows.push_back({&result.ramp.modes[i], result.branches ? &result.branches->ends[i] : nullptr});
    return rows;
}

/// Per 1/ω_s, or as it is given beside physical units: per second.
std::string rate_in_words(double rate, const std::optional<Units>& units) {
    return fmt::format("{:.3g}{}", in_units(rate, units, "omega_s"), units ? " per s" : "");
}

/// Which way the parameter goes.
template <class Row, class Reader>
Field<Row> direction_field(Reader rising) {
    return Field<Row>{"direction", [rising](const Row& row) { return std::string(rising(row) ? "up" : "down"); }, "",
                      "up where the parameter rises, down where it falls"}
        .flags({"up", "down"});
}

Table<RampWindow> window_table(const std::string& along, bool disk) {
    using Row = RampWindow;
    using F = Field<Row>;
    const auto coordinate = [](auto member) { return [member](const Row& row) { return row.last.*member; }; };
    using Point = SectionPoint<double>;
    const auto rising = [](const Row& row) { return row.rising; };
    return {
        {"window"},
        {F{"way", &Row::way, "1", "number of the way, from 0: there, back, there"}.shown("way", " {:>3}"),
         direction_field<Row>(rising).shown("", "  {:<4}"),
         F{"parameter", &Row::parameter, "1", "parameter " + along + " in the middle of the window"}.shown(
             along, "  {:>13.9g}"),
         F{"begin", &Row::begin, "1/omega_s", "when it began, from the end of the transient on"},
         F{"end", &Row::end, "1/omega_s", "when it ended"},
         F{"impacts", &Row::impacts, "1", "impacts in it; chatter that lands counts as one"}.shown("impacts", " {:>9}"),
         F{"mean_S", &Row::mean_spin, "1", "time mean of S over its flights"}.shown("mean S", "  {:>13.8g}"),
         F{"mean_S_error", [](const Row& row) { return row.error.standard_error; }, "1",
           "standard error of mean_S along the orbit"}
             .shown("error", " {:>8.1e}"),
         period_field<Row>([](const Row& row) { return row.period; }, "that was kept all through it, 0: none")
             .shown("period", dash_for_zero(" {:>7}")),
         F{"lag", &Row::lag, "1", "the parameter is behind by this at most"},
         F{"taken_along", &Row::taken, "1", "impacts after which the wall, moved, took the body along"},
         F{"psi", coordinate(&Point::psi), "rad", "psi after its last impact"},
         F{"chi", coordinate(&Point::chi), "rad", "chi after its last impact"}.when(!disk),
         F{"vn", coordinate(&Point::vn), "R_c omega_s", "vn after its last impact"},
         F{"vt", coordinate(&Point::vt), "R_c omega_s", "vt after its last impact"},
         F{"S", coordinate(&Point::spin), "1", "S after its last impact"}},
        {"parameter", "mean_S", "mean_S_error", "way", "direction", "period", "impacts"}};
}

Table<RampSample> sample_table(const std::string& along, bool disk) {
    using Row = RampSample;
    using F = Field<Row>;
    using Point = SectionPoint<double>;
    const auto coordinate = [](auto member) { return [member](const Row& row) { return row.point.*member; }; };
    const auto rising = [](const Row& row) { return row.rising; };
    return {{"sample"},
            {F{"parameter", &Row::parameter, "1", "parameter " + along + " at the impact"},
             F{"S", coordinate(&Point::spin), "1", "S just after the impact"},
             F{"psi", coordinate(&Point::psi), "rad", "psi just after the impact"},
             F{"chi", coordinate(&Point::chi), "rad", "chi just after the impact"}.when(!disk),
             F{"vn", coordinate(&Point::vn), "R_c omega_s", "vn just after the impact"},
             F{"vt", coordinate(&Point::vt), "R_c omega_s", "vt just after the impact"},
             F{"t", &Row::t, "1/omega_s", "when it was, from the end of the transient on"},
             F{"way", &Row::way, "1", "number of the way, from 0"}, direction_field<Row>(rising)}};
}

Table<ModeRow> mode_table(const std::string& along, bool branches) {
    using Row = ModeRow;
    using F = Field<Row>;
    const auto of = [](auto member) { return [member](const Row& row) { return row.mode->*member; }; };
    const auto at = [](auto member) { return [member](const Row& row) { return row.end->*member; }; };
    const auto left = [](double RampMode::*member) {
        return [member](const Row& row) { return row.mode->left ? row.mode->*member : std::nan(""); };
    };
    const auto rising = [](const Row& row) { return row.mode->rising; };
    Table<Row> table{
        {"mode"},
        {F{"way", of(&RampMode::way), "1", "number of the way on which it was left, or of the last"}.shown("way",
                                                                                                           " {:>3}"),
         direction_field<Row>(rising).shown("", "  {:<4}"),
         period_field<Row>(of(&RampMode::period), "of the mode").shown("period", " {:>6}"),
         F{"kept_from", of(&RampMode::kept_from), "1", "parameter " + along + " where it was seen to be kept"}.shown(
             "kept from", " {:>10.7g}"),
         F{"left_at", left(&RampMode::left_at), "1", "parameter " + along + " where it was left; NaN: it was not"}
             .shown("left at", " {:>11.8g}"),
         F{"kept_time", of(&RampMode::kept_at), "1/omega_s", "when it was seen to be kept"},
         F{"left_time", left(&RampMode::time), "1/omega_s", "when it was left; NaN: it was not"},
         F{"impacts", of(&RampMode::impact), "1", "impacts from the beginning of the ramp until then"},
         F{"round", of(&RampMode::round), "1/omega_s", "duration of its last round"},
         F{"mean_S", of(&RampMode::mean_spin), "1", "time mean of S over its last round"}.shown("mean S",
                                                                                                " {:>10.6g}")},
        {"left_at", "kept_from", "period", "way", "direction", "mean_S"}};
    if (!branches) return table;
    table.fields.push_back(
        F{"end", at(&BranchEnd::kind), "", "where the mode's branch ends on the way; empty: no branch"}.shown(
            "branch's end", "  {:<14}"));
    table.fields.push_back(
        F{"end_at", at(&BranchEnd::parameter), "1", "parameter " + along + " there"}.shown("at", " {:>11.8g}"));
    table.fields.push_back(F{"delay", at(&BranchEnd::delay), "1",
                             "how far beyond it the mode was left; < 0: before; NaN: the branch goes on"}
                               .shown("delay", " {:>9.2e}"));
    table.fields.push_back(F{"predicted_delay", at(&BranchEnd::predicted), "1",
                             "of a fold, to first order, where a round moves by the tolerance"}
                               .shown("predicted", " {:>9.2e}"));
    return table;
}

std::string flag_name(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

/// The scene without the parameter that varies.
Settings ramp_scene(const RampSettings& settings) {
    Settings scene;
    for (const auto& item : scene_settings(settings.scene))
        if (item.first != flag_name(settings.along.name)) scene.push_back(item);
    return scene;
}

Settings ramp_settings(const RampOptions& options, const RampSettings& settings) {
    Settings all = {{"along", settings.along.name},
                    {"range", options.along},
                    {"begin", settings.begin()},
                    {"end", settings.end()},
                    {"duration", settings.duration},
                    {"rate", settings.rate()},
                    {"ways", settings.ways},
                    {"windows", settings.windows},
                    {"samples", settings.samples},
                    {"transient", settings.transient},
                    {"longest_period", std::int64_t{settings.period.longest}},
                    {"tolerance", settings.period.tolerance},
                    {"branches", std::int64_t{options.branches}},
                    {"accuracy", options.output.accuracy_name}};
    add_noise_settings(all, settings.noise);
    return all;
}

/// In the scene where the ramp begins.
Settings ramp_start(const RampOptions& options, const RampSettings& settings) {
    return start_settings(options.start, with_parameter(settings.scene, *settings.along.parameter, settings.begin()));
}

std::string outcome_of(const Ramp& ramp) {
    return ramp.interrupted ? "interrupted" : std::string(name_of(ramp.outcome));
}

Settings result_of(const Ramp& ramp) {
    return {
        {"outcome", outcome_of(ramp)}, {"impacts", ramp.impacts}, {"time", ramp.time}, {"parameter", ramp.parameter}};
}

}  // namespace

void write_ramp_document(const RampOptions& options, const RampResult& result) {
    const RampSettings& settings = result.settings;
    const bool disk = settings.scene.is_disk();
    print_document([&](JsonWriter& json) {
        write_json(json, "scene", ramp_scene(settings));
        write_json(json, "start", ramp_start(options, settings));
        if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
        json.member("along", settings.along.name);
        write_json(json, "windows", window_table(settings.along.name, disk), result.ramp.windows);
        write_json(json, "modes", mode_table(settings.along.name, options.branches), modes_of(result));
        if (result.branches) write_branches(json, result.branches->scene, result.branches->branches);
        json.member("outcome", outcome_of(result.ramp));
        write_json(json, "result", result_of(result.ramp));
        write_json(json, "settings", ramp_settings(options, settings));
    });
}

void write_ramp_record(RecordWriter& record, const RampOptions& options, const RampResult& result) {
    const RampSettings& settings = result.settings;
    const bool disk = settings.scene.is_disk();
    const RecordGroup root = record.root();
    write_attributes(root.group("scene"), ramp_scene(settings));
    write_attributes(root.group("start"), ramp_start(options, settings));
    write_attributes(root.group("settings"), ramp_settings(options, settings));
    write_attributes(root.group("result"), result_of(result.ramp));
    if (!result.ramp.windows.empty()) {
        write_record(root.group("windows"), window_table(settings.along.name, disk), result.ramp.windows);
        write_record(root.group("samples"), sample_table(settings.along.name, disk), result.ramp.samples);
    }
    if (!result.ramp.modes.empty())
        write_record(root.group("modes"), mode_table(settings.along.name, options.branches), modes_of(result));
    if (result.branches) write_branches(root, result.branches->scene, result.branches->branches);
    record.finish();
}

void print_ramp(const RampOptions& options, const RampResult& result) {
    const RampSettings& settings = result.settings;
    const std::string& along = settings.along.name;
    const auto units = options.scene.units();
    const std::size_t every = (result.ramp.windows.size() + 99) / 100;  // a hundred or fewer are listed
    std::vector<RampWindow> windows;
    for (std::size_t i = 0; i < result.ramp.windows.size(); i += every) windows.push_back(result.ramp.windows[i]);
    fmt::print("{}", units_in_words(units));
    if (windows.empty())
        fmt::print("no window was finished\n");
    else
        print_table(in_units(window_table(along, settings.scene.is_disk()), units), windows);
    if (every > 1) fmt::print("one in {} of {} windows is listed (--json, -o)\n", every, result.ramp.windows.size());
    if (!result.ramp.modes.empty()) {
        fmt::print("modes that were kept:\n");
        print_table(in_units(mode_table(along, options.branches), units), modes_of(result));
    }
    const std::string ending =
        fmt::format("{}; {} impacts in {}, {} from {:g} to {:.10g} at a rate of {}", outcome_of(result.ramp),
                    result.ramp.impacts, with_unit(result.ramp.time, units, "1/omega_s"), along, settings.begin(),
                    result.ramp.parameter, rate_in_words(settings.rate(), units));
    fmt::print("{}\n", wrapped(ending, 4));
}

}  // namespace swirl::apps::ramp
