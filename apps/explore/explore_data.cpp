#include "apps/explore/explore_data.hpp"

#include "apps/boundaries/starting_points_of_record.hpp"
#include "apps/command_line/documents.hpp"
#include "apps/command_line/errors.hpp"
#include "apps/command_line/scene_options.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/scene_map/start.hpp"
#include "map/model/body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <utility>

namespace swirl::apps::explore {

namespace {

/// Of a diagram; more are thinned evenly.
constexpr std::size_t most_samples = 60'000;

/// Random starts that the page offers, at least.
constexpr std::int64_t least_starts = 20;

/// Six digits are more than a screen shows; parameters keep all of theirs.
double rounded(double value) {
    if (!std::isfinite(value)) return value;
    const std::string digits = fmt::format("{:.6g}", value);
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

bool is_coordinate(const std::string& name, const DatasetInfo& info) {
    return name == "parameter" || info.dimensions == std::vector<std::string>{name} ||
           info.dimensions == std::vector<std::string>{"cell"};
}

/// Member `name`: dimensions, shape and values, with the names that integers stand for.
///   step  takes every so many-th row
void write_column(JsonWriter& json, const RecordReader& record, const std::string& group, const std::string& name,
                  std::size_t step = 1) {
    const std::string path = group + "/" + name;
    if (!record.contains(path)) return;
    const DatasetInfo info = record.info(path);
    json.key(name);
    json.begin_object();
    json.list("dimensions", info.dimensions);
    json.list("shape", info.shape);
    if (!info.description.flag_meanings.empty()) json.list("names", info.description.flag_meanings);
    json.key("values");
    json.begin_array();
    const auto write = [&](const auto& values, const auto& as) {
        for (std::size_t i = 0; i < values.size(); i += step) json.value(as(values[i]));
    };
    const auto same = [](const auto& value) { return value; };
    if (info.type == ElementType::string)
        write(record.read_strings(path), same);
    else if (info.type == ElementType::boolean)
        write(record.read<bool>(path), [](bool truth) { return truth ? 1 : 0; });
    else if (info.type != ElementType::float64)
        write(record.read<std::int64_t>(path), same);
    else if (is_coordinate(name, info))
        write(record.read<double>(path), same);
    else
        write(record.read<double>(path), rounded);
    json.end_array();
    json.end_object();
}

void write_group(JsonWriter& json, const RecordReader& record, const std::string& group,
                 const std::vector<std::string>& names, std::size_t step = 1) {
    if (!record.contains("/" + group)) return;
    json.key(group);
    json.begin_object();
    if (step > 1) json.member("every", step);
    for (const std::string& name : names) write_column(json, record, "/" + group, name, step);
    json.end_object();
}

Settings attributes_in(const RecordReader& record, const std::string& group) {
    Settings found;
    if (!record.contains(group)) return found;
    for (const auto& name : record.attributes(group)) found.emplace_back(name, record.attribute(group, name));
    return found;
}

std::optional<std::string> text_in(const Settings& settings, const std::string& name) {
    for (const auto& [key, value] : settings)
        if (key == name) return flag_text_of(value);
    return std::nullopt;
}

/// What of a sweep is drawn: its parameters, verdicts and means.
std::vector<std::string> columns_of_sweep(const RecordReader& record) {
    std::vector<std::string> names = record.info("/sweep/mean_S").dimensions;
    if (names == std::vector<std::string>{"cell"}) {
        names.clear();
        for (const char* name : {"alpha", "beta", "mu", "restitution", "inertia_factor", "sides", "law", "speed", "x",
                                 "y", "vx", "vy", "angle", "spin"})
            if (record.contains(std::string("/sweep/") + name)) names.emplace_back(name);
    }
    for (const char* name : {"mode", "share", "mean_S", "run_mode", "run_period", "run_mean_S", "visited"})
        names.emplace_back(name);
    return names;
}

/// What a record is drawn as; empty: as nothing.
std::string kind_of(const RecordReader& record) {
    if (record.contains("/sweep/run_mode") && record.contains("/sweep/mean_S")) return "map";
    if (record.contains("/curve_ends") && record.contains("/curves")) return "curves";
    const Settings settings = attributes_in(record, "/settings");
    const bool has_rows = record.contains("/samples/parameter") || record.contains("/branches/parameter");
    return has_rows && text_in(settings, "along") ? "diagram" : "";
}

std::size_t step_of_samples(const RecordReader& record) {
    if (!record.contains("/samples/column")) return 1;
    const std::uint64_t rows = record.info("/samples/column").shape.at(0);
    return std::max<std::size_t>(1, (rows + most_samples - 1) / most_samples);
}

void write_groups(JsonWriter& json, const RecordReader& record, const std::string& kind) {
    json.key("groups");
    json.begin_object(JsonLayout::rows);
    if (kind == "map") write_group(json, record, "sweep", columns_of_sweep(record));
    if (kind == "diagram") {
        write_group(json, record, "columns", {"parameter", "mode", "period"});
        write_group(json, record, "samples", {"column", "S", "value"}, step_of_samples(record));
        write_group(json, record, "shares", {"column", "mode", "period", "mean_S", "share"});
        write_group(json, record, "branches", {"parameter", "branch", "S", "value", "stable", "period"});
        write_group(json, record, "special", {"parameter", "kind", "S", "value", "period"});
    }
    if (kind == "curves") {
        write_group(json, record, "curves", {"curve", "first", "second"});
        write_group(json, record, "curve_ends", {"kind", "period"});
        write_group(json, record, "special", {"kind", "first", "second"});
    }
    json.end_object();
}

void write_record(JsonWriter& json, const RecordReader& record, const std::string& file, const std::string& kind) {
    json.begin_object(JsonLayout::rows);
    json.member("file", std::filesystem::path(file).filename().string());
    json.member("kind", kind);
    write_json(json, "record", attributes_in(record, "/"));
    write_json(json, "scene", attributes_in(record, "/scene"));
    write_json(json, "settings", attributes_in(record, "/settings"));
    write_groups(json, record, kind);
    json.end_object();
}

/// The scene's numbers as flags would give them, wherever a record has them.
Settings scene_in(const RecordReader& record) {
    Settings found = attributes_in(record, "/settings");
    for (auto& own : attributes_in(record, "/scene")) found.push_back(std::move(own));
    return found;
}

/// Numbers of sides that the record holds.
std::set<int> sides_in(const RecordReader& record, const std::string& file) {
    std::set<int> found;
    const auto add = [&](const std::string& text) {
        const int sides = sides_from(text);
        if (sides > Body<double>::table_limit)
            throw BadInput(fmt::format("record '{}': sides = {}: the map of a page takes at most {}", file, sides,
                                       Body<double>::table_limit));
        found.insert(sides);
    };
    if (record.contains("/sweep/sides")) {
        if (record.info("/sweep/sides").type == ElementType::string)
            for (const auto& text : record.read_strings("/sweep/sides")) add(text);
        else if (record.info("/sweep/sides").type == ElementType::float64)
            for (const double sides : record.read<double>("/sweep/sides")) add(fmt::format("{}", sides));
        else
            for (const auto sides : record.read<std::int64_t>("/sweep/sides")) add(fmt::format("{}", sides));
    }
    if (found.empty())
        if (const auto text = text_in(scene_in(record), "sides")) add(*text);
    if (found.empty()) throw BadInput(fmt::format("record '{}' does not say the number of sides", file));
    return found;
}

/// What the page's map does not work out itself, so that its bits are those of this program: κ, and the vertices'
/// directions with what rounding left out of them.
void write_bodies(JsonWriter& json, const std::set<int>& all) {
    json.key("bodies");
    json.begin_object(JsonLayout::rows);
    for (const int sides : all) {
        Scene<double> scene{.sides = sides, .alpha = 0.5, .inertia_factor = uniform_inertia_factor<double>(sides)};
        const Body<double> body = make_body(scene);
        json.key(sides == disk_sides ? "disk" : fmt::format("{}", sides));
        json.begin_object();
        json.member("inertia_factor", scene.inertia_factor);
        json.key("directions");
        json.begin_array();
        for (std::size_t k = 0; k < body.vertices.size(); ++k)
            for (const double number : {body.vertices[k].x, body.vertices[k].y, body.rests[k].x, body.rests[k].y})
                json.value(number);
        json.end_array();
        json.end_object();
    }
    json.end_object();
}

/// The directions (cos, sin) and orientations of the first random starts, which do not depend on the scene.
void write_starts(JsonWriter& json, const Settings& settings) {
    const auto number = [&](const char* name, double otherwise) {
        const auto text = text_in(settings, name);
        return text ? number_from<double>(name, *text) : otherwise;
    };
    const auto seed = static_cast<std::uint64_t>(number("seed", 1));
    const auto count = std::max(least_starts, static_cast<std::int64_t>(number("runs", number("starts", 1))));
    json.member("seed", seed);
    json.member("speed", number("speed", studies::paper_speed));
    json.key("starts");
    json.begin_array();
    for (std::uint64_t run = 0; run < static_cast<std::uint64_t>(count); ++run) {
        const LabStart<double> start = studies::random_start(0, 1, seed + run, 0);
        json.array(std::vector{start.vx, start.vy, start.angle});
    }
    json.end_array();
}

std::string along_of(const RecordReader& record, const char* axis) {
    return record_name(text_in(attributes_in(record, "/settings"), axis).value_or(""));
}

/// That curves lie in the plane of a sweep, of the same scene.
void require_same_plane(const RecordReader& map, const RecordReader& curves, const std::string& file) {
    const auto axes = map.info("/sweep/mean_S").dimensions;
    const std::vector<std::string> own{along_of(curves, "first"), along_of(curves, "second")};
    for (const auto& axis : own)
        if (std::find(axes.begin(), axes.end(), axis) == axes.end())
            throw BadInput(fmt::format("record '{}' has curves over {} and {}, which the sweep does not vary", file,
                                       own[0], own[1]));
    Settings scene;
    for (const char* name : {"sides", "alpha", "beta", "mu", "restitution", "law", "inertia_factor"})
        for (const auto& [key, value] : scene_in(map))
            if (key == name) scene.emplace_back(key, value);
    boundaries::require_same_scene(curves, fmt::format("record '{}'", file), "/scene", scene, axes);
}

/// The page's own map knows no drag, no dry friction of the floor, no tangential restitution, no rod and no rounded
/// corners.
void require_page_scene(const RecordReader& record, const std::string& file) {
    constexpr std::pair<const char*, const char*> unknown[] = {{"drag", "is of a floor that drags"},
                                                               {"floor_friction", "is of a floor with dry friction"},
                                                               {"tangential_restitution", "has tangential restitution"},
                                                               {"corner", "has rounded corners"}};
    const auto settings = attributes_in(record, "/settings"), scene = scene_in(record);
    const auto refuse = [&file](const char* words) {
        throw BadInput(fmt::format("record '{}' {}, to which the map of a page is not extended", file, words));
    };
    for (const auto& [name, words] : unknown)
        if (record.contains(fmt::format("/sweep/{}", name)) || text_in(settings, "along") == flag_name(name) ||
            text_in(scene, name) || text_in(settings, name))
            refuse(words);
    if (text_in(scene, "sides") == "2" || text_in(settings, "sides") == "2") refuse("is of a rod");
}

}  // namespace

PageData page_data(const std::vector<std::string>& files) {
    std::vector<RecordReader> records;
    std::vector<std::string> kinds;
    for (const std::string& file : files) {
        records.emplace_back(file);
        if (records.back().contains("/shard"))
            throw BadInput(fmt::format("record '{}' is a shard of a sweep: swirl join makes one record of all", file));
        require_page_scene(records.back(), file);
        kinds.push_back(kind_of(records.back()));
        if (kinds.back().empty())
            throw BadInput(
                fmt::format("record '{}' is of none that a page draws: sweep, join, bifurcate, continue, "
                            "boundaries",
                            file));
        if (records.size() == 1) continue;
        if (kinds.front() != "map" || kinds.back() != "curves")
            throw BadInput(
                fmt::format("record '{}': after the first, a record of sweep, come those of boundaries", file));
        require_same_plane(records.front(), records.back(), file);
    }
    PageData data{kinds.front(), {}};
    JsonWriter json(data.json);
    json.begin_object(JsonLayout::rows);
    json.member("swirl_version", version());
    json.key("records");
    json.begin_array(JsonLayout::rows);
    for (std::size_t i = 0; i < records.size(); ++i) write_record(json, records[i], files[i], kinds[i]);
    json.end_array();
    write_bodies(json, sides_in(records.front(), files.front()));
    write_starts(json, attributes_in(records.front(), "/settings"));
    json.end_object();
    json.finish();
    return data;
}

}  // namespace swirl::apps::explore
