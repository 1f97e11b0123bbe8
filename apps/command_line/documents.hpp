// What every JSON document and every record states about its origin: version, scene, start, units.
#pragma once

#include "apps/command_line/scene_options.hpp"
#include "apps/command_line/start_options.hpp"
#include "apps/json/json_writer.hpp"
#include "apps/record/record_writer.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps {

/// The version and the instruction set that equal bits are promised for.
std::string version();
std::string instruction_set();

/// Named settings of a run, in the order in which they are written.
using Settings = std::vector<std::pair<std::string, AttributeValue>>;

/// The scene's parameters by the names of docs/command-line.md, "Scene"; sides is a number, or "disk".
Settings scene_settings(const Scene<double>& scene);

/// All names that it uses, in its order.
inline constexpr std::array<const char*, 14> scene_setting_names = {"sides",
                                                                    "alpha",
                                                                    "beta",
                                                                    "mu",
                                                                    "restitution",
                                                                    "law",
                                                                    "inertia_factor",
                                                                    "drag",
                                                                    "spin_drag",
                                                                    "floor_friction",
                                                                    "gravity_ratio",
                                                                    "floor",
                                                                    "tangential_restitution",
                                                                    "corner"};

/// A start in the laboratory, on the section, or at random (speed, seed).
Settings start_settings(const StartOptions& options, const Scene<double>& scene);
Settings unit_settings(const Units& units);
/// `name = value`, a line each.
std::string settings_text(const Settings& settings);

void write_json(JsonWriter& json, std::string_view key, const Settings& settings);
/// Settings as members of an open object.
void write_members(JsonWriter& json, const Settings& settings);
/// Members scene, start if there is one, and units if the scene was given in physical units.
void write_scene(JsonWriter& json, const Scene<double>& scene, const SceneOptions& options,
                 const StartOptions* start = nullptr);
void write_attributes(const RecordGroup& group, const Settings& settings);
/// Groups scene, and start if there is one.
void write_scene(const RecordGroup& root, const Scene<double>& scene, const StartOptions* start = nullptr);

/// Writes on standard output, or to the program for which the command runs (caller.hpp).
JsonWriter document_writer();

/// One JSON document there, its members written by a function; the version comes last.
template <class WriteMembers>
void print_document(const WriteMembers& write_all) {
    JsonWriter json = document_writer();
    json.begin_object(JsonLayout::rows);
    write_all(json);
    json.member("swirl_version", version());
    json.end_object();
    json.finish();
}

/// "hexagon α = 0.4 …" in one line, for tables and titles.
std::string scene_in_words(const Scene<double>& scene);

}  // namespace swirl::apps
