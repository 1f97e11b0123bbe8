#include "apps/impacts/impact_fields.hpp"
#include "apps/input/orbit_columns.hpp"

#include "apps/command_line/numbers.hpp"
#include "apps/record/flag_text.hpp"
#include "apps/record/record_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace swirl::apps {

namespace {

Settings attributes_of(const RecordReader& record, const std::string& group) {
    Settings settings;
    if (!record.contains(group)) return settings;
    for (const auto& name : record.attributes(group)) settings.emplace_back(name, record.attribute(group, name));
    return settings;
}

template <class T>
T setting(const Settings& settings, const std::string& name, T otherwise) {
    for (const auto& [key, value] : settings)
        if (key == name)
            if (const T* typed = std::get_if<T>(&value)) return *typed;
    return otherwise;
}

/// As its flag would give it; in more digits than double the shortest decimal is the number that the user gave.
std::string required_text_of(const AttributeValue& value) {
    if (auto text = flag_text_of(value)) return *text;
    throw BadInput("record: a value of its scene or start is neither a number nor a word");
}

/// Whole settings or nothing: what HDF5 lists by name goes back into the order in which documents write it.
Settings in_order(const Settings& settings, const std::vector<std::string>& order) {
    Settings sorted;
    for (const auto& name : order)
        for (const auto& entry : settings)
            if (entry.first == name) sorted.push_back(entry);
    return sorted;
}

/// How many impacts a record leaves out. @throws BadInput if it says what simulate --skip can't
std::int64_t skipped_impacts(const RecordReader& record, const std::string& file) {
    const auto skip = setting<std::int64_t>(attributes_of(record, "/settings"), "skip", 0);
    if (skip < 0 || skip > most_impacts)
        throw BadInput(fmt::format("record '{}': skip = {} is outside its range: 0 to {}", file, skip, most_impacts));
    return skip;
}

/// @throws BadInput unless the dataset has one axis
std::int64_t rows_of(const RecordReader& record, const std::string& file, const std::string& path) {
    const auto shape = record.info(path).shape;
    if (shape.size() != 1) throw BadInput(fmt::format("record '{}': {} is not a column", file, path));
    return static_cast<std::int64_t>(shape[0]);
}

OrbitColumns columns_of(const RecordReader& record, const std::string& file, const ImpactRange& range,
                        const std::vector<std::string>& names) {
    if (!record.contains("/collisions") || record.datasets("/collisions").empty())
        throw BadInput(fmt::format("record '{}' holds no impacts; one that swirl simulate -o wrote is needed", file));
    OrbitColumns columns;
    columns.scene =
        in_order(attributes_of(record, "/scene"),
                 {"sides", "alpha", "beta", "mu", "restitution", "law", "inertia_factor", "drag", "spin_drag",
                  "floor_friction", "gravity_ratio", "floor", "tangential_restitution", "corner"});
    columns.start = in_order(attributes_of(record, "/start"),
                             {"speed", "seed", "x", "y", "vx", "vy", "angle", "spin", "psi", "chi", "vn", "vt", "S"});
    columns.units = in_order(attributes_of(record, "/units"), {"length", "time", "mass"});
    columns.beta = setting<double>(columns.scene, "beta", 0);
    columns.disk = setting<std::string>(columns.scene, "sides", "") == "disk";
    columns.every = setting<std::int64_t>(attributes_of(record, "/settings"), "every", 1);
    const Settings result = attributes_of(record, "/result");
    columns.outcome = setting<std::string>(result, "outcome", "completed");
    columns.impacts = setting<std::int64_t>(result, "impacts", 0);
    columns.accuracy = setting<std::string>(attributes_of(record, "/settings"), "accuracy", "double");
    columns.range.transient = skipped_impacts(record, file) + range.transient;
    if (record.contains("/contacts/t_start")) columns.contacts_listed = rows_of(record, file, "/contacts/t_start");
    require_observables(names, columns.disk);
    columns.names = names;
    for (const auto& name : names) {
        const std::string path = "/collisions/" + column_of_observable(name);
        if (!record.contains(path))
            throw BadInput(fmt::format("record '{}' holds no {}; its columns are: {}", file, name,
                                       fmt::join(record.datasets("/collisions"), ", ")));
        const std::int64_t rows = rows_of(record, file, path);
        const std::int64_t left = rows - range.transient;
        if (left < 1 || range.collisions > left)
            throw BadInput(fmt::format("record '{}' {}", file, lacking(rows, "impacts", range, 1)));
        const std::int64_t count = range.collisions < 0 ? left : range.collisions;
        columns.range.collisions = count;
        columns.values.push_back(record.read<double>(
            path, {{static_cast<std::uint64_t>(range.transient)}, {static_cast<std::uint64_t>(count)}}));
    }
    return columns;
}

}  // namespace

std::string lacking(std::int64_t rows, const std::string& what, const ImpactRange& range, std::int64_t fewest) {
    const std::int64_t wanted = std::max(range.collisions, fewest);
    const std::string then =
        range.collisions < 0 ? fmt::format("{} or more after these", wanted) : fmt::format("--collisions {}", wanted);
    return fmt::format("has {} {}; --transient {} and {} need {}", rows, what, range.transient, then,
                       range.transient + wanted);
}

OrbitColumns read_orbit(const std::string& file, const ImpactRange& range, const std::vector<std::string>& names) {
    try {
        return columns_of(RecordReader(file), file, range, names);
    } catch (const RecordError& error) {  // a named file that can't be read is bad input: no work has begun
        throw BadInput(fmt::format("{} (a text file of numbers is given with --series)", error.what()));
    }
}

void set_from_record(const OrbitColumns& record, SceneOptions& scene, StartOptions& start) {
    for (const auto& [name, value] : record.scene)
        scene.set(name == "inertia_factor"           ? "inertia-factor"
                  : name == "spin_drag"              ? "spin-drag"
                  : name == "floor_friction"         ? "floor-friction"
                  : name == "gravity_ratio"          ? "gravity-ratio"
                  : name == "tangential_restitution" ? "tangential-restitution"
                                                     : name,
                  required_text_of(value));
    std::string point;
    const bool on_section =
        std::any_of(record.start.begin(), record.start.end(), [](const auto& entry) { return entry.first == "psi"; });
    for (const auto& [name, value] : record.start) {
        if (on_section)
            point.append(point.empty() ? "" : ",").append(required_text_of(value));
        else
            start.set(name, required_text_of(value));
    }
    if (on_section) start.set("point", point);
}

OrbitColumns followed_again(const OrbitColumns& record, const OutputOptions& output,
                            const std::vector<std::string>& names) {
    SceneOptions scene;
    StartOptions start;
    set_from_record(record, scene, start);
    return follow_orbit(scene, start, output, record.range, names);
}

std::optional<Units> units_of(const OrbitColumns& orbit) {
    if (orbit.units.empty()) return std::nullopt;
    const auto unit = [&](const char* name) { return setting<double>(orbit.units, name, 1); };
    return Units{unit("length"), unit("time"), unit("mass")};
}

std::string unit_of_observables(const std::vector<std::string>& names) {
    std::string shared;
    for (const std::string& name : names) {
        std::string unit = "1";
        for (const auto& field : impact_fields)
            if (name == field.name) unit = field.units;
        if (!shared.empty() && shared != unit) return "1";
        shared = unit;
    }
    return shared;
}

void scale_columns(RecordWriter& record, const OrbitColumns& orbit) {
    if (const auto units = units_of(orbit))
        record.scale_units([units = *units](const std::string& of) { return physical_scale(units, of); });
}

}  // namespace swirl::apps
