#include "apps/input/input_options.hpp"

#include "apps/command_line/numbers.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace swirl::apps {

const char* const input_details =
    R"(What is analysed: the orbit of a scene (its flags, --transient, --collisions), a record that simulate -o wrote,
or --series FILE: a text file (- for standard input), a sample a line, as spreadsheets and trackers write it; `swirl
inspect FILE` says what it is taken for. The times are the column --time NAME (or its number from 1 on, or none), by
default the header's t or time, else one that rises and is named as times or frames (--fps F: frames a second), without
a header the first of several columns. The values are --column NAME, by default S or spin, else the last column that may
be one; or S of an angle (--angle COLUMN, or --marks X1 Y1 X2 Y2 or --mark X Y, over --swirl-rate W, radians per unit of
time or as 33rpm, 0.5Hz, negative if clockwise), or a distance (--position X Y). Times must rise; an empty cell, nan,
NA, inf or null is a gap, and so is a missing row between times that are otherwise even. Of a file of several bodies
--where COLUMN=VALUE takes one, --each COLUMN all.)";

void InputOptions::add_to(Flags& command) {
    scene.add_to(command);
    start.add_to(command);
    Flags input = command.under("Input");
    input.add_option("RECORD,--record", record, "FILE.h5", "a record that swirl simulate -o wrote");
    series.add_to(command, true);
    add_whole_number(input, "--transient", transient, "K", 0, 1'000'000'000,
                     "impacts (samples) left out first (scene: 10000, else 0)");
    add_whole_number(input, "--collisions", collisions, "K", 1, 1'000'000'000,
                     "impacts (samples) taken then (scene: 10000, else all)");
}

InputKind InputOptions::kind() const {
    const bool from_series = !series.file.empty();  // then two flags of scene and start are the series'
    const bool from_scene =
        from_series ? scene.given("swirl-rate") || start.given_beside_angle() : scene.given() || start.given();
    if (!record.empty() && !series.file.empty()) throw BadInput("a record and --series are both given; give one");
    if (from_scene && !record.empty()) throw BadInput("a scene and a record are both given; give one");
    if (from_scene && !series.file.empty()) throw BadInput("a scene and --series are both given; give one");
    if (series.file.empty() && (series.given() || !series.rows.empty()))
        throw BadInput(fmt::format("{} is a series'; --series FILE is missing",
                                   series.given() ? series.flags() : "--rows " + series.rows));
    if (!record.empty()) return InputKind::record;
    if (!series.file.empty()) return InputKind::series;
    if (!from_scene) throw BadInput("nothing to analyse: give a scene (--sides ...), a record, or --series FILE");
    return InputKind::scene;
}

ImpactRange InputOptions::range() const {
    if (kind() == InputKind::scene) return {transient.value_or(10'000), collisions.value_or(10'000)};
    return {transient.value_or(0), collisions.value_or(-1)};
}

OrbitColumns InputOptions::orbit(const OutputOptions& output, const std::vector<std::string>& names) {
    if (kind() == InputKind::record) return read_orbit(record, range(), names);
    scene.read_file(output.quiet);
    start.take_from(scene);
    return follow_orbit(scene, start, output, range(), names);
}

SeriesChoice whole_choice(const SeriesChoice& series, const SceneOptions& scene, const StartOptions& start) {
    SeriesChoice choice = series;
    choice.angle = start.angle_text();
    choice.set_swirl_rate(scene.flag("swirl-rate", "1"));
    return choice;
}

MeasuredSeries InputOptions::measured() const {
    return part_asked_for(read_series(whole_choice(series, scene, start)), series.file);
}

MeasuredSeries InputOptions::part_asked_for(const MeasuredSeries& whole, const std::string& name) const {
    if (!transient && !collisions) return whole;
    const auto rows = static_cast<std::int64_t>(whole.values.size());
    const std::int64_t first = transient.value_or(0);
    const std::int64_t count = collisions.value_or(rows - first);
    if (count < 2 || first + count > rows)
        throw BadInput(
            fmt::format("series '{}' {}", name, lacking(rows, "samples", {first, collisions.value_or(-1)}, 2)));
    return part_of(whole, static_cast<std::size_t>(first), static_cast<std::size_t>(count));
}

void write_orbit(JsonWriter& json, const OrbitColumns& orbit) {
    write_json(json, "scene", orbit.scene);
    write_json(json, "start", orbit.start);
    if (!orbit.units.empty()) write_json(json, "units", orbit.units);
    json.member("outcome", std::string_view(orbit.outcome));
    json.member("impacts", orbit.impacts);
}

void write_orbit(const RecordGroup& root, const OrbitColumns& orbit) {
    write_attributes(root.group("scene"), orbit.scene);
    write_attributes(root.group("start"), orbit.start);
    if (!orbit.units.empty()) write_attributes(root.group("units"), orbit.units);
    write_attributes(root.group("orbit"), {{"outcome", orbit.outcome}, {"impacts", orbit.impacts}});
}

Settings series_settings(const MeasuredSeries& s) {
    Settings settings = {{"column", s.column},
                         {"quantity", s.quantity},
                         {"time", s.time},
                         {"body", s.body},
                         {"origin", std::vector<double>(s.origin.begin(), s.origin.end())},
                         {"y_down", s.y_down},
                         {"rows", static_cast<std::int64_t>(s.rows)},
                         {"samples", static_cast<std::int64_t>(s.values.size())},
                         {"missing", static_cast<std::int64_t>(s.missing)},
                         {"gaps", static_cast<std::int64_t>(s.gaps)},
                         {"even", s.even},
                         {"spacing", s.spacing},
                         {"largest_step", s.largest_step},
                         {"largest_deviation", s.largest_deviation}};
    if (s.quantity == spin_of_angle || s.quantity == spin_of_rate) {
        settings.emplace_back("swirl_rate", s.swirl_rate);
        settings.emplace_back("clockwise", s.clockwise);
    }
    if (s.quantity == spin_of_angle) settings.emplace_back("largest_turn", s.largest_turn);
    settings.emplace_back("notes", s.notes);
    return settings;
}

bool is_series_record(const std::string& file) {
    try {
        const RecordReader record(file);
        return record.contains("/series/value") && !record.contains("/collisions");
    } catch (const RecordError& error) {
        throw BadInput(fmt::format("{} (a text file of numbers is given with --series)", error.what()));
    }
}

MeasuredSeries read_series_record(const std::string& file) {
    try {
        const RecordReader record(file);
        MeasuredSeries series;
        series.column = record.attribute<std::string>("/series", "column");
        series.time = record.attribute<std::string>("/series", "time");
        series.times = record.read<double>("/series/time");
        series.values = record.read<double>("/series/value");
        if (series.times.size() != series.values.size())
            throw BadInput(
                fmt::format("record '{}' has {} times of {} values", file, series.times.size(), series.values.size()));
        const auto falls = [](double a, double b) { return !(a <= b); };  // a time that is missing does, too
        if (std::adjacent_find(series.times.begin(), series.times.end(), falls) != series.times.end())
            throw BadInput(fmt::format("record '{}': the times of its series do not rise", file));
        series.rows = series.times.size();
        if (record.has_attribute("/series", "rows"))
            series.rows = static_cast<std::size_t>(record.attribute<std::int64_t>("/series", "rows"));
        if (record.has_attribute("/series", "quantity"))
            series.quantity = record.attribute<std::string>("/series", "quantity");
        if (record.has_attribute("/series", "swirl_rate"))
            series.swirl_rate = record.attribute<double>("/series", "swirl_rate");
        if (record.has_attribute("/series", "body")) {  // what older records lack
            series.body = record.attribute<std::string>("/series", "body");
            const auto origin = record.attribute<std::vector<double>>("/series", "origin");
            std::copy_n(origin.begin(), std::min<std::size_t>(origin.size(), 2), series.origin.begin());
            series.y_down = record.attribute<bool>("/series", "y_down");
        }
        if (record.has_attribute("/series", "clockwise"))
            series.clockwise = record.attribute<bool>("/series", "clockwise");
        if (record.has_attribute("/series", "notes"))
            series.notes = record.attribute<std::vector<std::string>>("/series", "notes");
        if (record.has_attribute("/series", "largest_turn"))
            series.largest_turn = record.attribute<double>("/series", "largest_turn");
        if (series.quantity == spin_of_angle) {
            series.angle.times = record.read<double>("/series/angle_time");
            series.angle.values = record.read<double>("/series/angle");
            series.angle.period = record.attribute<double>("/series", "angle_period");
            series.angle.resolution = record.attribute<double>("/series", "angle_resolution");
            if (series.angle.values.size() != series.values.size() + 1 ||
                series.angle.times.size() != series.angle.values.size())
                throw BadInput(fmt::format("record '{}' has {} angles of {} values of S: must be one more", file,
                                           series.angle.values.size(), series.values.size()));
        }
        return part_of(series, 0, series.values.size());
    } catch (const RecordError& error) {  // a named file that can't be read is bad input: no work has begun
        throw BadInput(error.what());
    }
}

void write_series(const RecordGroup& root, const MeasuredSeries& series) {
    const RecordGroup group = root.group("series");
    Settings settings = series_settings(series);
    if (series.notes.empty()) settings.pop_back();  // HDF5 has no empty list of texts
    write_attributes(group, settings);
    group.dimension("sample", series.values.size());
    group.write<double>("time", {"sample"}, series.times, {"1", "time, in the unit of the series", {}});
    group.write<double>("value", {"sample"}, series.values,
                        {"1", "measured values, in the unit of the series; NaN where missing", {}});
    if (series.angle.values.empty()) return;
    group.dimension("row", series.angle.values.size());
    group.write<double>("angle_time", {"row"}, series.angle.times, {"1", "time, in the unit of the series", {}});
    group.write<double>("angle", {"row"}, series.angle.values, {"rad", "angle as measured, NaN where missing", {}});
    write_attributes(group, {{"angle_period", series.angle.period}, {"angle_resolution", series.angle.resolution}});
}

}  // namespace swirl::apps
